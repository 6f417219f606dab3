#include <fmt/core.h>

#include <iostream>
#include <memory>

#include "base/error.h"
#include "harness/cli/commands/commands.h"
#include "harness/cli/json_output.h"
#include "harness/io/terminal.h"
#include "harness/io/text/aligned_table.h"
#include "harness/run/catalogue.h"
#include "harness/study/study.h"

namespace mwt {

namespace {

struct ListArguments {
  std::string kind;
  bool json = false;
};

std::string with_defaults(const std::string& name, const std::vector<ParameterInfo>& parameters) {
  std::string text = name;
  for (const ParameterInfo& info : parameters) text += ' ' + info.name + '=' + info.default_value;
  return text;
}

std::string limit_text(Index largest) { return largest == 0 ? "-" : std::to_string(largest); }

std::string readable_text(std::span<const AlgorithmInfo> algorithms) {
  AlignedTable table({"algorithm and parameters", "kind", "largest n", "time", "what it is"}, {1, 3, 4});
  for (const AlgorithmInfo& info : algorithms) {
    table.add_row({with_defaults(info.name, info.parameters),
                   info.exactness == Exactness::exact ? "exact" : "heuristic", limit_text(info.max_n), info.time,
                   info.summary});
  }
  return table.text_within(output_width());
}

std::string readable_text(std::span<const GeneratorInfo> generators) {
  AlignedTable table({"family and parameters", "n", "what it is"}, {2});
  for (const GeneratorInfo& info : generators) {
    const std::string sizes = info.fixed_n != 0 ? std::to_string(info.fixed_n) : fmt::format(">= {}", info.min_n);
    table.add_row({with_defaults(info.name, info.parameters), sizes, info.summary});
  }
  return table.text_within(output_width());
}

std::string readable_text(std::span<const StudyEntry> studies) {
  AlignedTable table({"study", "what it is"}, {1});
  for (const StudyEntry& entry : studies) table.add_row({entry.name, entry.summary});
  return table.text_within(output_width());
}

std::vector<StudyEntry> study_entries() {
  std::vector<StudyEntry> entries;
  for (const std::string& name : study_names()) {
    const std::string file = find_study_file(name);
    entries.push_back({name, read_study(file).summary, file});
  }
  return entries;
}

template <class Entry>
int print(std::span<const Entry> entries, bool json) {
  std::cout << (json ? to_json(entries) : readable_text(entries));
  return kExitOk;
}

int list(const ListArguments& options) {
  const Catalogue catalogue = Catalogue::built_in();
  if (options.kind == "algorithms") return print(catalogue.algorithms(), options.json);
  if (options.kind == "generators") return print(catalogue.generators(), options.json);
  if (options.kind == "studies") return print(std::span<const StudyEntry>(study_entries()), options.json);
  throw InputError("cannot list '" + options.kind + "'; known: algorithms, generators, studies");
}

}  // namespace

Command list_command() {
  const auto options = std::make_shared<ListArguments>();
  const auto declare = [options](CommandOptions& declared) {
    declared.argument("kind", options->kind, one_of("KIND", {"algorithms", "generators", "studies"}),
                      "algorithms, generators or studies");
    declared.flag("--json", options->json, "print JSON with all details");
  };
  return {"list", "List the algorithms, the families of instances, or the studies", declare,
          [options] { return list(*options); }};
}

}  // namespace mwt
