#include "harness/run/status.h"

#include <array>
#include <utility>

namespace mwt {

namespace {

constexpr std::array<std::pair<RunStatus, std::string_view>, 7> kNames = {{
    {RunStatus::ok, "ok"},
    {RunStatus::timeout, "timeout"},
    {RunStatus::out_of_memory, "out_of_memory"},
    {RunStatus::crashed, "crashed"},
    {RunStatus::invalid_output, "invalid_output"},
    {RunStatus::not_applicable, "not_applicable"},
    {RunStatus::error, "error"},
}};

}  // namespace

std::string_view name_of(RunStatus status) {
  for (const auto& [value, name] : kNames) {
    if (value == status) return name;
  }
  return "error";
}

std::optional<RunStatus> status_of(std::string_view name) {
  for (const auto& [value, known] : kNames) {
    if (known == name) return value;
  }
  return std::nullopt;
}

}  // namespace mwt
