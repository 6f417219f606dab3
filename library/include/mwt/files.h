// Files of points and triangulations, in the formats that the program mwt reads and writes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mwt/points.h"

namespace mwt::v1 {

/// All points of a file in its order: text, CSV, TSPLIB, JSON, WKT, NumPy and others, compressed too (README.md of the
/// project). `columns`, such as "lon,lat" or "3,4", chooses the columns of a table. Throws InputError "FILE:LINE: what;
/// remedy".
[[nodiscard]] std::vector<Point> read_points(const std::string& file, const std::optional<std::string>& columns = {});

/// Writes points so that reading returns exactly the same: .txt, .xy, .csv, .tsv, .tsp or .json. The file appears whole
/// or not at all. Throws InputError.
void write_points(const std::string& file, std::span<const Point> points);

/// A triangulation of the points from a file of triangles or edges, counted from 0 or 1. Throws InputError, also if it
/// is none.
[[nodiscard]] std::vector<Triangle> read_triangulation(const std::string& file, std::span<const Point> points);

/// Lines "a,b,c". Throws InputError.
void write_triangles(const std::string& file, std::span<const Triangle> triangles);

/// What the verifier proves of a proof file, with its own interval for the optimum. Throws InputError if the file is no
/// proof of these points or a step of it does not follow.
struct Verdict {
  Interval optimum;
  bool is_optimal = false;  ///< the proof's triangulation is one of minimum weight, to 1e-12
};
[[nodiscard]] Verdict verify_proof(const std::string& file, std::span<const Point> points);

}  // namespace mwt::v1
