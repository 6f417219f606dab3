#include "mwt/files.h"

#include "geometry/point_set.h"
#include "harness/io/given_triangulation.h"
#include "harness/io/points/point_file.h"
#include "harness/io/triangulation_file.h"
#include "harness/run/machine/build_info.h"
#include "library/source/conversion.h"
#include "mwt/mwt.h"
#include "verifier/refused.h"
#include "verifier/verify.h"

namespace mwt::v1 {

std::string version() { return mwt::version(); }

std::vector<Point> read_points(const std::string& file, const std::optional<std::string>& columns) {
  return with_errors_of_the_library([&] {
    const auto names = columns ? std::optional(parse_column_names(*columns)) : std::nullopt;
    return outer_points(mwt::read_points(file, names));
  });
}

void write_points(const std::string& file, std::span<const Point> points) {
  with_errors_of_the_library([&] { mwt::write_points(file, inner_points(points)); });
}

std::vector<Triangle> read_triangulation(const std::string& file, std::span<const Point> points) {
  return with_errors_of_the_library([&] {
    const std::vector<mwt::Point> input = inner_points(points);
    const PointSet set = make_point_set(input, "the points");
    return to_input_indices(set, mwt::read_triangulation(file, set, input).triangles);
  });
}

void write_triangles(const std::string& file, std::span<const Triangle> triangles) {
  with_errors_of_the_library([&] { mwt::write_triangles(file, triangles); });
}

Verdict verify_proof(const std::string& file, std::span<const Point> points) {
  return with_errors_of_the_library([&] {
    try {
      const verifier::Verdict verdict = verifier::verify(inner_points(points), file);
      return Verdict{{verdict.lower, verdict.upper}, verdict.is_optimal};
    } catch (const verifier::Refused& refused) {
      throw InputError(file + ": refused: " + refused.what());
    }
  });
}

}  // namespace mwt::v1
