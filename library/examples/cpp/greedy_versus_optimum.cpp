// How much heavier is the greedy triangulation than the lightest one? Of a file of points, or of random ones.
#include <mwt/mwt.h>

#include <cstdio>

int main(int argument_count, char** arguments) {
  namespace mwt = ::mwt::v1;
  try {
    const std::vector<mwt::Point> points =
        argument_count > 1 ? mwt::read_points(arguments[1]) : mwt::generate("uniform", 1000, 1);
    const mwt::Result greedy = mwt::triangulate(points, {.algorithm = "greedy"});
    const mwt::Result optimum = mwt::minimum_weight_triangulation(points, {.threads = 2, .time_limit_s = 60});
    if (!optimum.optimum) return 1;
    const mwt::Interval alpha = mwt::alpha(greedy.weight, *optimum.optimum);
    std::printf("%zu points, greedy weighs %.10g, the optimum %.10g (%s): alpha = %.6f\n", points.size(),
                greedy.weight.upper, optimum.weight.upper, optimum.is_proved ? "proved" : "not proved", alpha.upper);
    return 0;
  } catch (const mwt::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
