// Between the library's types and those of the layers below, and from their errors to the library's.
#pragma once

#include <exception>
#include <new>
#include <span>
#include <vector>

#include "algorithms/algorithm.h"
#include "algorithms/interrupted.h"
#include "base/error.h"
#include "geometry/numbers/interval.h"
#include "geometry/point.h"
#include "geometry/triangulation.h"
#include "mwt/points.h"

namespace mwt::v1 {

[[nodiscard]] inline std::vector<mwt::Point> inner_points(std::span<const Point> points) {
  std::vector<mwt::Point> result;
  result.reserve(points.size());
  for (const auto& [x, y] : points) result.push_back({x, y});
  return result;
}

[[nodiscard]] inline std::vector<Point> outer_points(const std::vector<mwt::Point>& points) {
  std::vector<Point> result;
  result.reserve(points.size());
  for (const auto& [x, y] : points) result.push_back({x, y});
  return result;
}

[[nodiscard]] inline Interval outer_interval(const mwt::Interval& interval) { return {interval.lower, interval.upper}; }

/// Calls `work`; whatever it throws becomes an error of the library, but for std::bad_alloc.
template <class Work>
auto with_errors_of_the_library(const Work& work) {
  try {
    return work();
  } catch (const Error&) {
    throw;
  } catch (const mwt::InputError& error) {
    throw InputError(error.what());
  } catch (const mwt::NotApplicable& error) {
    throw NotApplicable(error.what());
  } catch (const mwt::Interrupted& error) {
    throw Interrupted(error.what());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw InternalError(error.what());
  }
}

}  // namespace mwt::v1
