#include "algorithms/stop_reason.h"

#include <array>

namespace mwt {

namespace {

struct Names {
  StopReason reason;
  std::string_view name;
  std::string_view phrase;
};

constexpr std::array<Names, 4> kNames = {{
    {StopReason::precision, "precision", "rounding left the bounds apart"},
    {StopReason::size, "size", "a part of the problem is larger than the algorithm takes"},
    {StopReason::memory, "memory", "too little memory"},
    {StopReason::deadline, "deadline", "at the time limit"},
}};

const Names& names_of(StopReason reason) {
  return *std::find_if(kNames.begin(), kNames.end(), [&](const Names& names) { return names.reason == reason; });
}

}  // namespace

std::string_view name_of(StopReason reason) { return names_of(reason).name; }

std::string_view phrase_of(StopReason reason) { return names_of(reason).phrase; }

std::optional<StopReason> stop_reason_of(std::string_view name) {
  const auto* found =
      std::find_if(kNames.begin(), kNames.end(), [&](const Names& names) { return names.name == name; });
  return found == kNames.end() ? std::nullopt : std::optional(found->reason);
}

}  // namespace mwt
