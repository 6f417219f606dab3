#include "harness/cli/json_output.h"

#include <nlohmann/json.hpp>

namespace mwt {

namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

std::string_view name_of(ParameterType type) {
  switch (type) {
    case ParameterType::integer: return "integer";
    case ParameterType::real: return "real";
    case ParameterType::text: return "text";
    case ParameterType::choice: return "choice";
  }
  return "text";
}

Json json_of(const std::vector<ParameterInfo>& parameters) {
  Json array = Json::array();
  for (const ParameterInfo& info : parameters) {
    array.push_back({{"name", info.name},
                     {"type", name_of(info.type)},
                     {"default", info.default_value},
                     {"summary", info.summary},
                     {"choices", info.choices}});
  }
  return array;
}

Json json_of(const std::vector<GrowthLaw>& laws) {
  Json array = Json::array();
  for (const GrowthLaw& law : laws) {
    array.push_back({{"algorithm", law.algorithm},
                     {"algorithm_parameters", law.algorithm_parameters},
                     {"parameters", law.parameters},
                     {"measure", law.kind == GrowthLaw::Kind::power ? "exponent" : "alpha"},
                     {"lowest", law.lowest},
                     {"highest", law.highest},
                     {"min_n", law.min_n},
                     {"max_n", law.max_n}});
  }
  return array;
}

// Never fails on bytes that are no UTF-8 (a file name in a parameter): they are replaced.
std::string text_of(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n'; }

}  // namespace

std::string to_json(const SolveOutput& output) {
  const RatedRun& run = output.run;
  Json phases = Json::object();
  for (const auto& [name, seconds] : run.phases) phases[name] = phases.value(name, 0.0) + seconds;
  Json counters = Json::object();
  for (const auto& [name, value] : run.counters) counters[name] = value;
  Json json;
  json["algorithm"] = output.algorithm;
  json["parameters"] = output.parameters;
  json["seed"] = output.seed;
  json["threads"] = output.threads;
  json["n"] = output.n;
  json["distinct"] = output.distinct;
  json["duplicates"] = output.duplicates;
  json["hull_size"] = output.hull_size;
  json["triangles"] = or_null(run.triangles);
  json["edges"] = or_null(run.edges);
  json["weight_lower"] = or_null(run.weight_lower);
  json["weight_upper"] = or_null(run.weight_upper);
  json["perimeter_sum"] = or_null(run.perimeter_sum);
  json["count"] = run.triangulation_count.empty() ? Json() : Json(run.triangulation_count);
  json["stopped_early"] = run.stop_reason.has_value();
  json["stop_reason"] = run.stop_reason ? Json(name_of(*run.stop_reason)) : Json();
  json["optimum_lower"] = or_null(run.optimum_lower);
  json["optimum_upper"] = or_null(run.optimum_upper);
  json["optimality"] = run.optimality.empty() ? "none" : run.optimality;
  json["optimum_cached"] = output.optimum_cached;
  json["alpha_lower"] = or_null(run.alpha_lower);
  json["alpha_upper"] = or_null(run.alpha_upper);
  json["valid"] = run.checker == "ok";
  json["wall_time_s"] = or_null(run.wall_time_s);
  json["cpu_time_s"] = or_null(run.cpu_time_s);
  json["peak_rss_bytes"] = or_null(run.peak_rss_bytes);
  json["phases"] = phases;
  json["counters"] = counters;
  return text_of(json);
}

std::string to_json(std::span<const AlgorithmInfo> algorithms) {
  Json array = Json::array();
  for (const AlgorithmInfo& info : algorithms) {
    array.push_back({{"name", info.name},
                     {"summary", info.summary},
                     {"source", info.source},
                     {"guarantee", info.guarantee},
                     {"time", info.time},
                     {"space", info.space},
                     {"exact", info.exactness == Exactness::exact},
                     {"max_n", info.max_n},
                     {"parameters", json_of(info.parameters)}});
  }
  return text_of(array);
}

std::string to_json(std::span<const GeneratorInfo> generators) {
  Json array = Json::array();
  for (const GeneratorInfo& info : generators) {
    array.push_back({{"name", info.name},
                     {"summary", info.summary},
                     {"source", info.source},
                     {"stresses", info.stresses},
                     {"law", info.law},
                     {"min_n", info.min_n},
                     {"max_n", info.max_n},
                     {"fixed_n", info.fixed_n == 0 ? Json() : Json(info.fixed_n)},
                     {"seeded", info.seeded},
                     {"parameters", json_of(info.parameters)},
                     {"growth_laws", json_of(info.growth_laws)}});
  }
  return text_of(array);
}

std::string to_json(std::span<const StudyEntry> studies) {
  Json array = Json::array();
  for (const StudyEntry& entry : studies) {
    array.push_back({{"name", entry.name}, {"summary", entry.summary}, {"file", entry.file}});
  }
  return text_of(array);
}

}  // namespace mwt
