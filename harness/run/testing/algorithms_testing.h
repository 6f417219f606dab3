// For the harness's tests: algorithms that behave in every way a study must survive.
#pragma once

#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/error.h"
#include "generators/registry.h"
#include "geometry/delaunay.h"
#include "geometry/weight.h"
#include "harness/run/catalogue.h"

namespace mwt::testing {

/// The address sanitizer's allocator keeps freed memory and ends the process where other allocators report that none is
/// left.
#ifdef __SANITIZE_ADDRESS__
inline constexpr bool kUsualAllocator = false;
#else
inline constexpr bool kUsualAllocator = true;
#endif

inline Solution delaunay_solution(Points points) {
  Solution solution;
  solution.triangulation = delaunay_triangulation(points);
  return solution;
}

inline Solution solve_well(Points points, Context&) { return delaunay_solution(points); }

/// Right on points that have one triangulation only, as the family `fan` does.
inline Solution solve_fan_exactly(Points points, Context&) {
  Solution solution = delaunay_solution(points);
  solution.optimum = weight(points, solution.triangulation);
  solution.count.emplace("1");
  return solution;
}

/// Certifies half of its triangulation's weight as a lower bound.
inline Solution solve_with_weak_bound(Points points, Context&) {
  Solution solution = delaunay_solution(points);
  const Interval own = weight(points, solution.triangulation);
  solution.optimum = Interval{0.5 * own.lower, own.upper};
  return solution;
}

inline Solution claim_too_much(Points points, Context&) {
  Solution solution = delaunay_solution(points);
  const Interval own = weight(points, solution.triangulation);
  solution.optimum = Interval{2 * own.upper, 2 * own.upper};
  return solution;
}

inline Solution lose_a_triangle(Points points, Context&) {
  Solution solution = delaunay_solution(points);
  solution.triangulation.triangles.pop_back();
  return solution;
}

[[noreturn]] inline Solution crash(Points, Context&) {
  std::signal(SIGSEGV, SIG_DFL);  // a sanitizer's handler would turn it into an exit
  std::raise(SIGSEGV);
  throw std::logic_error("not reached");
}

[[noreturn]] inline Solution leave(Points, Context&) {
  std::fputs("giving up\n", stderr);
  _exit(5);
}

inline Solution hang(Points, Context& context) {
  while (context.seed != 0) usleep(1000);
  return {};
}

inline Solution loop_for_ever(Points points, Context& context) {
  for (volatile std::uint64_t seed = context.seed; seed != 0;) seed = seed + 2;  // odd seeds stay odd
  return delaunay_solution(points);
}

inline Solution allocate_without_bound(Points, Context&) {
  std::vector<std::vector<char>> blocks;
  for (;;) blocks.emplace_back(std::size_t{1} << 24, 'x');
}

[[noreturn]] inline Solution fail(Points, Context&) { throw std::runtime_error("lost\nits way"); }

[[noreturn]] inline Solution decline(Points, Context&) { throw NotApplicable("takes nothing"); }

inline Solution chat(Points points, Context& context) {
  std::puts("on standard output");
  std::fputs("on standard error\n", stderr);
  return solve_well(points, context);
}

[[noreturn]] inline Solution fail_and_say_so(Points, Context&) {
  std::fputs("on standard error\n", stderr);
  throw std::runtime_error("an undeclared parameter");
}

inline Solution misspell_a_parameter(Points points, Context& context) {
  return context.parameters.integer("kk") > 0 ? solve_well(points, context) : Solution{};
}

inline AlgorithmInfo entry(const std::string& name, AlgorithmFunction function,
                           Exactness exactness = Exactness::heuristic) {
  AlgorithmInfo info;
  info.name = name;
  info.summary = "for tests";
  info.exactness = exactness;
  info.max_n = 100000;
  info.function = function;
  return info;
}

/// All of the above, on the real families.
inline Catalogue test_catalogue() {
  static const std::vector<AlgorithmInfo> algorithms = [] {
    std::vector<AlgorithmInfo> entries = {
        entry("well", solve_well),
        entry("weak_bound", solve_with_weak_bound, Exactness::exact),
        entry("fan_exact", solve_fan_exactly, Exactness::exact),
        entry("claims", claim_too_much),
        entry("invalid", lose_a_triangle),
        entry("crashes", crash),
        entry("leaves", leave),
        entry("hangs", hang),
        entry("allocates", allocate_without_bound),
        entry("throws", fail),
        entry("declines", decline),
        entry("chats", chat),
        entry("small", solve_well),
        entry("tuned", solve_well),
        entry("loops", loop_for_ever),
        entry("grumbles", fail_and_say_so),
        entry("misspells", misspell_a_parameter),
    };
    entries[12].max_n = 5;
    for (const std::size_t i : {13, 16}) {
      entries[i].parameters = {{"k", ParameterType::integer, "4", "a number"},
                               {"start", ParameterType::text, "sweep", "where to begin", {"sweep", "greedy"}}};
    }
    return entries;
  }();
  return {algorithms, generators()};
}

}  // namespace mwt::testing
