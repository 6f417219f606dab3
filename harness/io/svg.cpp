#include "harness/io/svg.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.h"
#include "base/unicode.h"
#include "geometry/convex_hull.h"
#include "harness/io/output_file.h"

namespace mwt {

namespace {

// Black, pale blue and vermilion, after Okabe and Ito's palette for the colour-blind. The lines carry their colours as
// attributes as well, for programs without style sheets.
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
    throw InputError(fmt::format("picture: a width of {} px; use at least {}", picture.width_px, kMinWidthPx));
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
    file_.append(fmt::format(
        R"(<svg xmlns="http://www.w3.org/2000/svg" role="img" width="{0}" height="{1:.0f}" viewBox="0 0 {0} {1:.0f}">)"
        "\n",
        picture_.width_px, std::ceil(mapping_.height_px())));
    if (!picture_.title.empty()) file_.append("<title>" + escaped(picture_.title) + "</title>\n");
    file_.append(kStyle);
    file_.append("<rect class=\"background\" fill=\"#ffffff\" width=\"100%\" height=\"100%\"/>\n");
  }

  void lines(std::string_view layer, std::string_view colour, std::span<const Edge> edges, double width_px) {
    if (edges.empty()) return;
    begin_path(layer, colour, width_px);
    for (const Edge& edge : edges) {
      const Point a = mapping_.to_pixels(picture_.points[edge.a]);
      const Point b = mapping_.to_pixels(picture_.points[edge.b]);
      file_.append(fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}\n", a.x, a.y, b.x, b.y));
    }
    file_.append("\"/>\n");
  }

  void outline() {
    if (picture_.hull.empty()) return;
    begin_path("hull", "#222222", 1.4 * sizes_.line);
    char command = 'M';
    for (const Index corner : picture_.hull) {
      const Point p = mapping_.to_pixels(picture_.points[corner]);
      file_.append(fmt::format("{}{:.2f} {:.2f}\n", std::exchange(command, 'L'), p.x, p.y));
    }
    file_.append("Z\"/>\n");
  }

  void begin_path(std::string_view layer, std::string_view colour, double width_px) {
    file_.append(fmt::format(R"(<path class="line {}" fill="none" stroke="{}" stroke-width="{:.2f}" d=")", layer,
                             colour, width_px));
  }

  void dots() {
    file_.append("<g class=\"points\">\n");
    for (const Point& point : picture_.points) {
      const Point p = mapping_.to_pixels(point);
      file_.append(fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"/>\n", p.x, p.y, sizes_.dot_radius));
    }
    file_.append("</g>\n");
  }

  // Above and to the right of the dots, with a halo that keeps them readable across lines.
  void labels() {
    file_.append(fmt::format("<g class=\"labels\" font-size=\"{:.1f}\" stroke-width=\"{:.1f}\">\n", sizes_.font,
                             sizes_.font / 4));
    for (std::size_t i = 0; i < picture_.points.size(); ++i) {
      const Point p = mapping_.to_pixels(picture_.points[i]);
      file_.append(fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", p.x + sizes_.dot_radius + 1,
                               p.y - sizes_.dot_radius - 1, i));
    }
    file_.append("</g>\n");
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
  picture.title = fmt::format("Triangulation of {} points", points.size());
  picture.labels = points.size() <= kMaxLabels;
  write_svg(path, picture);
}

}  // namespace mwt
