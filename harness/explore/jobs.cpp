#include "harness/explore/jobs.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/explore/played_run.h"
#include "harness/explore/proved_run.h"
#include "harness/explore/read_content.h"
#include "harness/explore/shown_runs.h"
#include "harness/hunt/climber.h"
#include "harness/io/points/point_file.h"
#include "harness/run/process_pool.h"
#include "harness/run/start_triangulation.h"

namespace mwt {

namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

// The value of a key, or an InputError that names it.
template <class Value>
Value value_of(const Json& json, const char* key) {
  try {
    return json.at(key).get<Value>();
  } catch (const Json::exception&) {
    throw InputError(fmt::format("the request has no usable '{}'", key));
  }
}

template <class Value>
Value value_of(const Json& json, const char* key, const Value& otherwise) {
  return json.contains(key) ? value_of<Value>(json, key) : otherwise;
}

// Seeds are texts: JavaScript's numbers end at 2^53.
std::uint64_t seed_of(const Json& json) {
  const auto text = value_of<std::string>(json, "seed", "1");
  const auto seed = parse_whole_number<std::uint64_t>(text);
  if (!seed) throw InputError("the seed '" + text + "' is not a whole number from 0 to 18446744073709551615");
  return *seed;
}

std::map<std::string, std::string> parameters_of(const Json& json) {
  return value_of<std::map<std::string, std::string>>(json, "parameters", {});
}

class Job {
 public:
  Job(const Catalogue& catalogue, const JobLimits& limits, const JobAnswer& answer)
      : catalogue_(catalogue), limits_(limits), answer_(answer), pool_(1) {}

  void run(const Frame& request) {
    const Json json = parsed(request.json);
    const auto job = value_of<std::string>(json, "job");
    if (job == "generate") {
      generate(json);
    } else if (job == "open") {
      open(json, request.bytes);
    } else if (job == "solve") {
      solve(json, request.bytes);
    } else if (job == "play") {
      play(json, request.bytes);
    } else if (job == "prove") {
      prove(json, request.bytes);
    } else if (job == "hunt") {
      hunt(json);
    } else {
      throw InputError("unknown job '" + job + "'; known: generate, open, solve, play, prove, hunt");
    }
    answer_.send({R"({"type":"end"})", ""});
  }

 private:
  static Json parsed(const std::string& text) {
    Json json = Json::parse(text, nullptr, false);
    if (!json.is_object()) throw InputError("the request is no JSON object");
    return json;
  }

  // Until everything that was started has ended; or the job ends, when its page has gone.
  void wait() {
    while (!pool_.is_empty()) {
      pool_.wait(std::chrono::milliseconds(20));
      answer_.require_reader();
    }
  }

  void generate(const Json& json) {
    const GeneratorInfo& family = catalogue_.generator(value_of<std::string>(json, "family"));
    const Parameters parameters(family.name, family.parameters, parameters_of(json));
    const auto n = value_of<std::uint64_t>(json, "n");
    require_moderate(n);
    const std::uint64_t seed = seed_of(json);
    send_points([&] { return generate_points(family, static_cast<Index>(n), seed, parameters); });
  }

  void open(const Json& json, const std::string& content) {
    const auto name = value_of<std::string>(json, "name");
    send_points([&] { return read_content(name, content); });
  }

  void require_moderate(std::uint64_t n) const {
    if (n > limits_.max_n) throw InputError(fmt::format("{} points; the explorer takes at most {}", n, limits_.max_n));
  }

  // Points from work that may take long or fail, under limits.
  void send_points(const std::function<std::vector<Point>()>& make) {
    constexpr char kGood = 'g', kBad = 'b';
    const auto work = [&]() -> std::string {
      try {
        return kGood + bytes_of(make());
      } catch (const InputError& error) {
        return kBad + std::string(error.what());
      } catch (const std::bad_alloc&) {
        return kBad + std::string("there is not enough memory for these points");
      }
    };
    ProcessResult result;
    pool_.start(work, {limits_.points_time_s, limits_.points_time_s, limits_.memory_bytes},
                [&](const ProcessResult& ended) { result = ended; });
    wait();
    if (result.end == ProcessEnd::stopped_at_limit)
      throw InputError(fmt::format("the points were not there within {} s", limits_.points_time_s));
    if (result.end != ProcessEnd::finished) throw InputError("the points could not be made: " + result.how);
    std::string bytes = result.output.substr(1);
    if (result.output.front() == kBad) throw InputError(bytes);
    require_moderate(bytes.size() / sizeof(Point));
    answer_.send({text_of({{"type", "points"}, {"n", bytes.size() / sizeof(Point)}}), std::move(bytes)});
  }

  Request request_of(const Json& json, std::uint64_t seed, double time_limit_s) const {
    const AlgorithmInfo& info = catalogue_.algorithm(value_of<std::string>(json, "name"));
    Request request;
    request.algorithm = &info;
    request.parameters = Parameters(info.name, info.parameters, parameters_of(json));
    if (start_file_of(info, request.parameters))
      throw InputError(info.name + ": the explorer starts from a named triangulation, not from a file");
    request.seed = seed;
    request.time_limit_s = time_limit_s;
    return request;
  }

  [[nodiscard]] std::vector<Point> moderate_points(const std::string& bytes) const {
    std::optional<std::vector<Point>> points = points_in(bytes);
    if (!points) throw InputError("the request's bytes are no points");
    require_moderate(points->size());
    return *std::move(points);
  }

  [[nodiscard]] double time_limit_of(const Json& json) const {
    const auto time_limit_s = value_of<double>(json, "time_limit_s", std::min(10.0, limits_.max_time_s));
    if (time_limit_s > 0 && time_limit_s <= limits_.max_time_s) return time_limit_s;
    throw InputError(fmt::format("the time limit must be above 0 and at most {} s", limits_.max_time_s));
  }

  void solve(const Json& json, const std::string& bytes) {
    const std::vector<Point> points = moderate_points(bytes);
    const double time_limit_s = time_limit_of(json);
    const std::uint64_t seed = seed_of(json);
    std::vector<Request> requests;
    for (const Json& algorithm : value_of<Json>(json, "algorithms"))
      requests.push_back(request_of(algorithm, seed, time_limit_s));
    constexpr std::size_t kMaxAlgorithms = 2;
    if (requests.size() > kMaxAlgorithms) throw InputError("the explorer runs at most two algorithms at once");
    const bool with_optimum = value_of<bool>(json, "optimum", true);

    const Instance instance = make_instance(points, "these points");
    send_instance(instance);
    const RunLimits run_limits = run_limits_for(time_limit_s);
    ShownRuns shown(catalogue_, instance, run_limits);
    for (const Request& request : requests) {
      shown.run(pool_, request, [&] { wait(); });
      send_run(shown, shown.runs().size() - 1);
    }
    if (with_optimum) {
      shown.seek_optimum(pool_, [&] { wait(); });
      send_optimum(shown);
    }
    shown.rate_all();
    for (std::size_t slot = 0; slot < shown.runs().size(); ++slot) {
      answer_.send({text_of({{"type", "rating"}, {"slot", slot}, {"run", json_of(shown.runs()[slot].run)}}), ""});
    }
  }

  [[nodiscard]] RunLimits run_limits_for(double time_limit_s) const {
    RunLimits run_limits;
    run_limits.time_s = time_limit_s;
    run_limits.memory_bytes = limits_.memory_bytes;
    return run_limits;
  }

  void play(const Json& json, const std::string& bytes) {
    const std::vector<Point> points = moderate_points(bytes);
    if (points.size() > limits_.max_played_n)
      throw InputError(
          fmt::format("{} points; at most {} are played step by step", points.size(), limits_.max_played_n));
    const double time_limit_s = time_limit_of(json);
    Request request = request_of(value_of<Json>(json, "algorithm"), seed_of(json), time_limit_s);
    const Instance instance = make_instance(points, "these points");
    send_instance(instance);
    RatedRun run;
    std::string sent;
    start_played_run(pool_, request, instance, run_limits_for(time_limit_s), [&](RatedRun ended, std::string enclosed) {
      run = std::move(ended);
      sent = std::move(enclosed);
    });
    wait();
    if (run.status != RunStatus::ok)
      throw InputError(request.algorithm->name + ": " + std::string(name_of(run.status)) + ", " + run.message);
    const std::optional<Frame> trace = decoded(sent);
    if (!trace) throw InputError(request.algorithm->name + " has no steps to show on these points");
    answer_.send(*trace);
  }

  void prove(const Json& json, const std::string& bytes) {
    const double time_limit_s = time_limit_of(json);
    Request request = request_of(value_of<Json>(json, "algorithm"), seed_of(json), time_limit_s);
    const std::string& name = request.algorithm->name;
    if (!request.algorithm->has_proofs)
      throw InputError(name + " writes no proofs; exact is one of the algorithms that do");
    const Instance instance = make_instance(moderate_points(bytes), "these points");
    std::string proof;
    start_proved_run(pool_, request, instance, run_limits_for(time_limit_s),
                     [&proof](const RatedRun&, std::string enclosed) { proof = std::move(enclosed); });
    wait();
    if (proof.empty()) throw InputError(name + " has not proved anything within its limits");
    answer_.send({R"({"type":"proof"})", std::move(proof)});
  }

  // In this process: many short runs, none worth a process. What goes wrong ends the job alone.
  void hunt(const Json& json) {
    constexpr std::uint64_t kMinN = 4, kMaxN = 60;
    const auto n = value_of<std::uint64_t>(json, "n");
    if (n < kMinN || n > kMaxN) throw InputError(fmt::format("a hunt is for {} to {} points", kMinN, kMaxN));
    const double budget_s = time_limit_of(json);
    const Request request = request_of(value_of<Json>(json, "algorithm"), 1, budget_s);
    const AlgorithmInfo& solver = solver_for_hunt(catalogue_, static_cast<Index>(n));
    const AlphaOracle oracle(request, solver);
    Climber climber(oracle, static_cast<Index>(n), seed_of(json), 0);
    try {
      climb(climber, budget_s);
    } catch (const std::logic_error& failure) {  // an invalid triangulation, or an optimum that is none
      throw InputError(failure.what());
    }
  }

  // Tells the worst instance so far, about five times a second while it becomes worse, and what was tried.
  void climb(Climber& climber, double budget_s) {
    using Clock = std::chrono::steady_clock;
    constexpr auto kPause = std::chrono::milliseconds(200);
    const Clock::time_point end =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(budget_s));
    Clock::time_point next = Clock::now();
    double told = 0;
    bool goes_on = true;
    while (goes_on) {
      climber.step();
      answer_.require_reader();
      goes_on = Clock::now() < end;
      if (goes_on && Clock::now() < next) continue;
      next = Clock::now() + kPause;
      const ClimberState& state = climber.state();
      const bool is_worse = state.best.alpha > told;
      told = state.best.alpha;
      answer_.send({text_of({{"type", "hunted"}, {"alpha", told}, {"evaluations", state.evaluations}}),
                    is_worse ? bytes_of(state.best.points) : ""});
    }
  }

  void send_instance(const Instance& instance) const {
    answer_.send({text_of({{"type", "instance"},
                           {"n", instance.set.input_count},
                           {"distinct", instance.set.points.size()},
                           {"duplicates", instance.set.duplicates()},
                           {"hull_size", instance.hull_size},
                           {"instance_id", instance.id}}),
                  ""});
  }

  void send_run(const ShownRuns& shown, std::size_t slot) const {
    const ShownRun& run = shown.runs()[slot];
    answer_.send({text_of({{"type", "run"},
                           {"slot", slot},
                           {"run", json_of(run.run)},
                           {"edges", run.run.edges.value_or(0)},
                           {"triangles", run.run.triangles.value_or(0)}}),
                  run.edges_and_triangles});
  }

  void send_optimum(const ShownRuns& shown) const {
    const ShownOptimum& optimum = shown.optimum();
    Json json = {{"type", "optimum"},
                 {"source", optimum.source},
                 {"status", name_of(optimality_of(optimum.interval))},
                 {"optimum_lower", optimum.interval ? Json(optimum.interval->lower) : Json()},
                 {"optimum_upper", optimum.interval ? Json(optimum.interval->upper) : Json()},
                 {"contradictions", optimum.contradictions},
                 {"note", optimum.note},
                 {"edges", 0},
                 {"triangles", 0}};
    if (optimum.witness) {
      const RatedRun& run = optimum.witness->run;
      json["wall_time_s"] = run.wall_time_s.value_or(0);
      json["edges"] = run.edges.value_or(0);
      json["triangles"] = run.triangles.value_or(0);
    }
    answer_.send({text_of(json), optimum.witness ? optimum.witness->edges_and_triangles : ""});
  }

  template <class Value>
  static Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
  }

  static Json json_of(const NamedNumbers& numbers) {
    Json json = Json::object();
    for (const auto& [name, number] : numbers) json[name] = json.value(name, 0.0) + number;
    return json;
  }

  static Json json_of(const RatedRun& run) {
    return {{"status", name_of(run.status)},
            {"checker", run.checker},
            {"message", run.message},
            {"wall_time_s", or_null(run.wall_time_s)},
            {"peak_rss_bytes", or_null(run.peak_rss_bytes)},
            {"weight_lower", or_null(run.weight_lower)},
            {"weight_upper", or_null(run.weight_upper)},
            {"optimum_lower", or_null(run.optimum_lower)},
            {"optimum_upper", or_null(run.optimum_upper)},
            {"optimality", run.optimality},
            {"alpha_lower", or_null(run.alpha_lower)},
            {"alpha_upper", or_null(run.alpha_upper)},
            {"optimal", run.optimal},
            {"perimeter_sum", or_null(run.perimeter_sum)},
            {"stop_reason", run.stop_reason ? Json(phrase_of(*run.stop_reason)) : Json()},
            {"counters", json_of(run.counters)}};
  }

  const Catalogue& catalogue_;
  const JobLimits& limits_;
  const JobAnswer& answer_;
  ProcessPool pool_;
};

}  // namespace

void do_job(const Catalogue& catalogue, const JobLimits& limits, const std::string& request, const JobAnswer& answer) {
  const auto fail = [&](const std::string& message) {
    answer.send({text_of({{"type", "error"}, {"message", message}}), ""});
  };
  const std::optional<Frame> frame = decoded(request);
  if (!frame) return fail("the request is no frame: two lengths, a JSON text and bytes");
  try {
    Job(catalogue, limits, answer).run(*frame);
  } catch (const InputError& error) {
    fail(error.what());
  } catch (const std::bad_alloc&) {
    fail("there is not enough memory for this");
  }
}

Frame points_frame(const std::string& name, Points points) {
  return {text_of({{"type", "points"}, {"n", points.size()}, {"name", name}}), bytes_of(points)};
}

}  // namespace mwt
