#include "harness/explore/frame.h"

#include <bit>
#include <cstring>
#include <utility>

namespace mwt {

static_assert(std::endian::native == std::endian::little, "frames are copied as they are in memory");

namespace {

constexpr std::size_t kHeadSize = 8;
constexpr std::size_t kAlignment = 8;

void append_raw(std::string& bytes, const void* data, std::size_t size) {
  bytes.append(static_cast<const char*>(data), size);
}

std::uint32_t size_at(std::string_view text, std::size_t position) {
  std::uint32_t size = 0;
  std::memcpy(&size, text.data() + position, sizeof size);
  return size;
}

}  // namespace

std::string encoded(Frame frame) {
  frame.json.append((kAlignment - frame.json.size() % kAlignment) % kAlignment, ' ');
  std::string text;
  text.reserve(kHeadSize + frame.json.size() + frame.bytes.size());
  for (const std::string* part : {&frame.json, &frame.bytes}) {
    const auto size = static_cast<std::uint32_t>(part->size());
    append_raw(text, &size, sizeof size);
  }
  text += frame.json;
  text += frame.bytes;
  return text;
}

std::optional<Frame> decoded(std::string_view text) {
  if (text.size() < kHeadSize) return std::nullopt;
  const std::uint64_t json_size = size_at(text, 0);
  const std::uint64_t bytes_size = size_at(text, sizeof(std::uint32_t));
  if (kHeadSize + json_size + bytes_size != text.size()) return std::nullopt;
  return Frame{std::string(text.substr(kHeadSize, json_size)), std::string(text.substr(kHeadSize + json_size))};
}

std::string bytes_of(Points points) {
  std::string bytes;
  append_raw(bytes, points.data(), points.size_bytes());
  return bytes;
}

std::optional<std::vector<Point>> points_in(std::string_view bytes) {
  if (bytes.size() % sizeof(Point) != 0) return std::nullopt;
  std::vector<Point> points(bytes.size() / sizeof(Point));
  if (!points.empty()) std::memcpy(points.data(), bytes.data(), bytes.size());
  return points;
}

void append_indices(std::string& bytes, std::span<const Edge> edges) {
  append_raw(bytes, edges.data(), edges.size_bytes());
}

void append_indices(std::string& bytes, std::span<const Triangle> triangles) {
  append_raw(bytes, triangles.data(), triangles.size_bytes());
}

}  // namespace mwt
