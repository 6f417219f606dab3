#include "harness/io/points/point_file.h"

#include <fmt/core.h>

#include <filesystem>
#include <string_view>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"
#include "harness/io/points/point_formats.h"
#include "harness/io/text/text_file.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

namespace {

enum class Format { text, comma_separated, tsplib, json };

Format format_of(const std::string& path) {
  const std::string ending = lower_case(std::filesystem::path(path).extension().string());
  if (ending.empty() || ending == ".txt" || ending == ".xy") return Format::text;
  if (ending == ".csv") return Format::comma_separated;
  if (ending == ".tsp") return Format::tsplib;
  if (ending == ".json") return Format::json;
  throw InputError(path + ": unknown ending " + shown(ending) + "; use .txt, .xy, .csv, .tsp or .json");
}

// What a file holds that could be any of the three. No table of points begins with a brace.
Format format_by_content(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start != std::string_view::npos && text[start] == '{') return Format::json;
  return looks_like_tsplib(text) ? Format::tsplib : Format::text;
}

void write_text(OutputFile& file, Points points, char separator) {
  std::string line;
  for (const Point& p : points) {
    line.clear();
    append_number(line, p.x);
    line += separator;
    append_number(line, p.y);
    line += '\n';
    file.append(line);
  }
}

void write_tsplib(OutputFile& file, Points points, const std::string& path) {
  file.append(fmt::format("NAME : {}\nTYPE : TSP\nDIMENSION : {}\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n",
                          std::filesystem::path(path).stem().string(), points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    file.append(fmt::format("{} {} {}\n", i + 1, number_text(points[i].x), number_text(points[i].y)));
  }
  file.append("EOF\n");
}

void write_json(OutputFile& file, Points points) {
  file.append("{\"points\": [");
  std::string entry;
  for (std::size_t i = 0; i < points.size(); ++i) {
    entry = i == 0 ? "\n{\"x\": " : ",\n{\"x\": ";
    append_number(entry, points[i].x);
    entry += ", \"y\": ";
    append_number(entry, points[i].y);
    entry += '}';
    file.append(entry);
  }
  file.append("\n]}\n");
}

}  // namespace

std::vector<Point> read_points(const std::string& path) {
  const Format by_name = format_of(path);
  const std::string text = read_text_file(path);
  const std::string source = source_name(path);
  const bool is_fixed = by_name == Format::tsplib || by_name == Format::json;
  switch (is_fixed ? by_name : format_by_content(text)) {
    case Format::tsplib: return parse_tsplib_points(source, text);
    case Format::json: return parse_json_points(source, text);
    default: return parse_text_points(source, text);
  }
}

void write_points(const std::string& path, Points points) {
  const Format format = format_of(path);
  write_file_atomically(path, [&](OutputFile& file) {
    switch (format) {
      case Format::text: write_text(file, points, ' '); break;
      case Format::comma_separated:
        file.append("x,y\n");
        write_text(file, points, ',');
        break;
      case Format::tsplib: write_tsplib(file, points, path); break;
      case Format::json: write_json(file, points); break;
    }
  });
}

}  // namespace mwt
