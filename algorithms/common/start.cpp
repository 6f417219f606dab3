#include "algorithms/common/start.h"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include "algorithms/common/beta_skeleton_edges.h"
#include "algorithms/greedy/greedy.h"
#include "algorithms/hull_insertion/hull_insertion.h"
#include "algorithms/quadtree/quadtree.h"
#include "algorithms/sweep/sweep.h"
#include "base/error.h"

namespace mwt {

ParameterInfo start_parameter(const std::string& default_value) {
  return {"start",
          ParameterType::text,
          default_value,
          "the triangulation to start from: an algorithm's, random (10 n random flips from Delaunay) or a file",
          {"delaunay", "sweep", "greedy", "quadtree", "hull_insertion", "random"}};
}

void flip_at_random(PlanarMesh& mesh, std::uint64_t seed, std::size_t count) {
  boost::random::mt19937_64 random(seed);
  const boost::random::uniform_int_distribution<MeshEdge> any_edge(0, static_cast<MeshEdge>(mesh.edge_count() - 1));
  for (std::size_t i = 0; i < count; ++i) {
    const MeshEdge e = any_edge(random);
    if (!mesh.is_hull(e) && mesh.is_flippable(e)) mesh.flip(e);
  }
}

namespace {

bool comes_from_delaunay(const std::string& name) { return name == "delaunay" || name == "greedy" || name == "random"; }

// Turns the Delaunay triangulation into the start of that name; marks survive on edges that do.
void change_delaunay(PlanarMesh& mesh, const Context& context, const std::string& name) {
  if (name == "greedy") make_greedy(mesh, context);
  if (name == "random") flip_at_random(mesh, context.seed, 10 * mesh.point_count());
}

// What the algorithm yields with its default parameters.
Triangulation start_by(const AlgorithmInfo& algorithm, Points points, const Context& context) {
  Context own;
  own.seed = context.seed;
  own.threads = context.threads;
  own.parameters = Parameters(algorithm.name, algorithm.parameters, {});
  return algorithm.function(points, own).triangulation;
}

Triangulation other_start(Points points, const Context& context, const std::string& name) {
  if (name == "sweep") return start_by(sweep_entry(), points, context);
  if (name == "quadtree") return start_by(quadtree_entry(), points, context);
  if (name == "hull_insertion") return start_by(hull_insertion_entry(), points, context);
  if (context.start) return *context.start;
  throw InputError("parameter start=" + name + " names neither an algorithm nor a file with a triangulation");
}

}  // namespace

PlanarMesh start_mesh(Points points, const Context& context) {
  const std::string& name = context.parameters.text("start");
  if (!comes_from_delaunay(name)) return PlanarMesh(points, other_start(points, context, name));
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  change_delaunay(mesh, context, name);
  return mesh;
}

PlanarMesh start_mesh_with_beta_skeleton(Points points, const Context& context) {
  const std::string& name = context.parameters.text("start");
  PlanarMesh delaunay = PlanarMesh::delaunay(points);
  mark_beta_skeleton(delaunay);
  if (comes_from_delaunay(name)) {
    change_delaunay(delaunay, context, name);
    return delaunay;
  }
  PlanarMesh mesh(points, other_start(points, context, name));
  copy_beta_skeleton(delaunay, mesh);
  return mesh;
}

}  // namespace mwt
