// For tests only: proofs as values that can be changed at will, and their encoding as FORMAT.md describes it.
#pragma once

#include <openssl/evp.h>
#include <zstd.h>

#include <array>
#include <bit>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/point.h"
#include "verifier/triangulation.h"

namespace mwt::verifier::testing {

using EdgeEnds = std::array<Index, 2>;

/// Edges that leave the candidates or are certain, for the same reason.
struct EdgeStep {
  std::uint64_t tag = 1;
  std::vector<EdgeEnds> edges;
  std::vector<EdgeEnds> crossed;  ///< tag 2: the certain edge that each crosses
};

/// A node of a tree of decisions, in preorder: a leaf, or an edge that is in first, then out, or a base, which has dual
/// values and is followed by a node.
struct TreeNode {
  bool is_leaf = true;                                ///< or a base: it has dual values
  std::uint64_t edge = 0;                             ///< branch: its position among the open edges
  std::vector<std::int64_t> side_duals;               ///< leaf, base
  std::vector<std::vector<std::int64_t>> edge_duals;  ///< leaf, base: one or, for edges that are in, two
  bool is_base = false;
  bool is_changed = false;  ///< a leaf that changes a base's dual values of these sides and edges:
  std::vector<std::uint64_t> changed_sides = {}, changed_edges = {};

  [[nodiscard]] std::uint8_t tag() const { return !is_leaf ? 1 : is_base ? 2 : is_changed ? 3 : 0; }
};

struct RegionStep {
  std::int64_t unit_exponent = 0;
  std::vector<std::vector<Index>> walks;
  std::vector<Index> isolated;
  std::vector<std::array<std::uint64_t, 2>>
      open_edges;  ///< places among the walks' and isolated points; first < second
  std::vector<TreeNode> tree;
};

struct Proof {
  std::uint64_t point_count = 0;
  std::vector<std::uint8_t> hash;
  double claimed_lower = 0, claimed_upper = 0;
  std::vector<Index> order;
  std::vector<Corners> triangles;
  std::vector<EdgeStep> steps;
  std::vector<RegionStep> regions;
};

inline std::vector<std::uint8_t> sha256(Points points) {
  std::vector<std::uint8_t> bytes, hash(32);
  for (const Point& p : points) {
    for (const double value : {p.x, p.y}) {
      for (int i = 0; i < 8; ++i)
        bytes.push_back(static_cast<std::uint8_t>(std::bit_cast<std::uint64_t>(value) >> (8 * i)));
    }
  }
  EVP_Digest(bytes.data(), bytes.size(), hash.data(), nullptr, EVP_sha256(), nullptr);
  return hash;
}

/// The numbers of a proof file, before compression.
class Encoder {
 public:
  void byte(std::uint64_t value) { bytes_.push_back(static_cast<std::uint8_t>(value)); }
  void number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) byte(value | 0x80);
    byte(value);
  }
  void signed_number(std::int64_t value) {
    number((static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63));
  }
  void real(double value) {
    for (int i = 0; i < 8; ++i) byte(std::bit_cast<std::uint64_t>(value) >> (8 * i));
  }
  void index_near(Index previous, Index value) { signed_number(std::int64_t{value} - std::int64_t{previous}); }

  [[nodiscard]] const std::vector<std::uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<std::uint8_t> bytes_;
};

inline void encode_step(Encoder& out, const EdgeStep& step) {
  out.number(step.tag);
  out.number(step.edges.size());
  Index last = 0;
  for (const EdgeEnds& edge : step.edges) {
    out.index_near(last, edge[0]);
    last = edge[0];
  }
  for (const EdgeEnds& edge : step.edges) out.index_near(edge[0], edge[1]);
  for (std::size_t i = 0; i < step.crossed.size(); ++i) {
    out.index_near(step.edges[i][0], step.crossed[i][0]);
    out.index_near(step.crossed[i][0], step.crossed[i][1]);
  }
}

inline void encode_region(Encoder& out, const RegionStep& region) {
  out.number(5);
  out.signed_number(region.unit_exponent);
  Index last = 0;
  const auto places = [&](const std::vector<Index>& points) {
    out.number(points.size());
    for (const Index p : points) {
      out.index_near(last, p);
      last = p;
    }
  };
  out.number(region.walks.size());
  for (const auto& walk : region.walks) places(walk);
  places(region.isolated);
  out.number(region.open_edges.size());
  std::uint64_t place = 0;
  for (const auto& [a, b] : region.open_edges) {
    out.number(a - place);
    place = a;
  }
  for (const auto& [a, b] : region.open_edges) out.number(b - a - 1);
  for (const TreeNode& node : region.tree) {
    out.byte(node.tag());
    if (!node.is_leaf) out.number(node.edge);
    std::uint64_t next = 0;
    const auto number_of = [&](const std::vector<std::uint64_t>& changed, std::size_t i) {
      if (!node.is_changed) return;
      out.number(changed[i] - next);
      next = changed[i] + 1;
    };
    if (node.is_changed) out.number(node.side_duals.size());
    for (std::size_t i = 0; i < node.side_duals.size(); ++i) {
      number_of(node.changed_sides, i);
      out.signed_number(node.side_duals[i]);
    }
    next = 0;
    if (node.is_changed) out.number(node.edge_duals.size());
    for (std::size_t i = 0; i < node.edge_duals.size(); ++i) {
      number_of(node.changed_edges, i);
      for (const std::int64_t dual : node.edge_duals[i]) out.signed_number(dual);
    }
  }
}

inline std::vector<std::uint8_t> encode(const Proof& proof) {
  Encoder out;
  out.number(proof.point_count);
  for (const std::uint8_t byte : proof.hash) out.byte(byte);
  out.real(proof.claimed_lower);
  out.real(proof.claimed_upper);
  for (const Index p : proof.order) out.number(p);
  out.number(proof.triangles.size());
  Index last = 0;
  for (const auto& [a, b, c] : proof.triangles) {
    out.index_near(last, a);
    out.index_near(a, b);
    out.index_near(b, c);
    last = a;
  }
  for (const EdgeStep& step : proof.steps) encode_step(out, step);
  for (const RegionStep& region : proof.regions) encode_region(out, region);
  out.number(0);
  return out.bytes();
}

/// Reads what encode() writes, from a file that is believed to be in order; throws std::runtime_error if it is not.
class Decoder {
 public:
  explicit Decoder(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  Proof proof() {
    Proof proof;
    proof.point_count = number();
    for (int i = 0; i < 32; ++i) proof.hash.push_back(byte());
    proof.claimed_lower = real();
    proof.claimed_upper = real();
    for (std::uint64_t i = 0; i < proof.point_count; ++i) proof.order.push_back(static_cast<Index>(number()));
    const std::uint64_t triangles = number();
    Index last = 0;
    for (std::uint64_t i = 0; i < triangles; ++i) {
      const Index a = near(last), b = near(a);
      proof.triangles.push_back({a, b, near(b)});
      last = a;
    }
    for (std::uint64_t kind = number(); kind != 0; kind = number()) {
      if (kind == 5) {
        proof.regions.push_back(region());
      } else {
        proof.steps.push_back(step(kind));
      }
    }
    if (next_ != bytes_.size()) throw std::runtime_error("something follows the end");
    return proof;
  }

 private:
  std::uint8_t byte() { return bytes_.at(next_++); }
  std::uint64_t number() {
    std::uint64_t result = 0;
    for (int shift = 0;; shift += 7) {
      const std::uint64_t part = byte();
      result |= (part & 0x7F) << shift;
      if (part < 0x80) return result;
    }
  }
  std::int64_t signed_number() {
    const std::uint64_t value = number();
    return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1);
  }
  double real() {
    std::uint64_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= std::uint64_t{byte()} << (8 * i);
    return std::bit_cast<double>(bits);
  }
  Index near(Index previous) { return static_cast<Index>(previous + signed_number()); }

  EdgeStep step(std::uint64_t kind) {
    EdgeStep step{kind, {}, {}};
    const std::uint64_t count = number();
    Index last = 0;
    for (std::uint64_t i = 0; i < count; ++i) step.edges.push_back({last = near(last), 0});
    for (EdgeEnds& edge : step.edges) edge[1] = near(edge[0]);
    for (std::uint64_t i = 0; i < count && kind == 2; ++i) {
      const Index a = near(step.edges[i][0]);
      step.crossed.push_back({a, near(a)});
    }
    return step;
  }

  RegionStep region() {
    RegionStep region;
    region.unit_exponent = signed_number();
    Index last = 0;
    const auto places = [&] {
      std::vector<Index> points(number());
      for (Index& p : points) p = last = near(last);
      return points;
    };
    std::size_t sides = 0;
    for (std::uint64_t walks = number(); walks > 0; --walks) {
      region.walks.push_back(places());
      sides += region.walks.back().size();
    }
    region.isolated = places();
    const std::uint64_t open = number();
    std::uint64_t place = 0;
    for (std::uint64_t i = 0; i < open; ++i) region.open_edges.push_back({place += number(), 0});
    for (auto& [a, b] : region.open_edges) b = a + 1 + number();
    read_node(region, sides, std::vector<bool>(open, false));
    return region;
  }

  void read_node(RegionStep& region, std::size_t sides, std::vector<bool> is_in) {
    TreeNode node;
    const std::uint8_t tag = byte();
    node.is_leaf = tag != 1;
    node.is_base = tag == 2;
    node.is_changed = tag == 3;
    if (node.is_leaf) {
      const std::uint64_t side_count = node.is_changed ? number() : sides;
      for (std::uint64_t i = 0, next = 0; i < side_count; ++i) {
        if (node.is_changed) node.changed_sides.push_back(next += number());
        ++next;
        node.side_duals.push_back(signed_number());
      }
      const std::uint64_t edge_count = node.is_changed ? number() : is_in.size();
      for (std::uint64_t i = 0, next = 0; i < edge_count; ++i, ++next) {
        if (node.is_changed) node.changed_edges.push_back(next += number());
        node.edge_duals.push_back({signed_number()});
        if (is_in.at(next)) node.edge_duals.back().push_back(signed_number());
      }
      region.tree.push_back(node);
      if (node.is_base) read_node(region, sides, is_in);
      return;
    }
    node.edge = number();
    region.tree.push_back(node);
    is_in.at(node.edge) = true;
    read_node(region, sides, is_in);
    is_in.at(node.edge) = false;
    read_node(region, sides, is_in);
  }

  const std::vector<std::uint8_t>& bytes_;
  std::size_t next_ = 0;
};

inline std::vector<std::uint8_t> read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The body of a proof file.
inline std::vector<std::uint8_t> decompressed(const std::vector<std::uint8_t>& file) {
  std::vector<std::uint8_t> plain;
  ZSTD_DStream* const stream = ZSTD_createDStream();
  ZSTD_inBuffer in{file.data(), file.size(), 12};
  std::vector<std::uint8_t> part(1 << 16);
  for (std::size_t rest = 1; rest != 0 && in.pos < in.size;) {
    ZSTD_outBuffer out{part.data(), part.size(), 0};
    rest = ZSTD_decompressStream(stream, &out, &in);
    if (ZSTD_isError(rest) != 0) break;
    plain.insert(plain.end(), part.begin(), part.begin() + static_cast<std::ptrdiff_t>(out.pos));
  }
  ZSTD_freeDStream(stream);
  return plain;
}

inline std::vector<std::uint8_t> compressed(const std::vector<std::uint8_t>& plain) {
  std::vector<std::uint8_t> result(ZSTD_compressBound(plain.size()));
  result.resize(ZSTD_compress(result.data(), result.size(), plain.data(), plain.size(), 3));
  return result;
}

inline std::vector<std::uint8_t> file_of(const std::vector<std::uint8_t>& plain, std::uint32_t version = 2) {
  std::vector<std::uint8_t> file{'M', 'W', 'T', 'P', 'R', 'O', 'O', 'F'};
  for (int i = 0; i < 4; ++i) file.push_back(static_cast<std::uint8_t>(version >> (8 * i)));
  const std::vector<std::uint8_t> body = compressed(plain);
  file.insert(file.end(), body.begin(), body.end());
  return file;
}

inline void write_file(const std::string& path, const std::vector<std::uint8_t>& bytes) {
  std::ofstream out(path, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

}  // namespace mwt::verifier::testing
