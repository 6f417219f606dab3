// What tables and figures call families and algorithms.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "harness/report/cells.h"

namespace mwt {

/// Short names: "patch" where a study has one configuration of it; else with the parameters in which its configurations
/// differ, "patch k=14". A configuration with more runs than every other one of the name keeps the bare name. Point
/// files are called by their names.
class Labels {
 public:
  explicit Labels(const std::vector<Cell>& cells);

  /// Precondition: the key is that of a cell, or of its series.
  [[nodiscard]] std::string family(const CellKey& key) const;
  [[nodiscard]] std::string algorithm(const CellKey& key) const;

 private:
  using Configuration = std::pair<std::string, std::string>;  // name, parameters

  std::map<Configuration, std::string> families_;
  std::map<Configuration, std::string> algorithms_;
};

}  // namespace mwt
