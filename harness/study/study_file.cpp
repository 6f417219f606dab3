// The only source that includes toml++.
#include <fmt/core.h>
#include <toml++/toml.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <limits>
#include <utility>

#include "algorithms/registry.h"
#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/input_file.h"
#include "harness/io/text/text.h"
#include "harness/run/command/command.h"
#include "harness/study/study.h"

namespace mwt {

namespace {

constexpr double kMaxTime = 1e9;  // s; about thirty years
constexpr std::int64_t kMaxCount = 1000000;
constexpr std::size_t kMaxCombinations = 10000;

using ParameterValues = std::map<std::string, std::string>;

std::string place_of(const std::string& file, const toml::source_region& source) {
  return fmt::format("{}:{}", file, source.begin.line);
}

// A table of the file whose keys are read one by one; a key that nothing read is an error in the end.
class TableReader {
 public:
  TableReader(const std::string& file, const toml::table& table, const std::string& title)
      : TableReader(file, table, title, place_of(file, table.source())) {}

  // For a table that stands for a name in the file, at `place`.
  TableReader(std::string file, const toml::table& table, std::string title, std::string place)
      : file_(std::move(file)), table_(table), title_(std::move(title)), place_(std::move(place)) {}

  [[noreturn]] void fail(const toml::node& node, const std::string& what) const {
    throw InputError(place_of(file_, node.source()) + ": " + what);
  }

  [[nodiscard]] const std::string& place() const { return place_; }
  [[nodiscard]] const std::string& file() const { return file_; }

  const toml::node* find(const std::string& key) {
    known_.push_back(key);
    return table_.get(key);
  }

  // Of a key that was found.
  [[nodiscard]] const toml::node& value_of(const std::string& key) const { return *table_.get(key); }

  std::string text(const std::string& key) {
    const toml::node* node = find(key);
    if (node == nullptr) throw InputError(fmt::format("{}: {} needs the key '{}'", place_, title_, key));
    return text_of(*node, key);
  }

  std::string text_of(const toml::node& node, const std::string& key) const {
    if (!node.is_string()) fail(node, "'" + key + "' must be text in quotes");
    return node.ref<std::string>();
  }

  void read_positive(const std::string& key, double& value) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    const auto number = node->value<double>();
    if (!number || !node->is_number() || !(*number > 0 && *number <= kMaxTime)) {
      fail(*node, "'" + key + "' must be a positive number of at most 1e9");
    }
    value = *number;
  }

  std::int64_t integer_of(const toml::node& node, const std::string& key, std::int64_t smallest) const {
    const bool in_range = node.is_integer() && node.ref<std::int64_t>() >= smallest;
    if (!in_range) fail(node, fmt::format("'{}' must be a whole number of at least {}", key, smallest));
    return node.ref<std::int64_t>();
  }

  void read_integer(const std::string& key, std::int64_t smallest, const std::function<void(std::int64_t)>& use) {
    if (const toml::node* node = find(key)) use(integer_of(*node, key, smallest));
  }

  void read_count(const std::string& key, int& value) {
    read_integer(key, 1, [&](std::int64_t count) {
      if (count > kMaxCount) fail(*table_.get(key), fmt::format("'{}' must be at most {}", key, kMaxCount));
      value = static_cast<int>(count);
    });
  }

  void read_flag(const std::string& key, bool& value) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    if (!node->is_boolean()) fail(*node, "'" + key + "' must be true or false");
    value = node->ref<bool>();
  }

  void for_each_element(const std::string& key, const std::function<void(const toml::node&)>& use) {
    const toml::node* node = find(key);
    if (node == nullptr) return;
    if (!node->is_array() || node->as_array()->empty()) fail(*node, "'" + key + "' must be a list, not empty");
    for (const toml::node& element : *node->as_array()) use(element);
  }

  void refuse_unknown_keys() const {
    for (const auto& [key, node] : table_) {
      const std::string name(key.str());
      if (std::find(known_.begin(), known_.end(), name) == known_.end()) {
        throw InputError(fmt::format("{}: {} has no key '{}'; it has {}", place_of(file_, key.source()), title_, name,
                                     joined(known_)));
      }
    }
  }

 private:
  std::string file_;
  const toml::table& table_;
  std::string title_;
  std::string place_;
  std::vector<std::string> known_;
};

Index index_of(const TableReader& reader, const toml::node& node, const std::string& key) {
  const std::int64_t value = reader.integer_of(node, key, 3);
  if (value >= std::int64_t{kNoIndex}) reader.fail(node, "'" + key + "' must be below 2^32 - 1");
  return static_cast<Index>(value);
}

std::vector<Index> read_sizes(TableReader& reader) {
  std::vector<Index> sizes;
  reader.for_each_element("sizes", [&](const toml::node& node) { sizes.push_back(index_of(reader, node, "sizes")); });
  return sizes;
}

std::vector<std::uint64_t> read_seeds(TableReader& reader) {
  std::vector<std::uint64_t> seeds;
  reader.for_each_element("seeds", [&](const toml::node& node) {
    seeds.push_back(static_cast<std::uint64_t>(reader.integer_of(node, "seeds", 0)));
  });
  return seeds;
}

std::string parameter_text(const TableReader& reader, const toml::node& node, const std::string& name) {
  if (node.is_string()) return node.ref<std::string>();
  if (node.is_integer()) return std::to_string(node.ref<std::int64_t>());
  if (node.is_floating_point()) return number_text(node.ref<double>());
  reader.fail(node, "parameter '" + name + "' must be a number, text, or a list of these");
}

// All combinations of the parameters' values, the last named varying fastest.
std::vector<ParameterValues> read_parameters(TableReader& reader) {
  std::vector<ParameterValues> combinations(1);
  const toml::node* node = reader.find("parameters");
  if (node == nullptr) return combinations;
  if (!node->is_table()) reader.fail(*node, "'parameters' must be a table { name = value }");
  for (const auto& [key, value] : *node->as_table()) {
    const std::string name(key.str());
    std::vector<std::string> values;
    if (const toml::array* list = value.as_array()) {
      for (const toml::node& element : *list) values.push_back(parameter_text(reader, element, name));
      if (values.empty()) reader.fail(value, "parameter '" + name + "' must not be an empty list");
    } else {
      values.push_back(parameter_text(reader, value, name));
    }
    if (combinations.size() * values.size() > kMaxCombinations) {
      reader.fail(value, fmt::format("the lists of parameters make more than {} combinations", kMaxCombinations));
    }
    std::vector<ParameterValues> longer;
    for (const ParameterValues& combination : combinations) {
      for (const std::string& text : values) {
        longer.push_back(combination);
        longer.back()[name] = text;
      }
    }
    combinations = std::move(longer);
  }
  return combinations;
}

// The elements of a list of names or of tables with a name: "uniform" means { name = "uniform" }.
void for_each_choice(TableReader& study, const std::string& key, const std::string& title,
                     const std::function<void(TableReader&, const std::string& name)>& use) {
  study.for_each_element(key, [&](const toml::node& node) {
    const toml::table named = node.is_string() ? toml::table{{"name", node.ref<std::string>()}} : toml::table{};
    if (!node.is_string() && !node.is_table()) study.fail(node, "'" + key + "' lists names or tables with a name");
    TableReader choice(study.file(), node.is_table() ? *node.as_table() : named, title,
                       place_of(study.file(), node.source()));
    const std::string name = choice.text("name");
    use(choice, name);
    choice.refuse_unknown_keys();
  });
}

void read_families(TableReader& reader, Study& study) {
  for_each_choice(reader, "families", "a family", [&](TableReader& choice, const std::string& name) {
    const std::vector<Index> sizes = read_sizes(choice);
    const std::vector<std::uint64_t> seeds = read_seeds(choice);
    for (const ParameterValues& parameters : read_parameters(choice)) {
      study.families.push_back({name, parameters, sizes, seeds, choice.place()});
    }
  });
}

// The command of an algorithm of the study's own. Its folder counts from that of the study file.
std::optional<ExternalCommand> read_command(TableReader& choice) {
  if (choice.find("command") == nullptr) return std::nullopt;
  namespace fs = std::filesystem;
  ExternalCommand command;
  choice.for_each_element("command",
                          [&](const toml::node& node) { command.words.push_back(choice.text_of(node, "command")); });
  const toml::node* const folder = choice.find("folder");
  const fs::path here = fs::absolute(choice.file()).parent_path();
  command.folder = (here / (folder == nullptr ? "." : choice.text_of(*folder, "folder"))).lexically_normal().string();
  if (const toml::node* const format = choice.find("points")) command.points_format = choice.text_of(*format, "points");
  if (const toml::node* const node = choice.find("environment")) {
    if (!node->is_table()) choice.fail(*node, "'environment' must be a table { NAME = \"value\" }");
    for (const auto& [name, value] : *node->as_table())
      command.environment[std::string(name.str())] = choice.text_of(value, "environment");
  }
  return command;
}

// Parameters of a command are those that the study gives it, with the first values as defaults.
void add_command(const TableReader& choice, const std::string& name, const ExternalCommand& command,
                 const std::vector<ParameterValues>& combinations, Study& study) {
  const auto has_name = [&](const StudyCommand& other) { return other.info.name == name; };
  try {
    if (std::ranges::any_of(algorithms(), [&](const AlgorithmInfo& info) { return info.name == name; }))
      throw InputError("an algorithm of mwt has this name; give your command another one");
    if (std::ranges::any_of(study.commands, has_name)) throw InputError("two commands have this name");
    study.commands.push_back({algorithm_of(name, command, combinations.front()), content_hash_of(command)});
  } catch (const InputError& error) {
    throw InputError(choice.place() + ": " + name + ": " + error.what());
  }
}

void read_algorithms(TableReader& reader, Study& study) {
  for_each_choice(reader, "algorithms", "an algorithm", [&](TableReader& choice, const std::string& name) {
    std::optional<Index> max_n;
    if (const toml::node* node = choice.find("max_n")) max_n = index_of(choice, *node, "max_n");
    std::vector<std::string> families;
    choice.for_each_element("families",
                            [&](const toml::node& node) { families.push_back(choice.text_of(node, "families")); });
    const std::vector<ParameterValues> combinations = read_parameters(choice);
    if (const std::optional<ExternalCommand> command = read_command(choice))
      add_command(choice, name, *command, combinations, study);
    for (const ParameterValues& parameters : combinations) {
      study.algorithms.push_back({name, parameters, max_n, choice.place(), families});
    }
  });
}

void read_limits(TableReader& reader, RunLimits& limits) {
  reader.read_positive("time_s", limits.time_s);
  reader.read_positive("grace_s", limits.grace_s);
  reader.read_integer("memory_mb", 1, [&](std::int64_t mb) {
    limits.memory_bytes = static_cast<std::uint64_t>(std::min(mb, std::int64_t{1} << 30)) << 20;
  });
}

// true, false, or { max_n = N }.
void read_proofs(TableReader& reader, Study& study) {
  const toml::node* const node = reader.find("proofs");
  if (node == nullptr) return;
  if (const toml::table* const table = node->as_table()) {
    TableReader proofs(reader.file(), *table, "'proofs'", place_of(reader.file(), node->source()));
    const toml::node* const max_n = proofs.find("max_n");
    if (max_n == nullptr) proofs.fail(*node, "'proofs' must be true, false or { max_n = number of points }");
    study.max_proof_n = index_of(proofs, *max_n, "max_n");
    proofs.refuse_unknown_keys();
  } else {
    bool are_asked_for = false;
    reader.read_flag("proofs", are_asked_for);
    if (are_asked_for) study.max_proof_n = std::numeric_limits<std::size_t>::max();
  }
  if (study.max_proof_n > 0 && !study.seeks_optimum)
    reader.fail(*node, "'proofs' are of optima, which this study does not seek; delete 'seek = false'");
}

// "callgrind", or { tool = "callgrind", max_n = N }.
void read_counts(TableReader& reader, Study& study) {
  const toml::node* const node = reader.find("counts");
  if (node == nullptr) return;
  constexpr std::size_t kUsualMaxN = 1000;
  study.max_counted_n = kUsualMaxN;
  std::string tool;
  if (const toml::table* const table = node->as_table()) {
    TableReader counts(reader.file(), *table, "'counts'", place_of(reader.file(), node->source()));
    tool = counts.text("tool");
    if (const toml::node* const max_n = counts.find("max_n")) study.max_counted_n = index_of(counts, *max_n, "max_n");
    counts.refuse_unknown_keys();
  } else {
    tool = reader.text_of(*node, "counts");
  }
  if (tool != "callgrind") reader.fail(*node, "'counts' has the tool 'callgrind' alone, not '" + tool + "'");
  if (study.threads != 1)
    reader.fail(*node, "'counts' are of one thread: with several they depend on who waits for whom; delete 'threads'");
}

void read_optimum(TableReader& reader, Study& study) {
  read_limits(reader, study.optimum_limits);
  reader.read_flag("seek", study.seeks_optimum);
  read_proofs(reader, study);
  for_each_choice(reader, "sources", "an optimum source", [&](TableReader& choice, const std::string& name) {
    std::optional<Index> max_n;
    if (const toml::node* node = choice.find("max_n")) max_n = index_of(choice, *node, "max_n");
    study.optimum_sources.push_back({name, max_n, choice.place()});
  });
}

// The name becomes that of a folder, and a word in messages and tables.
std::string read_name(TableReader& reader) {
  constexpr std::size_t kLongest = 100;
  const std::string name = reader.text("name");
  const auto is_plain = [](char c) {
    const bool is_letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    return is_letter || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.' || c == '+';
  };
  const bool begins_well = !name.empty() && name.front() != '.' && name.front() != '-';
  if (begins_well && name.size() <= kLongest && std::all_of(name.begin(), name.end(), is_plain)) return name;
  reader.fail(reader.value_of("name"),
              "'name' must be at most 100 letters, digits and ._+- and begin with none of .- for it names a folder");
}

// The folder counts from that of the study file.
void read_instances(TableReader& reader, InstanceFiles& files) {
  namespace fs = std::filesystem;
  files.place = reader.place();
  const fs::path here = fs::path(reader.file()).parent_path();
  const toml::node* folder = reader.find("folder");
  const fs::path named = folder == nullptr ? fs::path(".") : fs::path(reader.text_of(*folder, "folder"));
  files.folder = (here / named).lexically_normal().string();
  reader.for_each_element("files", [&](const toml::node& node) {
    files.patterns.push_back(reader.text_of(node, "files"));
    const fs::path pattern(files.patterns.back());
    if (pattern.is_absolute()) reader.fail(node, "'files' are within 'folder': no leading /");
    if (std::find(pattern.begin(), pattern.end(), "..") != pattern.end())
      reader.fail(node, "'files' are within 'folder': no .. in them");
  });
  if (files.patterns.empty()) throw InputError(reader.place() + ": [instances] needs the key 'files'");
}

void read_section(TableReader& reader, const std::string& key, const std::function<void(TableReader&)>& use) {
  const toml::node* node = reader.find(key);
  if (node == nullptr) return;
  if (!node->is_table()) reader.fail(*node, "'" + key + "' must be a table");
  TableReader section(reader.file(), *node->as_table(), "[" + key + "]");
  use(section);
  section.refuse_unknown_keys();
}

Study read_root(const std::string& path, const toml::table& root) {
  Study study;
  TableReader reader(path, root, "a study");
  study.name = read_name(reader);
  study.summary = reader.text("summary");
  study.sizes = read_sizes(reader);
  if (reader.find("seeds") != nullptr) study.seeds = read_seeds(reader);
  reader.read_count("repetitions", study.repetitions);
  reader.read_count("threads", study.threads);
  reader.read_positive("min_time_s", study.min_time_s);
  reader.read_flag("delaunay_time", study.measures_delaunay_time);
  read_counts(reader, study);
  bool for_reports = false;  // which read it with judges_claims()
  reader.read_flag("claims", for_reports);
  read_families(reader, study);
  read_algorithms(reader, study);
  read_section(reader, "limits", [&](TableReader& section) { read_limits(section, study.limits); });
  read_section(reader, "instances", [&](TableReader& section) { read_instances(section, study.instance_files); });
  study.optimum_limits = study.limits;
  read_section(reader, "optimum", [&](TableReader& section) { read_optimum(section, study); });
  reader.refuse_unknown_keys();
  if (study.min_time_s > study.limits.time_s + study.limits.grace_s) {
    reader.fail(reader.value_of("min_time_s"), "'min_time_s' is more than a run may take, [limits] time_s + grace_s");
  }
  const bool has_instances = !study.families.empty() || !study.instance_files.patterns.empty();
  if (!has_instances) throw InputError(path + ": 'families' is missing; [\"*\"] means all");
  if (study.algorithms.empty()) throw InputError(path + ": 'algorithms' is missing; [\"*\"] means all");
  return study;
}

}  // namespace

Study read_study(const std::string& path, const std::optional<std::string>& instance_folder) {
  const std::string content = read_file(path);
  try {
    const toml::table root = toml::parse(content);
    Study study = read_root(path, root);
    study.file_content = content;
    study.folder = std::filesystem::path(path).parent_path().string();
    if (!instance_folder) return study;
    if (study.instance_files.patterns.empty())
      throw InputError(path + ": no [instances] that --instances could be for");
    study.instance_files.folder = *instance_folder;
    return study;
  } catch (const toml::parse_error& error) {
    throw InputError(place_of(path, error.source()) + ": not valid TOML: " + one_line(error.description()));
  }
}

std::vector<StudyCommand> read_commands(const std::optional<std::string>& study_file) {
  if (!study_file) return {};
  const std::string& path = *study_file;
  try {
    const toml::table root = toml::parse(read_file(path));
    Study study;
    TableReader reader(path, root, "a study");
    read_algorithms(reader, study);
    if (study.commands.empty()) throw InputError(path + ": none of its 'algorithms' has a 'command'");
    return std::move(study.commands);
  } catch (const toml::parse_error& error) {
    throw InputError(place_of(path, error.source()) + ": not valid TOML: " + one_line(error.description()));
  }
}

ResultChoice read_result_choice(const std::string& path) {
  try {
    const toml::table root = toml::parse(read_file(path));
    TableReader reader(path, root, "a choice of results");
    ResultChoice choice;
    const auto read_names = [&](const char* key, std::vector<std::string>& names) {
      reader.for_each_element(key, [&](const toml::node& node) { names.push_back(reader.text_of(node, key)); });
    };
    read_names("families", choice.families);
    choice.sizes = read_sizes(reader);
    read_names("algorithms", choice.algorithms);
    reader.refuse_unknown_keys();
    if (root.empty())
      throw InputError(path + ": chooses nothing; it needs one of the keys families, sizes, algorithms");
    return choice;
  } catch (const toml::parse_error& error) {
    throw InputError(place_of(path, error.source()) + ": not valid TOML: " + one_line(error.description()));
  }
}

const AlgorithmInfo& algorithm_named(const std::string& name, const std::vector<StudyCommand>& commands,
                                     const Catalogue& catalogue) {
  const auto found = std::ranges::find_if(commands, [&](const StudyCommand& one) { return one.info.name == name; });
  return found == commands.end() ? catalogue.algorithm(name) : found->info;
}

bool judges_claims(const std::string& study_file) {
  try {
    return toml::parse(study_file)["claims"].value_or(false);
  } catch (const toml::parse_error& error) {
    throw InputError("study.toml: not valid TOML: " + one_line(error.description()));
  }
}

}  // namespace mwt
