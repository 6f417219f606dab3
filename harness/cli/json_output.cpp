#include "harness/cli/json_output.h"

#include <nlohmann/json.hpp>

namespace mwt {

namespace {

using Json = nlohmann::ordered_json;

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}
Json lower_or_null(const std::optional<Interval>& interval) { return interval ? Json(interval->lower) : Json(); }
Json upper_or_null(const std::optional<Interval>& interval) { return interval ? Json(interval->upper) : Json(); }

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

std::string to_json(const SolveReport& report) {
  Json phases = Json::object();
  for (const auto& [name, seconds] : report.phases) phases[name] = phases.value(name, 0.0) + seconds;
  Json json;
  json["algorithm"] = report.algorithm;
  json["parameters"] = report.parameters;
  json["seed"] = report.seed;
  json["threads"] = report.threads;
  json["n"] = report.n;
  json["distinct"] = report.distinct;
  json["duplicates"] = report.duplicates;
  json["hull_size"] = report.hull_size;
  json["triangles"] = report.triangles;
  json["edges"] = or_null(report.edges);
  json["weight_lower"] = lower_or_null(report.weight);
  json["weight_upper"] = upper_or_null(report.weight);
  json["perimeter_sum"] = or_null(report.perimeter_sum);
  json["count"] = or_null(report.count);
  json["stopped_early"] = report.stop_reason.has_value();
  json["stop_reason"] = report.stop_reason ? Json(name_of(*report.stop_reason)) : Json();
  json["optimum_lower"] = lower_or_null(report.optimum);
  json["optimum_upper"] = upper_or_null(report.optimum);
  json["optimality"] = report.optimality;
  json["optimum_cached"] = report.optimum_cached;
  json["alpha_lower"] = lower_or_null(report.alpha);
  json["alpha_upper"] = upper_or_null(report.alpha);
  json["valid"] = report.valid;
  json["wall_time_s"] = report.wall_time_s;
  json["cpu_time_s"] = report.cpu_time_s;
  json["peak_rss_bytes"] = report.peak_rss_bytes;
  json["phases"] = phases;
  json["counters"] = report.counters;
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
