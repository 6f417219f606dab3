#include "algorithms/start/start.h"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include "algorithms/greedy/greedy.h"
#include "algorithms/start/walls.h"
#include "geometry/error.h"

namespace mwt {

ParameterInfo start_parameter(const std::string& default_value) {
  return {"start",
          ParameterType::text,
          default_value,
          "the triangulation to start from: delaunay, greedy, random (10 n random flips from Delaunay) or a file",
          {"delaunay", "greedy", "random"}};
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
void change_delaunay(PlanarMesh& mesh, Points points, const Context& context, const std::string& name) {
  if (name == "greedy") make_greedy(mesh, points, context);
  if (name == "random") flip_at_random(mesh, context.seed, 10 * points.size());
}

PlanarMesh given_mesh(Points points, const Context& context, const std::string& name) {
  if (context.start) return PlanarMesh(points, *context.start);
  throw InputError("parameter start=" + name +
                   " is neither delaunay, greedy nor random, and no triangulation was given");
}

}  // namespace

PlanarMesh start_mesh(Points points, const Context& context) {
  const std::string& name = context.parameters.text("start");
  if (!comes_from_delaunay(name)) return given_mesh(points, context, name);
  PlanarMesh mesh = PlanarMesh::delaunay(points);
  change_delaunay(mesh, points, context, name);
  return mesh;
}

PlanarMesh start_mesh_with_walls(Points points, const Context& context) {
  const std::string& name = context.parameters.text("start");
  PlanarMesh delaunay = PlanarMesh::delaunay(points);
  mark_walls(delaunay);
  if (comes_from_delaunay(name)) {
    change_delaunay(delaunay, points, context, name);
    return delaunay;
  }
  PlanarMesh mesh = given_mesh(points, context, name);
  copy_walls(delaunay, mesh);
  return mesh;
}

}  // namespace mwt
