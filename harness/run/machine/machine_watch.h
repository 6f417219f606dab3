// What a machine did to the times taken on it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace mwt {

/// Times that the system slowed a CPU down because it was hot, since it was switched on, over all CPUs. Nothing where
/// the system does not report it (usual in virtual machines).
[[nodiscard]] std::optional<std::uint64_t> throttle_events();

/// Watches from its construction on.
class MachineWatch {
 public:
  MachineWatch();

  /// What happened meanwhile that makes times doubtful, one line each: CPUs slowed down by heat, memory moved to or
  /// from swap, CPU time taken by other virtual machines (more than a hundredth).
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  struct Counters {
    std::optional<std::uint64_t> throttled;
    std::uint64_t swapped_pages = 0;
    std::uint64_t stolen_ticks = 0;
    std::uint64_t all_ticks = 0;
  };
  [[nodiscard]] static Counters read();

  Counters begin_;
};

}  // namespace mwt
