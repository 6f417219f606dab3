#include "harness/io/solution_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"
#include "harness/io/compression.h"
#include "harness/io/input_file.h"
#include "harness/io/text/json_text.h"
#include "harness/io/text/text.h"
#include "harness/io/text/text_file.h"
#include "harness/io/text/text_lines.h"
#include "harness/io/text/text_table.h"
#include "harness/io/text/word_rows.h"
#include "harness/io/triangulation_file.h"

namespace mwt {

namespace {

using Json = nlohmann::json;

// A triangle or an edge.
using CornerList = std::vector<Index>;

class JsonSolution {
 public:
  JsonSolution(const std::string& source, std::string_view text) : source_(source) {
    document_ = Json::parse(text.begin(), text.end(), nullptr, false);
    if (document_.is_discarded()) fail("no valid JSON");
  }

  [[nodiscard]] std::vector<CornerList> read() const {
    const Json& list = list_in_document();
    std::vector<CornerList> all;
    for (const Json& entry : list) all.push_back(corners_of(entry, all.size()));
    if (all.empty()) fail("its list is empty");
    return all;
  }

 private:
  [[nodiscard]] const Json& list_in_document() const {
    if (document_.is_array()) return document_;
    for (const char* key : {"triangles", "edges"}) {
      if (document_.is_object() && document_.contains(key) && document_[key].is_array()) return document_[key];
    }
    fail("neither a list nor an object with \"triangles\" or \"edges\"");
  }

  [[nodiscard]] CornerList corners_of(const Json& entry, std::size_t place) const {
    CornerList corners;
    if (entry.is_object() && entry.contains("i") && entry.contains("j")) {
      corners = {index_of(entry["i"], place), index_of(entry["j"], place)};
    } else if (entry.is_array() && (entry.size() == 2 || entry.size() == 3)) {
      for (const Json& corner : entry) corners.push_back(index_of(corner, place));
    } else {
      fail(fmt::format("entry {} is neither [a, b, c] nor [a, b] nor {{\"i\": a, \"j\": b}}", place));
    }
    return corners;
  }

  [[nodiscard]] Index index_of(const Json& value, std::size_t place) const {
    const bool is_index = value.is_number_unsigned() && value.get<std::uint64_t>() < kNoIndex;
    if (!is_index) fail(fmt::format("entry {} has {}, which is not the index of a point", place, shown_json(value)));
    return value.get<Index>();
  }

  [[noreturn]] void fail(const std::string& what) const { throw InputError(source_ + ": " + what); }

  const std::string& source_;
  Json document_;
};

// "TRIANGLES 3 ATTRIBUTES", then "ID a b c ..." each.
std::vector<CornerList> read_ele(const std::string& source, std::string_view text) {
  WordRows rows(source, text);
  rows.require_next("'TRIANGLES 3 ATTRIBUTES'");
  const std::size_t count = rows.count(0);
  if (rows.words().size() < 2 || rows.words()[1] != "3") rows.fail("does not begin with 'TRIANGLES 3 ATTRIBUTES'");
  std::vector<CornerList> all;
  while (rows.next()) {
    CornerList corners;
    for (const std::size_t place : {1U, 2U, 3U}) corners.push_back(static_cast<Index>(rows.count(place)));
    all.push_back(std::move(corners));
  }
  if (all.size() != count)
    rows.fail_as_a_whole(fmt::format("{} where its first line states {}", counted(all.size(), "triangle"), count));
  return all;
}

// Whether a table has edges: two columns, or columns a and b but no c.
bool is_table_of_edges(const std::string& source, std::string_view text) {
  TextTable table(source, text);
  if (!table.next_row()) return false;
  if (table.column_named("a") && table.column_named("b")) return !table.column_named("c");
  return table.columns().size() == 2;
}

GivenSolution from(const std::vector<CornerList>& all, const std::string& source) {
  GivenSolution solution;
  for (const CornerList& corners : all) {
    if (corners.size() != all.front().size()) throw InputError(source + ": has triangles and edges; give one kind");
    if (corners.size() == 3) solution.triangles.push_back({corners[0], corners[1], corners[2]});
    if (corners.size() == 2) solution.edges.push_back(make_edge(corners[0], corners[1]));
  }
  return solution;
}

// Every point is a corner, so that the smallest and the largest one tell.
void count_from_zero(GivenSolution& solution, std::size_t point_count) {
  Index smallest = kNoIndex, largest = 0;
  const auto see = [&](Index corner) {
    smallest = std::min(smallest, corner);
    largest = std::max(largest, corner);
  };
  for (const Triangle& triangle : solution.triangles) std::ranges::for_each(triangle, see);
  for (const auto& [a, b] : solution.edges) {
    see(a);
    see(b);
  }
  solution.counts_from_one = smallest == 1 && largest == point_count;
  if (!solution.counts_from_one) return;
  for (Triangle& triangle : solution.triangles) {
    for (Index& corner : triangle) --corner;
  }
  for (Edge& edge : solution.edges) edge = {edge.a - 1, edge.b - 1};
}

}  // namespace

GivenSolution read_solution(const std::string& path, std::size_t point_count) {
  const std::string source = source_name(path);
  const std::string text = read_text_file(path);
  const std::string ending = lower_case(std::filesystem::path(without_compression_ending(path)).extension().string());
  const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  GivenSolution solution;
  if (ending == ".ele") {
    solution = from(read_ele(source, text), source);
  } else if (start < text.size() && (text[start] == '{' || text[start] == '[')) {
    solution = from(JsonSolution(source, text).read(), source);
  } else if (is_table_of_edges(source, text)) {
    solution.edges = parse_edges(source, text);
  } else {
    solution.triangles = parse_triangles(source, text);
  }
  count_from_zero(solution, point_count);
  return solution;
}

}  // namespace mwt
