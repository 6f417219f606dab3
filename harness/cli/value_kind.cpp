#include "harness/cli/value_kind.h"

#include "harness/run/catalogue.h"
#include "harness/study/study.h"

namespace mwt {

namespace {

template <class Entries>
std::vector<std::string> names_in(const Entries& entries) {
  std::vector<std::string> names;
  for (const auto& entry : entries) names.push_back(entry.name);
  return names;
}

}  // namespace

ValueKind algorithm_kind() {
  return {"ALGORITHM", [] { return names_in(Catalogue::built_in().algorithms()); }};
}

ValueKind family_kind() {
  return {"FAMILY", [] { return names_in(Catalogue::built_in().generators()); }};
}

ValueKind study_kind() { return {"STUDY", study_names}; }

ValueKind one_of(const std::string& word, const std::vector<std::string>& words) {
  return {word, [words] { return words; }};
}

}  // namespace mwt
