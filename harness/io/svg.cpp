#include "harness/io/svg.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "base/unicode.h"
#include "geometry/convex_hull.h"
#include "harness/io/output_file.h"

namespace mwt {

namespace {

// Black, pale blue and vermilion, after Okabe and Ito's palette for the colour-blind. The lines carry their colours as
// attributes as well, for programs that know no style sheets.
constexpr std::string_view kStyle =
    "<style>\n"
    ".background{fill:#ffffff}.line{fill:none;stroke-linecap:round;stroke-linejoin:round}\n"
    ".points{fill:#000000}.labels{fill:#000000;stroke:#ffffff;paint-order:stroke;font-family:sans-serif}\n"
    "@media screen and (prefers-color-scheme:dark){.background{fill:#16181c}.edges,.hull{stroke:#d8d8d8}\n"
    ".underlay{stroke:#1f5f8b}.highlight{stroke:#ff9d4d}.points{fill:#ffffff}\n"
    ".labels{fill:#ffffff;stroke:#16181c}}\n"
    "</style>\n";

constexpr double kMarginPx = 24;
constexpr double kMinHeightPx = 24;
constexpr double kTallest = 2;  // height over width
constexpr int kMinWidthPx = 100;
constexpr std::size_t kMaxLabels = 50;

// Maps points to pixels: scaled by a power of two first, exactly, so that no difference overflows or underflows.
class Mapping {
 public:
  Mapping(Points points, int width_px) : inner_width_(width_px - 2 * kMarginPx) {
    double largest = 0;
    for (const Point& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    exponent_ = largest > 0 ? -std::ilogb(largest) : 0;
    low_ = normalised(points.front());
    Point high = low_;
    for (const Point& point : points) {
      const Point p = normalised(point);
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    unit_ = std::max(high.x - low_.x, (high.y - low_.y) / kTallest);
    used_ = {in_pixels(high.x - low_.x), in_pixels(high.y - low_.y)};
    height_px_ = std::max(used_.y, kMinHeightPx) + 2 * kMarginPx;
    origin_ = {(width_px - used_.x) / 2, (height_px_ + used_.y) / 2};
  }

  [[nodiscard]] double height_px() const { return height_px_; }

  [[nodiscard]] Point to_pixels(const Point& point) const {
    const Point p = normalised(point);
    return {origin_.x + in_pixels(p.x - low_.x), origin_.y - in_pixels(p.y - low_.y)};
  }

  // A typical distance between neighbours, in pixels.
  [[nodiscard]] double spacing_px(std::size_t n) const {
    const auto count = static_cast<double>(n);
    return std::max(std::sqrt(used_.x * used_.y / count), std::max(used_.x, used_.y) / count);
  }

 private:
  // In [-2, 2].
  [[nodiscard]] Point normalised(const Point& p) const {
    return {std::scalbn(p.x, exponent_), std::scalbn(p.y, exponent_)};
  }

  // Divides first: the unit may be so small that its reciprocal is infinite.
  [[nodiscard]] double in_pixels(double distance) const { return unit_ > 0 ? distance / unit_ * inner_width_ : 0; }

  double inner_width_;
  int exponent_ = 0;
  double unit_ = 0;  // the normalised distance that is as long as the inner width
  Point low_;        // of the normalised points
  Point used_;       // width and height of the drawing in pixels
  Point origin_;     // where `low_` goes
  double height_px_ = 0;
};

// Widths in pixels.
struct Sizes {
  double line;
  double dot_radius;
  double font;
};

Sizes sizes_for(double spacing_px) {
  return {std::clamp(0.03 * spacing_px, 0.1, 1.4), std::clamp(0.06 * spacing_px, 0.15, 3.5),
          std::clamp(0.2 * spacing_px, 3.0, 13.0)};
}

void require_drawable(const SvgPicture& picture) {
  if (picture.points.empty()) throw InputError("picture: no points to draw");
  if (picture.width_px < kMinWidthPx) {
    throw InputError("picture: a width of " + std::to_string(picture.width_px) + " px; use at least " +
                     std::to_string(kMinWidthPx));
  }
  for (const Point& p : picture.points) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) throw InputError("picture: a coordinate is not finite");
  }
}

// Fit for XML: control characters become blanks, bytes that are no UTF-8 question marks.
std::string escaped(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::optional<Character> character = first_character(text);
    const std::size_t size = character ? character->size : 1;
    switch (character ? character->code_point : U'?') {
      case U'&': result += "&amp;"; break;
      case U'<': result += "&lt;"; break;
      case U'>': result += "&gt;"; break;
      case U'?': result += '?'; break;
      default:
        if (character->code_point < 0x20)
          result += ' ';
        else
          result += text.substr(0, size);
    }
    text.remove_prefix(size);
  }
  return result;
}

// Writes one picture, layer by layer.
class SvgWriter {
 public:
  SvgWriter(OutputFile& file, const SvgPicture& picture)
      : file_(file),
        picture_(picture),
        mapping_(picture.points, picture.width_px),
        sizes_(sizes_for(mapping_.spacing_px(picture.points.size()))) {}

  void write() {
    begin();
    lines("underlay", "#9ad0f5", picture_.underlay, 5 * sizes_.line);
    lines("edges", "#222222", picture_.edges, sizes_.line);
    outline();
    lines("highlight", "#d55e00", picture_.highlight, 1.8 * sizes_.line);
    dots();
    if (picture_.labels) labels();
    file_.append("</svg>\n");
  }

 private:
  void begin() {
    const std::string width = std::to_string(picture_.width_px);
    std::string height;
    append_fixed(height, std::ceil(mapping_.height_px()), 0);
    file_.append("<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"" + width + "\" height=\"" + height +
                 "\" viewBox=\"0 0 " + width + " " + height + "\">\n");
    if (!picture_.title.empty()) file_.append("<title>" + escaped(picture_.title) + "</title>\n");
    file_.append(kStyle);
    file_.append("<rect class=\"background\" fill=\"#ffffff\" width=\"100%\" height=\"100%\"/>\n");
  }

  void lines(std::string_view layer, std::string_view colour, std::span<const Edge> edges, double width_px) {
    if (edges.empty()) return;
    begin_path(layer, colour, width_px);
    for (const Edge& edge : edges) {
      std::string segment = "M";
      append_position(segment, picture_.points[edge.a]);
      segment += 'L';
      append_position(segment, picture_.points[edge.b]);
      file_.append(segment += '\n');
    }
    file_.append("\"/>\n");
  }

  void outline() {
    if (picture_.hull.empty()) return;
    begin_path("hull", "#222222", 1.4 * sizes_.line);
    char command = 'M';
    for (const Index corner : picture_.hull) {
      std::string segment(1, std::exchange(command, 'L'));
      append_position(segment, picture_.points[corner]);
      file_.append(segment += '\n');
    }
    file_.append("Z\"/>\n");
  }

  void begin_path(std::string_view layer, std::string_view colour, double width_px) {
    std::string start = "<path class=\"line ";
    start.append(layer).append("\" fill=\"none\" stroke=\"").append(colour).append("\" stroke-width=\"");
    append_fixed(start, width_px, 2);
    file_.append(start += "\" d=\"");
  }

  void dots() {
    std::string radius;
    append_fixed(radius, sizes_.dot_radius, 2);
    file_.append("<g class=\"points\">\n");
    for (const Point& point : picture_.points) {
      const Point p = mapping_.to_pixels(point);
      std::string dot = "<circle cx=\"";
      append_fixed(dot, p.x, 2);
      dot += "\" cy=\"";
      append_fixed(dot, p.y, 2);
      file_.append(dot.append("\" r=\"").append(radius).append("\"/>\n"));
    }
    file_.append("</g>\n");
  }

  // Above and to the right of the dots, with a halo that keeps them readable across lines.
  void labels() {
    std::string start = "<g class=\"labels\" font-size=\"";
    append_fixed(start, sizes_.font, 1);
    start += "\" stroke-width=\"";
    append_fixed(start, sizes_.font / 4, 1);
    file_.append(start += "\">\n");
    for (std::size_t i = 0; i < picture_.points.size(); ++i) {
      const Point p = mapping_.to_pixels(picture_.points[i]);
      std::string label = "<text x=\"";
      append_fixed(label, p.x + sizes_.dot_radius + 1, 2);
      label += "\" y=\"";
      append_fixed(label, p.y - sizes_.dot_radius - 1, 2);
      file_.append(label.append("\">").append(std::to_string(i)).append("</text>\n"));
    }
    file_.append("</g>\n");
  }

  void append_position(std::string& text, const Point& point) const {
    const Point p = mapping_.to_pixels(point);
    append_fixed(text, p.x, 2);
    text += ' ';
    append_fixed(text, p.y, 2);
  }

  OutputFile& file_;
  const SvgPicture& picture_;
  Mapping mapping_;
  Sizes sizes_;
};

}  // namespace

void require_picture_name(const std::string& path) {
  require_fitting_ending(path, {".svg"}, "a picture is written as SVG");
}

void write_svg(const std::string& path, const SvgPicture& picture) {
  require_drawable(picture);
  require_picture_name(path);
  write_file_atomically(path, [&](OutputFile& file) { SvgWriter(file, picture).write(); });
}

void write_svg(const std::string& path, Points points, const Triangulation& triangulation) {
  const std::vector<Edge> edges = edges_of(triangulation);
  const std::vector<Index> hull = convex_hull(points);
  SvgPicture picture{.points = points, .edges = edges, .hull = hull};
  picture.title = "Triangulation of " + std::to_string(points.size()) + " points";
  picture.labels = points.size() <= kMaxLabels;
  write_svg(path, picture);
}

}  // namespace mwt
