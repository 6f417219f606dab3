// The messages between the page and the program: a JSON text, and bytes for what is long (coordinates, indices).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.h"
#include "geometry/triangulation.h"

namespace mwt {

/// The bytes are little-endian: doubles x0 y0 x1 y1 ..., or indices of 32 bits.
struct Frame {
  std::string json;
  std::string bytes;
};

/// The lengths of both parts (32 bits each, little-endian), the JSON text, padded by blanks so that the bytes begin at
/// a multiple of 8, and the bytes.
[[nodiscard]] std::string encoded(Frame frame);

/// The frame that is the whole text; nothing if the lengths say otherwise.
[[nodiscard]] std::optional<Frame> decoded(std::string_view text);

[[nodiscard]] std::string bytes_of(Points points);
/// Nothing unless the bytes are whole points.
[[nodiscard]] std::optional<std::vector<Point>> points_in(std::string_view bytes);

/// Of edges or triangles.
void append_indices(std::string& bytes, std::span<const Edge> edges);
void append_indices(std::string& bytes, std::span<const Triangle> triangles);

}  // namespace mwt
