#include "harness/tracking/old_names.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include "harness/io/text/text.h"

namespace mwt {

std::string present_name(const std::string& name) {
  constexpr std::array<std::pair<const char*, const char*>, 3> kRenamed = {
      {{"yardstick_time_s", "delaunay_time_s"}, {"greedy_report", "greedy_naive"}, {"flip_report", "flip_naive"}}};
  for (const auto& [old, present] : kRenamed) {
    if (name == old) return present;
  }
  return name;
}

std::string present_params(const std::string& algorithm, const std::string& params) {
  constexpr std::string_view kOld = "walls=";
  if (algorithm != "patch" || params.empty()) return params;
  std::vector<std::string> fields = split(params, ' ');
  for (std::string& field : fields) {
    if (field.starts_with(kOld)) field.replace(0, kOld.size(), "beta_skeleton=");
  }
  std::ranges::sort(fields);  // the canonical form is in the order of the names
  return joined(fields, " ");
}

}  // namespace mwt
