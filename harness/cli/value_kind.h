// What the values of arguments and options are: the word for them in --help, and what shells complete them with.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace mwt {

struct ValueKind {
  std::string word;  ///< "FILE", as in "--svg FILE"; empty for a flag, which takes none

  /// All words that the value can be; null: it can be more than a list says.
  std::function<std::vector<std::string>()> choices = nullptr;
};

inline const ValueKind kText{"TEXT"};
inline const ValueKind kWholeNumber{"N"};
inline const ValueKind kNumber{"NUMBER"};
inline const ValueKind kFile{"FILE"};      ///< completed with files
inline const ValueKind kFolder{"FOLDER"};  ///< completed with folders

[[nodiscard]] ValueKind algorithm_kind();
[[nodiscard]] ValueKind family_kind();
[[nodiscard]] ValueKind study_kind();  ///< completed with the names of studies, and with files
[[nodiscard]] ValueKind one_of(const std::string& word, const std::vector<std::string>& words);

}  // namespace mwt
