#include <memory>

#include "base/error.h"
#include "harness/cli/commands/commands.h"
#include "harness/io/points/point_file.h"
#include "harness/run/catalogue.h"

namespace mwt {

namespace {

struct GenerateArguments {
  std::string family;
  std::optional<Index> n;
  std::uint64_t seed = 1;
  std::vector<std::string> parameters;
  std::string output;
};

Index number_of_points(const GeneratorInfo& family, const std::optional<Index>& n) {
  if (!n && family.fixed_n == 0) throw InputError(family.name + " has many sizes; give --n");
  return n.value_or(family.fixed_n);
}

int generate_points(const GenerateArguments& options) {
  const Catalogue catalogue = Catalogue::built_in();
  const GeneratorInfo& family = catalogue.generator(options.family);
  const Parameters parameters(family.name, family.parameters, parse_parameters(options.parameters));
  const Index n = number_of_points(family, options.n);
  write_points(options.output, generate_points(family, n, options.seed, parameters));
  return kExitOk;
}

}  // namespace

Command generate_command() {
  const auto options = std::make_shared<GenerateArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("family", options->family, family_kind(), "name of a family (mwt list generators)");
    declared.option("--n", options->n, "number of points; not needed for a named instance");
    declared.option("--seed", options->seed, "seed of the pseudo-random numbers");
    declared.repeated("--param", options->parameters, ValueKind{"NAME=VALUE"},
                      "a parameter of the family, k=v; may be repeated");
    declared.required("-o,--output", options->output, kFile,
                      "point file by its ending (.txt .xy .csv .tsp .json); - for stdout");
  };
  return {"generate", "Write an instance of a family to a point file", declare,
          [options] { return generate_points(*options); }};
}

}  // namespace mwt
