#include "algorithms/start/start.h"

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_int_distribution.hpp>

#include "algorithms/greedy/greedy.h"
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

PlanarMesh start_mesh(Points points, const Context& context) {
  const std::string& name = context.parameters.text("start");
  if (name == "delaunay") return PlanarMesh::delaunay(points);
  if (name == "greedy") {
    PlanarMesh mesh = PlanarMesh::delaunay(points);
    make_greedy(mesh, points, context);
    return mesh;
  }
  if (name == "random") {
    PlanarMesh mesh = PlanarMesh::delaunay(points);
    flip_at_random(mesh, context.seed, 10 * points.size());
    return mesh;
  }
  if (context.start) return PlanarMesh(points, *context.start);
  throw InputError("parameter start=" + name +
                   " is neither delaunay, greedy nor random, and no triangulation was given");
}

}  // namespace mwt
