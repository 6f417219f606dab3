// What tables call families and algorithms: the name alone, or with its parameters where a study has several of them;
// point files are called by their names.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "harness/report/cells.h"

namespace mwt {

class Labels {
 public:
  explicit Labels(const std::vector<Cell>& cells);

  [[nodiscard]] std::string family(const CellKey& key) const;
  [[nodiscard]] std::string algorithm(const CellKey& key) const;

 private:
  std::map<std::string, std::set<std::string>> family_parameters_;
  std::map<std::string, std::set<std::string>> algorithm_parameters_;
};

}  // namespace mwt
