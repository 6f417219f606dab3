#include "generators/registry.h"

#include "base/error.h"
#include "generators/annulus/annulus.h"
#include "generators/cad_plate/cad_plate.h"
#include "generators/circle/circle.h"
#include "generators/cluster_in_triangle/cluster_in_triangle.h"
#include "generators/clustered/clustered.h"
#include "generators/collinear_rows/collinear_rows.h"
#include "generators/contours/contours.h"
#include "generators/convex_position/convex_position.h"
#include "generators/delaunay_arc/delaunay_arc.h"
#include "generators/delaunay_flip_stuck/delaunay_flip_stuck.h"
#include "generators/ellipse/ellipse.h"
#include "generators/fan/fan.h"
#include "generators/far_from_origin/far_from_origin.h"
#include "generators/flip_corridor/flip_corridor.h"
#include "generators/generation.h"
#include "generators/greedy_corridor/greedy_corridor.h"
#include "generators/greedy_ratio/greedy_ratio.h"
#include "generators/grid/grid.h"
#include "generators/hexagonal_lattice/hexagonal_lattice.h"
#include "generators/hull_bound_counterexample/hull_bound_counterexample.h"
#include "generators/hunted/hunted.h"
#include "generators/insertion_trap/insertion_trap.h"
#include "generators/integer_circle/integer_circle.h"
#include "generators/integer_uniform/integer_uniform.h"
#include "generators/jittered_grid/jittered_grid.h"
#include "generators/lattice/lattice.h"
#include "generators/local_search_figure/local_search_figure.h"
#include "generators/log_radial/log_radial.h"
#include "generators/near_collinear/near_collinear.h"
#include "generators/normal/normal.h"
#include "generators/parabola/parabola.h"
#include "generators/report_example/report_example.h"
#include "generators/roads/roads.h"
#include "generators/spiral/spiral.h"
#include "generators/uniform/uniform.h"
#include "generators/uniform_disc/uniform_disc.h"
#include "generators/wheel/wheel.h"
#include "generators/wheels/wheels.h"
#include "generators/with_duplicates/with_duplicates.h"

namespace mwt {

std::span<const GeneratorInfo> generators() {
  static const std::vector<GeneratorInfo> entries = {
      uniform_entry(),
      uniform_disc_entry(),
      annulus_entry(),
      normal_entry(),
      clustered_entry(),
      log_radial_entry(),
      roads_entry(),
      spiral_entry(),
      contours_entry(),
      cad_plate_entry(),
      grid_entry(),
      jittered_grid_entry(),
      lattice_entry(),
      hexagonal_lattice_entry(),
      integer_uniform_entry(),
      circle_entry(),
      ellipse_entry(),
      parabola_entry(),
      convex_position_entry(),
      integer_circle_entry(),
      wheel_entry(),
      wheels_entry(),
      collinear_rows_entry(),
      near_collinear_entry(),
      fan_entry(),
      with_duplicates_entry(),
      far_from_origin_entry(),
      greedy_corridor_entry(),
      greedy_ratio_entry(),
      delaunay_arc_entry(),
      flip_corridor_entry(),
      delaunay_flip_stuck_entry(),
      insertion_trap_entry(),
      cluster_in_triangle_entry(),
      hunted_entry(),
      report_example_entry(),
      local_search_figure_entry(),
      hull_bound_counterexample_entry(),
  };
  return entries;
}

const GeneratorInfo& find_generator(const std::string& name) {
  std::string known;
  for (const GeneratorInfo& entry : generators()) {
    if (entry.name == name) return entry;
    known += (known.empty() ? "" : ", ") + entry.name;
  }
  throw InputError("unknown generator '" + name + "'; known: " + known);
}

std::vector<Point> generate(const std::string& family, Index n, std::uint64_t seed,
                            const std::map<std::string, std::string>& parameters) {
  const GeneratorInfo& entry = find_generator(family);
  return generate_verified(entry, n, seed, Parameters(family, entry.parameters, parameters));
}

}  // namespace mwt
