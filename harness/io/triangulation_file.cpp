#include "harness/io/triangulation_file.h"

#include <fmt/core.h>

#include <array>
#include <numeric>

#include "harness/io/input_file.h"
#include "harness/io/output_file.h"
#include "harness/io/text/cell_text.h"
#include "harness/io/text/text_file.h"
#include "harness/io/text/text_table.h"

namespace mwt {

namespace {

template <std::size_t kCorners>
using Corners = std::array<Index, kCorners>;

constexpr std::array<std::string_view, 3> kNames{"a", "b", "c"};

// "a, b and c".
template <std::size_t kCorners>
std::string corner_names() {
  return kCorners == 2 ? "a and b" : "a, b and c";
}

// The first columns, unless the header names the corners. Precondition: the table stands at its first row.
template <std::size_t kCorners>
std::array<std::size_t, kCorners> find_columns(const TextTable& table) {
  const std::size_t width = table.columns().size();
  if (width < kCorners || (width > kCorners && table.header().empty())) {
    table.fail(
        fmt::format("{} column(s) where there should be {}; name further columns in a header such as a,b,c,perimeter",
                    width, kCorners));
  }
  std::array<std::size_t, kCorners> columns;
  std::iota(columns.begin(), columns.end(), std::size_t{0});
  std::size_t named = 0;
  for (std::size_t i = 0; i < kCorners; ++i) {
    const auto place = table.column_named(kNames[i]);
    if (place) columns[i] = *place;
    if (place) ++named;
  }
  const bool begins_with_labels = !table.header().empty() && names_row_labels(table.header().front());
  if (named == kCorners || (named == 0 && !begins_with_labels)) return columns;
  table.fail_in_header("the header does not name the columns of the corners; call them " + corner_names<kCorners>());
}

template <std::size_t kCorners>
std::vector<Corners<kCorners>> parse_corners(const std::string& source, std::string_view text,
                                             const std::string& what) {
  TextTable table(source, text);
  std::vector<Corners<kCorners>> rows;
  std::array<std::size_t, kCorners> columns{};
  while (table.next_row()) {
    if (rows.empty()) columns = find_columns<kCorners>(table);
    Corners<kCorners> row;
    for (std::size_t i = 0; i < kCorners; ++i) row[i] = table.index(columns[i]);
    rows.push_back(row);
  }
  if (rows.empty()) table.fail_as_a_whole("no " + what + " in it; write one per line, corners by index from 0");
  return rows;
}

}  // namespace

std::vector<Triangle> parse_triangles(const std::string& source, std::string_view text) {
  return parse_corners<3>(source, text, "triangles");
}

std::vector<Edge> parse_edges(const std::string& source, std::string_view text) {
  std::vector<Edge> edges;
  for (const auto& [a, b] : parse_corners<2>(source, text, "edges")) edges.push_back(make_edge(a, b));
  return edges;
}

std::vector<Triangle> read_triangles(const std::string& path) {
  return parse_triangles(source_name(path), read_text_file(path));
}

std::vector<Edge> read_edges(const std::string& path) { return parse_edges(source_name(path), read_text_file(path)); }

void require_table_name(const std::string& path) {
  require_fitting_ending(path, {".csv"}, "triangles and edges are written as CSV");
}

void write_triangles(const std::string& path, std::span<const Triangle> triangles) {
  require_table_name(path);
  write_file_atomically(path, [&](OutputFile& file) {
    file.append("a,b,c\n");
    for (const auto& [a, b, c] : triangles) file.append(fmt::format("{},{},{}\n", a, b, c));
  });
}

void write_edges(const std::string& path, std::span<const Edge> edges) {
  require_table_name(path);
  write_file_atomically(path, [&](OutputFile& file) {
    file.append("a,b\n");
    for (const Edge& edge : edges) file.append(fmt::format("{},{}\n", edge.a, edge.b));
  });
}

}  // namespace mwt
