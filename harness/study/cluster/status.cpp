#include "harness/study/cluster/status.h"

#include <fmt/core.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "base/error.h"
#include "harness/io/input_file.h"
#include "harness/io/text/aligned_table.h"
#include "harness/io/text/text.h"
#include "harness/records/environment.h"
#include "harness/records/results_folder.h"

namespace mwt {

namespace {

// What one shard has recorded.
struct ShardRecords {
  StudyRecords records;
  std::map<std::string, std::size_t> runs_of;  // by label of the instance
  std::set<std::string> sought;                // labels of instances that have a row

  explicit ShardRecords(const std::optional<std::string>& attempt) {
    if (attempt) records = read_records(*attempt);
    std::set<std::string> ids;
    for (const InstanceRecord& record : records.instances) {
      ids.insert(record.instance_id);
      sought.insert(label_of_instance(record));
    }
    for (const RunRecord& record : records.runs) {
      ++runs_of[label_of_instance(record)];
      if (ids.contains(record.instance_id)) sought.insert(label_of_instance(record));  // equal points, another label
    }
  }

  [[nodiscard]] std::size_t runs(const std::string& label) const {
    const auto found = runs_of.find(label);
    return found == runs_of.end() ? 0 : found->second;
  }
};

double seconds_of(const std::string& utc) {
  std::tm time{};
  return strptime(utc.c_str(), "%Y-%m-%dT%H:%M:%SZ", &time) == nullptr ? 0 : static_cast<double>(timegm(&time));
}

// How much longer than estimated the last attempt takes, by its own clock; 1 as long as that is anybody's guess.
double slowness(const ShardRecords& shard, const std::vector<ShardRow>& rows) {
  constexpr double kLeastTime = 5;      // s
  constexpr double kLeastShare = 0.02;  // of the shard
  if (shard.records.environments.empty()) return 1;
  const EnvironmentRecord& last = shard.records.environments.back();
  double now = 0;
  std::map<std::string, std::size_t> runs_of;
  for (const RunRecord& run : shard.records.runs) {
    if (run.env_id != last.env_id) continue;
    ++runs_of[label_of_instance(run)];
    now = std::max(now, seconds_of(run.recorded_at));
  }
  std::set<std::string> sought;
  for (const InstanceRecord& instance : shard.records.instances) {
    if (instance.env_id != last.env_id) continue;
    sought.insert(label_of_instance(instance));
    now = std::max(now, seconds_of(instance.recorded_at));
  }
  double estimated = 0, whole = 0;
  for (const ShardRow& row : rows) {
    const std::string label = label_of_instance(row);
    whole += row.search_s + row.runs_s;
    if (sought.contains(label)) estimated += row.search_s;
    if (const auto runs = runs_of.find(label); runs != runs_of.end()) {
      estimated += row.runs_s * static_cast<double>(runs->second) / static_cast<double>(row.runs);
    }
  }
  const double elapsed = now - seconds_of(last.recorded_at);
  return elapsed < kLeastTime || estimated <= kLeastShare * whole ? 1 : elapsed / estimated;
}

// The last line that a task printed.
std::string last_line(const std::string& log) {
  std::string last;
  if (!std::filesystem::exists(log)) return last;
  for (const std::string& line : split(read_file(log), '\n')) {
    if (!line.empty()) last = one_line(line);
  }
  return last;
}

std::string reason_of_waiting(const SlurmState& state, bool seeks_optima) {
  if (state.reason == "Dependency") return seeks_optima ? "for another job" : "for its optima";
  if (state.reason == "BeginTime") return "queued again, for a moment later";
  if (state.reason == "Resources" || state.reason == "Priority") return "for a free node";
  return state.reason;
}

std::string reason_of_end(const SlurmState& state) {
  if (state.state == "CANCELLED") return "cancelled";
  if (state.state == "TIMEOUT" || state.state == "DEADLINE") return "killed at its time limit";
  if (state.state == "NODE_FAIL" || state.state == "BOOT_FAIL") return "its node failed";
  if (state.state == "OUT_OF_MEMORY") return "the node's memory limit: more --mem";
  if (state.state == "PREEMPTED") return "preempted";
  return "";
}

class StatusReader {
 public:
  explicit StatusReader(const ClusterFolder& folder) : folder_(folder), jobs_(folder.jobs()) {
    std::vector<std::string> ids;
    for (const JobRow& job : jobs_) ids.push_back(job.job_id);
    try {
      states_ = states_of(ids);
    } catch (const InputError& error) {
      status_.warning = error.what();
    }
  }

  ClusterStatus read() {
    for (const ShardRow& row : folder_.rows()) rows_of_[row.shard].push_back(row);
    for (std::size_t shard = 1; shard <= folder_.settings().shards; ++shard)
      status_.shards.push_back(status_of_shard(shard));
    status_.is_merged = std::filesystem::exists(folder_.file("merged/runs.csv"));
    std::set<std::string> live;
    for (const auto& [id, state] : states_) {
      if (state.is_live()) live.insert(id.first);
    }
    for (const JobRow& job : jobs_) {
      if (live.contains(job.job_id)) status_.live_jobs.push_back(job.job_id);
      if (job.kind != JobKind::merge) continue;
      status_.merge_job = job;
      const auto state = states_.find({job.job_id, 0});
      status_.merge_state = state == states_.end() ? std::nullopt : std::optional(state->second);
    }
    return std::move(status_);
  }

 private:
  struct Task {
    JobRow job;
    std::optional<SlurmState> state;
  };

  // Of the shard, in the order of their submission.
  [[nodiscard]] std::vector<Task> tasks_of(std::size_t shard) const {
    std::vector<Task> tasks;
    for (const JobRow& job : jobs_) {
      if (job.kind == JobKind::merge || !job.has_task(shard)) continue;
      const auto state = states_.find({job.job_id, shard});
      tasks.push_back({job, state == states_.end() ? std::nullopt : std::optional(state->second)});
    }
    return tasks;
  }

  [[nodiscard]] ShardStatus status_of_shard(std::size_t shard) {
    ShardStatus status;
    status.number = shard;
    const std::optional<std::string> attempt = folder_.last_attempt(shard);
    count(status, attempt);
    status.state = attempt ? ShardState::begun : ShardState::not_begun;
    judge(status, tasks_of(shard), attempt ? end_of_attempt(*attempt).value_or("") : "");
    if (status.runs == status.planned_runs) {
      status.state = ShardState::done;
      status.why.clear();
    }
    return status;
  }

  void count(ShardStatus& status, const std::optional<std::string>& attempt) {
    const ShardRecords recorded(attempt);
    const std::vector<ShardRow>& rows = rows_of_[status.number];
    for (const ShardRow& row : rows) {
      const std::string label = label_of_instance(row);
      const std::size_t runs = recorded.runs(label);
      const bool is_sought = runs == row.runs || recorded.sought.contains(label);
      ++status.instances;
      status.optima += is_sought ? 1 : 0;
      status.planned_runs += row.runs;
      status.runs += runs;
      if (!is_sought) status.left_s += row.search_s;
      if (row.runs > 0)
        status.left_s += row.runs_s * static_cast<double>(row.runs - runs) / static_cast<double>(row.runs);
    }
    status.left_s *= slowness(recorded, rows);
    if (!recorded.records.environments.empty()) status.machine = machine_of(recorded.records.environments.back());
  }

  void judge(ShardStatus& status, const std::vector<Task>& tasks, const std::string& end) const {
    if (tasks.empty() || !status_.warning.empty()) return;
    const auto live = std::ranges::find_if(tasks, [](const Task& task) { return task.state && task.state->is_live(); });
    if (live != tasks.end()) {
      status.is_live = true;
      status.is_ending = live->state->is_ending();
      status.seeks_optima = live->job.kind == JobKind::optima;
      status.node = live->state->node;
      status.state = live->state->is_pending() ? ShardState::waiting : ShardState::running;
      if (live->state->is_pending()) status.why = reason_of_waiting(*live->state, status.seeks_optima);
      return;
    }
    // That of the runs ends with "cancelled" when that of its optima has failed: the latter says why.
    status.state = ShardState::failed;
    for (const Task& task : tasks) {
      if (!task.state || task.state->state == "COMPLETED") continue;
      if (task.job.kind == JobKind::runs && status.lacks_optima() && !status.why.empty()) continue;
      status.node = task.state->node;
      status.why = reason_of_end(*task.state);
      if (status.why.empty()) status.why = reason_in_files(status.number, task.job.kind, end);
    }
    if (status.why.empty()) status.why = end.empty() ? "ended without a word: killed, or its node failed" : end;
  }

  [[nodiscard]] std::string reason_in_files(std::size_t shard, JobKind kind, const std::string& end) const {
    if (!end.empty()) return end;
    const std::string line = last_line(folder_.file(fmt::format("logs/{}-{}.log", to_text(kind), shard)));
    return line.empty() ? "it failed" : line;
  }

  const ClusterFolder& folder_;
  std::vector<JobRow> jobs_;
  SlurmStates states_;
  std::map<std::size_t, std::vector<ShardRow>> rows_of_;
  ClusterStatus status_;
};

std::string state_text(const ShardStatus& shard) {
  switch (shard.state) {
    case ShardState::not_begun: return "not begun";
    case ShardState::begun: return "begun";
    case ShardState::waiting: return "waiting";
    case ShardState::running: return shard.seeks_optima ? "seeking" : "running";
    case ShardState::done: return "done";
    case ShardState::failed: return "failed";
  }
  return "";
}

std::string share(std::size_t part, std::size_t whole) { return fmt::format("{}/{}", part, whole); }

std::string table_of(const ClusterFolder& folder, const ClusterStatus& status, std::optional<std::size_t> width) {
  AlignedTable table({"shard", "state", "optima", "runs", "left", "node", ""}, {1, 5, 6});
  for (const ShardStatus& shard : status.shards) {
    const bool is_done = shard.state == ShardState::done;
    table.add_row({std::to_string(shard.number), state_text(shard),
                   folder.settings().seeks_optimum ? share(shard.optima, shard.instances) : "-",
                   share(shard.runs, shard.planned_runs), is_done ? "" : readable_duration(shard.left_s), shard.node,
                   shard.why});
  }
  return table.text_within(width);
}

// Broken at blanks into lines of `width` characters, those after the first indented.
std::string folded(const std::string& text, std::optional<std::size_t> width) {
  std::string lines;
  std::size_t begin = 0;
  for (const std::string& word : split(text, ' ')) {
    if (width && lines.size() > begin && lines.size() - begin + word.size() >= *width) {
      begin = lines.size() + 1;
      lines += "\n ";
    }
    lines += (lines.empty() ? "" : " ") + word;
  }
  return lines + '\n';
}

std::string merge_text(const ClusterFolder& folder, const ClusterStatus& status) {
  if (status.is_merged) return "merged: " + folder.file("merged");
  if (!status.merge_state) return status.has_all_runs() ? "not merged yet" : "";
  const SlurmState& state = *status.merge_state;
  if (state.is_pending()) return "merging: waits for the shards";
  if (state.is_live()) return "merging: runs";
  if (!status.has_all_runs()) return "merging: refused, for runs are missing";
  const std::string line = last_line(folder.file("logs/merge.log"));
  return "merging: failed" + (line.empty() ? "" : ": " + line);
}

std::string advice(const ClusterFolder& folder, const ClusterStatus& status) {
  if (status.is_merged) return "";
  if (status.live_jobs.empty() && status.has_all_runs())
    return "next: mwt cluster merge " + shell_word(folder.path()) + '\n';
  const auto failed = std::ranges::count(status.shards, ShardState::failed, &ShardStatus::state);
  if (failed == 0) return "";
  return fmt::format("{} failed; what is missing of them runs after:\n  mwt cluster resubmit {}\n",
                     counted(static_cast<std::size_t>(failed), "shard"), shell_word(folder.path()));
}

}  // namespace

bool ClusterStatus::has_all_runs() const {
  return std::ranges::all_of(shards, [](const ShardStatus& shard) { return shard.runs == shard.planned_runs; });
}

// script_text() refuses paths with quotes.
std::string shell_word(const std::string& path) {
  return path.find(' ') == std::string::npos ? path : '"' + path + '"';
}

ClusterStatus status_of(const ClusterFolder& folder) { return StatusReader(folder).read(); }

std::string status_text(const ClusterFolder& folder, const ClusterStatus& status, std::optional<std::size_t> width) {
  std::size_t runs = 0, planned_runs = 0, optima = 0, instances = 0;
  double longest = 0;
  std::map<std::string, std::size_t> machines;
  for (const ShardStatus& shard : status.shards) {
    runs += shard.runs;
    planned_runs += shard.planned_runs;
    optima += shard.optima;
    instances += shard.instances;
    if (shard.state != ShardState::done) longest = std::max(longest, shard.left_s);
    if (!shard.machine.empty()) ++machines[shard.machine];
  }
  std::string text = fmt::format("study {}: {} of {} runs", folder.settings().study, runs, planned_runs);
  if (folder.settings().seeks_optimum) text += fmt::format(", {} of {} optima", optima, instances);
  if (longest > 0) text += fmt::format("\nthe longest shard needs about {} more", readable_duration(longest));
  text += "\n\n" + table_of(folder, status, width) + '\n';
  if (machines.size() > 1) {
    text += "nodes of several kinds; reports take times from the one with most runs:\n";
    for (const auto& [machine, shards] : machines) text += fmt::format("  {}: {}\n", machine, counted(shards, "shard"));
  }
  if (!status.warning.empty()) {
    text += folded("Slurm does not answer, so states are those of the records: " + status.warning, width);
  }
  const std::string merging = merge_text(folder, status);
  if (!merging.empty()) text += folded(merging, width);
  return text + advice(folder, status);
}

}  // namespace mwt
