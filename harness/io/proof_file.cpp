#include "harness/io/proof_file.h"

#include <zstd.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "geometry/point_set.h"
#include "harness/io/output_file.h"

namespace mwt {

namespace {

constexpr std::string_view kMagic("MWTPROOF\2\0\0\0", 12);  // and the version, little-endian
constexpr int kCompressionLevel = 3;
constexpr std::size_t kEdgesPerStep = std::size_t{1} << 16;

enum Step : std::uint8_t { kEnd = 0, kNotMinimal = 1, kCrossing = 2, kUncrossed = 3, kBetaSkeleton = 4, kRegion = 5 };
enum Node : std::uint8_t { kLeaf = 0, kBranch = 1, kBase = 2, kChanges = 3 };

// Compresses numbers into a file.
class ProofWriter {
 public:
  explicit ProofWriter(OutputFile& file)
      : file_(file), stream_(ZSTD_createCStream(), ZSTD_freeCStream), compressed_(ZSTD_CStreamOutSize()) {
    ZSTD_CCtx_setParameter(stream_.get(), ZSTD_c_compressionLevel, kCompressionLevel);
    ZSTD_CCtx_setParameter(stream_.get(), ZSTD_c_checksumFlag, 1);
    plain_.reserve(kFlushAt + 64);
  }

  void byte(std::uint64_t value) {
    plain_.push_back(static_cast<char>(value & 0xFF));
    if (plain_.size() >= kFlushAt) compress(ZSTD_e_continue);
  }

  // Seven bits a byte, the lowest first.
  void number(std::uint64_t value) {
    for (; value >= 0x80; value >>= 7) byte((value & 0x7F) | 0x80);
    byte(value);
  }

  // 0, -1, 1, -2, ... as 0, 1, 2, 3, ...
  void signed_number(std::int64_t value) {
    number((static_cast<std::uint64_t>(value) << 1) ^ static_cast<std::uint64_t>(value >> 63));
  }

  void difference(Index value, Index previous) {
    signed_number(static_cast<std::int64_t>(value) - static_cast<std::int64_t>(previous));
  }

  void real(double value) {
    for (int shift = 0; shift < 64; shift += 8) byte(std::bit_cast<std::uint64_t>(value) >> shift);
  }

  void finish() { compress(ZSTD_e_end); }

 private:
  static constexpr std::size_t kFlushAt = std::size_t{1} << 17;

  void compress(ZSTD_EndDirective directive) {
    ZSTD_inBuffer in{plain_.data(), plain_.size(), 0};
    for (std::size_t rest = 1; rest != 0 || in.pos < in.size;) {
      ZSTD_outBuffer out{compressed_.data(), compressed_.size(), 0};
      rest = ZSTD_compressStream2(stream_.get(), &out, &in, directive);
      if (ZSTD_isError(rest) != 0) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(rest));
      file_.append({compressed_.data(), out.pos});
      if (directive == ZSTD_e_continue && in.pos == in.size) break;
    }
    plain_.clear();
  }

  OutputFile& file_;
  std::unique_ptr<ZSTD_CStream, decltype(&ZSTD_freeCStream)> stream_;
  std::vector<char> plain_, compressed_;
};

// Near triangles one after the other: they follow from each other in few bits.
void write_triangles(ProofWriter& out, const Triangulation& triangulation, const std::vector<Index>& place) {
  std::vector<Triangle> triangles = triangulation.triangles;
  for (Triangle& triangle : triangles) {
    for (Index& corner : triangle) corner = place[corner];
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  }
  std::sort(triangles.begin(), triangles.end());
  out.number(triangles.size());
  Index last = 0;
  for (const auto& [a, b, c] : triangles) {
    out.difference(a, last);
    out.difference(b, a);
    out.difference(c, b);
    last = a;
  }
}

Step step_of(EdgeReason reason) {
  switch (reason) {
    case EdgeReason::not_locally_minimal: return kNotMinimal;
    case EdgeReason::crosses_certain: return kCrossing;
    case EdgeReason::uncrossed: return kUncrossed;
    case EdgeReason::in_beta_skeleton: return kBetaSkeleton;
  }
  throw std::logic_error("unknown reason in a proof");
}

// Edges that pass through a point are none, which needs no proof.
EdgeConclusions without_edges_through_points(const EdgeConclusions& conclusions) {
  EdgeConclusions kept{conclusions.reason, {}, {}};
  for (std::size_t i = 0; i < conclusions.edges.size(); ++i) {
    if (conclusions.crossed[i].a == conclusions.crossed[i].b) continue;
    kept.edges.push_back(conclusions.edges[i]);
    kept.crossed.push_back(conclusions.crossed[i]);
  }
  return kept;
}

void write_edges(ProofWriter& out, const EdgeConclusions& conclusions) {
  for (std::size_t begin = 0; begin < conclusions.edges.size(); begin += kEdgesPerStep) {
    const std::size_t end = std::min(conclusions.edges.size(), begin + kEdgesPerStep);
    out.number(step_of(conclusions.reason));
    out.number(end - begin);
    Index last = 0;
    for (std::size_t i = begin; i < end; ++i) {
      out.difference(conclusions.edges[i].a, last);
      last = conclusions.edges[i].a;
    }
    for (std::size_t i = begin; i < end; ++i) out.difference(conclusions.edges[i].b, conclusions.edges[i].a);
    if (conclusions.reason != EdgeReason::crosses_certain) continue;
    for (std::size_t i = begin; i < end; ++i) {
      out.difference(conclusions.crossed[i].a, conclusions.edges[i].a);
      out.difference(conclusions.crossed[i].b, conclusions.crossed[i].a);
    }
  }
}

Node tag_of(DualNode::Kind kind) {
  switch (kind) {
    case DualNode::Kind::leaf: return kLeaf;
    case DualNode::Kind::branch: return kBranch;
    case DualNode::Kind::base: return kBase;
    case DualNode::Kind::changed_leaf: return kChanges;
  }
  throw std::logic_error("unknown kind of node in a proof");
}

// Of edges decided to be in, the dual values of both sides are written. Changes tell which sides and edges they are
// about: each by how many are left out before it.
void write_duals(ProofWriter& out, const DualNode& node, const std::vector<bool>& is_in) {
  const bool is_changed = node.kind == DualNode::Kind::changed_leaf;
  if (is_changed) out.number(node.side_duals.size());
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < node.side_duals.size(); ++i) {
    if (is_changed) out.number(node.changed_sides[i] - next);
    if (is_changed) next = node.changed_sides[i] + 1;
    out.signed_number(node.side_duals[i]);
  }
  if (is_changed) out.number(node.edge_duals.size());
  next = 0;
  for (std::size_t i = 0; i < node.edge_duals.size(); ++i) {
    const std::size_t edge = is_changed ? node.changed_edges[i] : i;
    if (is_changed) out.number(edge - next);
    next = static_cast<std::uint32_t>(edge + 1);
    out.signed_number(node.edge_duals[i]);
    if (is_in[edge]) out.signed_number(node.other_duals[i]);
  }
}

// The tree in preorder.
void write_tree(ProofWriter& out, const DualRegion& region) {
  struct Decision {
    std::uint32_t edge;
    bool is_in;
  };
  std::vector<Decision> path;
  std::vector<bool> is_in(region.open_edges.size(), false);
  for (const DualNode& node : region.tree) {
    out.byte(tag_of(node.kind));
    if (node.kind == DualNode::Kind::branch) {
      out.number(node.edge);
      path.push_back({node.edge, true});
      is_in[node.edge] = true;
      continue;
    }
    write_duals(out, node, is_in);
    if (node.kind == DualNode::Kind::base) continue;
    while (!path.empty() && !path.back().is_in) path.pop_back();
    if (path.empty()) continue;
    path.back().is_in = false;
    is_in[path.back().edge] = false;
  }
}

void write_region(ProofWriter& out, const DualRegion& region) {
  out.number(kRegion);
  out.signed_number(region.unit_exponent);
  out.number(region.walk_sizes.size());
  Index last = 0;
  std::size_t place = 0;
  const auto write_places = [&](std::size_t count) {
    out.number(count);
    for (const std::size_t end = place + count; place < end; ++place) {
      out.difference(region.places[place], last);
      last = region.places[place];
    }
  };
  for (const std::uint32_t size : region.walk_sizes) write_places(size);
  write_places(region.places.size() - place);
  out.number(region.open_edges.size());
  std::uint32_t from = 0;
  for (const auto& edge : region.open_edges) {
    out.number(edge[0] - from);
    from = edge[0];
  }
  for (const auto& edge : region.open_edges) out.number(edge[1] - edge[0] - 1);
  write_tree(out, region);
}

std::vector<Index> order_of(const ProofTrace& trace, std::size_t points) {
  std::vector<Index> order = trace.order;
  if (order.empty()) {
    for (Index i = 0; i < points; ++i) order.push_back(i);
  }
  return order;
}

}  // namespace

Interval write_proof(const std::string& path, Points points, const ProofTrace& trace,
                     const Triangulation& triangulation, const Interval& claimed) {
  // The verifier's sums may round the other way.
  const double proved = trace.lower_bound * (1 - 0x1p-50);
  const Interval claim{std::min(claimed.lower, proved), claimed.upper};
  write_file_atomically(path, [&](OutputFile& file) {
    file.append(kMagic);
    ProofWriter out(file);
    out.number(points.size());
    for (const unsigned char byte : content_hash(points)) out.byte(byte);
    out.real(claim.lower);
    out.real(claim.upper);
    const std::vector<Index> order = order_of(trace, points.size());
    std::vector<Index> place(points.size());
    for (Index i = 0; i < order.size(); ++i) place[order[i]] = i;
    for (const Index p : order) out.number(p);
    write_triangles(out, triangulation, place);
    for (const EdgeConclusions& conclusions : trace.edges) {
      if (conclusions.reason == EdgeReason::crosses_certain) {
        write_edges(out, without_edges_through_points(conclusions));
      } else {
        write_edges(out, conclusions);
      }
    }
    for (const DualRegion& region : trace.regions) write_region(out, region);
    out.number(kEnd);
    out.finish();
  });
  return claim;
}

}  // namespace mwt
