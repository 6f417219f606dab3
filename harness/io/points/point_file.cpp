#include "harness/io/points/point_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/compression.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"
#include "harness/io/points/point_formats.h"
#include "harness/io/text/text.h"
#include "harness/io/text/text_file.h"
#include "harness/io/text/text_lines.h"

namespace mwt {

namespace {

enum class Format { text, comma_separated, tsplib, json, wkt, off, ply, node, npy };

// What endings promise; of text files the content decides.
constexpr std::array<std::pair<std::string_view, Format>, 12> kEndings = {{{".txt", Format::text},
                                                                           {".xy", Format::text},
                                                                           {".csv", Format::comma_separated},
                                                                           {".tsv", Format::text},
                                                                           {".tsp", Format::tsplib},
                                                                           {".json", Format::json},
                                                                           {".geojson", Format::json},
                                                                           {".wkt", Format::wkt},
                                                                           {".off", Format::off},
                                                                           {".ply", Format::ply},
                                                                           {".node", Format::node},
                                                                           {".npy", Format::npy}}};

std::string ending_of(const std::string& path) {
  return lower_case(std::filesystem::path(without_compression_ending(path)).extension().string());
}

Format format_of(const std::string& path) {
  const std::string ending = ending_of(path);
  if (ending.empty()) return Format::text;
  const auto* const entry = std::ranges::find(kEndings, ending, &std::pair<std::string_view, Format>::first);
  if (entry != kEndings.end()) return entry->second;
  std::vector<std::string> known;
  for (const auto& [name, format] : kEndings) known.emplace_back(name);
  throw InputError(path + ": unknown ending " + shown(ending) + "; known: " + joined(known, " ") +
                   ", and .gz, .bz2, .xz, .zst behind them");
}

bool begins_with_word_off(std::string_view text) {
  const std::size_t start = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  const std::size_t end = std::min(text.find_first_of(" \t\r\n", start), text.size());
  constexpr std::size_t kLongest = 6;  // "STNOFF"
  return end - start <= kLongest && text.substr(start, end - start).ends_with("OFF");
}

// What a file holds that could be any of these. No table of points begins with a bracket.
Format format_by_content(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start != std::string_view::npos && (text[start] == '{' || text[start] == '[')) return Format::json;
  if (looks_like_wkt(text)) return Format::wkt;
  if (begins_with_word_off(text)) return Format::off;
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

std::vector<Point> read_points(const std::string& path, const std::optional<ColumnNames>& columns) {
  const Format by_name = format_of(path);
  const std::string source = source_name(path);
  std::string content = decompressed(read_file(path), source);
  const bool is_text = by_name == Format::text || by_name == Format::comma_separated;
  if (by_name == Format::npy || (is_text && looks_like_npy(content))) {
    if (!looks_like_npy(content)) throw InputError(source + ": is no NumPy file");
    return parse_npy_points(source, content);
  }
  if (by_name == Format::ply || (is_text && content.starts_with("ply\n"))) return parse_ply_points(source, content);
  const std::string text = as_plain_text(std::move(content), source);
  switch (is_text ? format_by_content(text) : by_name) {
    case Format::tsplib: return parse_tsplib_points(source, text);
    case Format::json: return parse_json_points(source, text);
    case Format::wkt: return parse_wkt_points(source, text);
    case Format::off: return parse_off_points(source, text);
    case Format::node: return parse_node_points(source, text);
    default: return parse_text_points(source, text, columns);
  }
}

void require_writable_points(const std::string& path) {
  const std::string ending = ending_of(path);
  const Format format = format_of(path);
  const bool is_written =
      format == Format::text || format == Format::comma_separated || format == Format::tsplib || format == Format::json;
  if (!is_written || ending == ".geojson" || without_compression_ending(path) != path)
    throw InputError(path + ": points are written as .txt, .xy, .csv, .tsv, .tsp or .json");
}

void write_points(const std::string& path, Points points) {
  require_writable_points(path);
  const Format format = format_of(path);
  const char separator = ending_of(path) == ".tsv" ? '\t' : ' ';
  write_file_atomically(path, [&](OutputFile& file) {
    switch (format) {
      case Format::comma_separated:
        file.append("x,y\n");
        write_text(file, points, ',');
        break;
      case Format::tsplib: write_tsplib(file, points, path); break;
      case Format::json: write_json(file, points); break;
      default: write_text(file, points, separator); break;
    }
  });
}

}  // namespace mwt
