// Pictures of triangulations as SVG, good enough for a paper.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "geometry/triangulation.h"

namespace mwt {

/// What to draw, from back to front: underlay, edges, hull, highlight, points, labels.
///
/// The spans must outlive the picture. Indices refer to `points`.
struct SvgPicture {
  Points points;
  std::span<const Edge> edges{};      ///< thin dark lines
  std::span<const Edge> underlay{};   ///< broad pale blue lines behind everything: the triangulation to compare with
  std::span<const Edge> highlight{};  ///< orange lines on top: edges that differ, flipped ones, a skeleton
  std::span<const Index> hull{};      ///< closed polygon, a little stronger than edges
  std::string title{};                ///< shown by viewers, read by screen readers
  int width_px = 800;                 ///< of the whole picture; the height follows from the points
  bool labels = false;                ///< the points' indices
};

/// Throws InputError if the name's ending promises another kind of file, such as .png.
void require_picture_name(const std::string& path);

/// Writes the picture. Precondition: at least one point, finite coordinates (of any magnitude), otherwise InputError.
///
/// The y axis points up, x and y have the same scale. Very flat point sets get some height all the same. Lines and dots
/// become thinner as points become denser; colours differ for the colour-blind and in grey print, and follow
/// the viewer's dark mode; no scripts, no fonts or images from elsewhere. Deterministic. Streams: O(1) memory besides
/// the input. The file appears complete or not at all; `-` is standard output. Throws InputError if it cannot be
/// written, and as require_picture_name() does.
void write_svg(const std::string& path, const SvgPicture& picture);

/// The usual picture of a triangulation: its edges, its hull, labels up to 50 points. Precondition: indices in range.
void write_svg(const std::string& path, Points points, const Triangulation& triangulation);

}  // namespace mwt
