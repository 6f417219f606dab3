#include <algorithm>
#include <iostream>
#include <iterator>
#include <memory>

#include "geometry/convex_hull.h"
#include "geometry/point_set.h"
#include "geometry/weight.h"
#include "harness/cli/commands/commands.h"
#include "harness/cli/file_options.h"
#include "harness/io/given_triangulation.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"
#include "harness/io/points/point_file.h"
#include "harness/io/svg.h"
#include "harness/io/text/aligned_table.h"
#include "harness/io/text/text.h"

namespace mwt {

namespace {

struct DrawArguments {
  std::string points;
  std::string triangles;
  std::string other;
  std::string output;
  bool labels = false;
  int width_px = 800;
  std::optional<std::string> columns;
};

constexpr std::size_t kMaxLabels = 50;

// The edges of a file's triangulation, sorted, as positions in the point file.
std::vector<Edge> edges_in_input(const std::string& file, const PointSet& set, const std::vector<Point>& input) {
  const Triangulation triangulation = read_triangulation(file, set, input);
  return edges_of({set.input_count, to_input_indices(set, triangulation.triangles)});
}

std::vector<Index> hull_in_input(const PointSet& set) {
  std::vector<Index> hull = convex_hull(set.points);
  for (Index& corner : hull) corner = set.input_indices[corner];
  return hull;
}

std::vector<Edge> difference(const std::vector<Edge>& a, const std::vector<Edge>& b) {
  std::vector<Edge> only_in_a;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(only_in_a));
  return only_in_a;
}

std::string length_of(const std::vector<Edge>& edges, Points points) {
  LengthSum sum;
  for (const Edge& edge : edges) sum.add(points[edge.a], points[edge.b]);
  return edges.empty() ? "0" : fixed(sum.enclosure().middle(), 6);
}

std::string comparison(const DrawArguments& options, Points points, const std::vector<Edge>& edges,
                       const std::vector<Edge>& other) {
  AlignedTable table({"", "edges", "length"});
  const auto add = [&](const std::string& name, const std::vector<Edge>& of) {
    table.add_row({name, std::to_string(of.size()), length_of(of, points)});
  };
  add(options.triangles, edges);
  if (!options.other.empty()) {
    add(options.other, other);
    add("only in the first (orange)", difference(edges, other));
    add("only in the second (pale blue)", difference(other, edges));
  }
  return table.text();
}

void require_usable_files(const DrawArguments& options) {
  std::vector<std::string> inputs = {options.points, options.triangles};
  if (!options.other.empty()) inputs.push_back(options.other);
  require_one_from_standard_input(inputs);
  const OutputOption output{"--output", options.output};
  require_usable_outputs({&output, 1}, inputs);
  require_picture_name(options.output);
}

int draw(const DrawArguments& options) {
  require_usable_files(options);
  const std::vector<Point> input = read_points(options.points, column_names(options.columns));
  const PointSet set = make_point_set(input, source_name(options.points));
  const std::vector<Edge> edges = edges_in_input(options.triangles, set, input);
  const std::vector<Edge> other =
      options.other.empty() ? std::vector<Edge>{} : edges_in_input(options.other, set, input);
  const std::vector<Edge> differing = options.other.empty() ? std::vector<Edge>{} : difference(edges, other);
  const std::vector<Index> hull = hull_in_input(set);
  SvgPicture picture{.points = input, .edges = edges, .underlay = other, .highlight = differing, .hull = hull};
  picture.title = options.triangles + (options.other.empty() ? "" : " over " + options.other);
  picture.labels = options.labels || input.size() <= kMaxLabels;
  picture.width_px = options.width_px;
  write_svg(options.output, picture);
  if (!is_standard_output(options.output)) std::cout << comparison(options, input, edges, other);
  return kExitOk;
}

}  // namespace

Command draw_command() {
  const auto options = std::make_shared<DrawArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("points", options->points, kFile, "point file; - for stdin");
    declared.argument("triangles", options->triangles, kFile,
                      "triangle file: three positions in the point file per line");
    declared.optional_argument(
        "other", options->other, kFile,
        "another triangle file to compare with, drawn underneath; edges that it lacks are orange");
    declare_columns(declared, options->columns);
    declared.required("-o,--output", options->output, kFile, "picture to write (.svg); - for stdout");
    declared.flag("--labels", options->labels, "number the points even if they are more than 50");
    declared.positive("--width", options->width_px, "of the picture in pixels");
  };
  return {"draw", "Draw a triangulation, or two on top of each other with their differences, as SVG", declare,
          [options] { return draw(*options); }};
}

}  // namespace mwt
