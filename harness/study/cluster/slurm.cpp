#include "harness/study/cluster/slurm.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

#include "base/error.h"
#include "base/number_text.h"
#include "harness/io/input_file.h"
#include "harness/io/text/text.h"
#include "harness/run/command/command_folder.h"
#include "harness/run/command/external_process.h"

namespace mwt {

namespace {

struct Answer {
  bool is_well = false;
  std::string output;
  std::string errors;
};

ProcessEndState run_where_slurm_is(const ProcessOrder& order) {
  try {
    return run_process(order);
  } catch (const InputError& error) {
    throw InputError(std::string(error.what()) + "; mwt cluster needs a login node of a Slurm cluster");
  }
}

Answer call(const std::vector<std::string>& words) {
  const CommandFolder folder;
  ProcessOrder order;
  order.words = words;
  order.input_file = "/dev/null";
  order.output_file = folder.file("output");
  order.error_file = folder.file("errors");
  const ProcessEndState end = run_where_slurm_is(order);
  return {end.exit_code == 0, read_file(order.output_file), read_file(order.error_file)};
}

std::string why(const Answer& answer) {
  std::vector<std::string> lines;
  for (const std::string& line : split(answer.errors, '\n')) {
    if (!line.empty()) lines.push_back(one_line(line));
  }
  return lines.empty() ? "it gives no reason" : joined(lines, "; ");
}

std::string call_or_throw(const std::vector<std::string>& words) {
  const Answer answer = call(words);
  if (!answer.is_well) throw InputError(words.front() + " failed: " + why(answer));
  return answer.output;
}

// The lines of a table without header, each with so many fields.
std::vector<std::vector<std::string>> fields_of(const std::string& output, std::size_t count) {
  std::vector<std::vector<std::string>> rows;
  for (const std::string& line : split(output, '\n')) {
    std::vector<std::string> fields = split(line, '|');
    if (fields.size() == count) rows.push_back(std::move(fields));
  }
  return rows;
}

std::size_t task_number(const std::string& text) { return parse_whole_number<std::size_t>(text).value_or(0); }

// Of jobs that have ended, squeue forgets those of more than some minutes ago.
void add_queue(SlurmStates& states, const std::set<std::string>& job_ids) {
  const std::string output = call_or_throw({"squeue", "--noheader", "--array", "--states=all",
                                            "--user=" + std::to_string(getuid()), "--format=%F|%K|%T|%r|%N|%L"});
  for (const std::vector<std::string>& fields : fields_of(output, 6)) {
    if (!job_ids.contains(fields[0])) continue;
    SlurmState state{fields[2], fields[3], fields[4], fields[5]};
    if (state.reason == "None") state.reason.clear();
    states[{fields[0], task_number(fields[1])}] = state;
  }
}

// Many clusters keep no accounts.
void add_accounts(SlurmStates& states, const std::set<std::string>& job_ids) {
  const Answer answer =
      call({"sacct", "--noheader", "--allocations", "--parsable2",
            "--jobs=" + joined({job_ids.begin(), job_ids.end()}, ","), "--format=JobID,State,NodeList"});
  if (!answer.is_well) return;
  for (const std::vector<std::string>& fields : fields_of(answer.output, 3)) {
    const std::vector<std::string> id = split(fields[0], '_');
    const std::string state = split(fields[1], ' ').front();  // "CANCELLED by 1000"
    states.try_emplace({id[0], id.size() > 1 ? task_number(id[1]) : 0}, SlurmState{state, "", fields[2], ""});
  }
}

}  // namespace

bool SlurmState::is_live() const {
  static constexpr std::array kLive = {"PENDING",  "RUNNING",       "CONFIGURING",  "COMPLETING", "SUSPENDED",
                                       "REQUEUED", "RESIZING",      "REQUEUE_HOLD", "STAGE_OUT",  "SIGNALING",
                                       "STOPPED",  "RESV_DEL_HOLD", "REQUEUE_FED"};
  return std::ranges::find(kLive, state) != kLive.end();
}

std::vector<std::string> SlurmRequest::words() const {
  std::vector<std::string> all;
  const auto add = [&](const char* option, const std::optional<std::string>& value) {
    if (value) all.push_back(fmt::format("--{}={}", option, *value));
  };
  add("partition", partition);
  add("time", time);
  add("mem", memory);
  add("constraint", constraint);
  add("account", account);
  add("qos", qos);
  if (exclusive) all.emplace_back("--exclusive");
  all.insert(all.end(), others.begin(), others.end());
  return all;
}

std::string submit_script(const std::vector<std::string>& options, const std::string& script) {
  std::vector<std::string> words = {"sbatch", "--parsable"};
  words.insert(words.end(), options.begin(), options.end());
  words.push_back(script);
  std::string output = call_or_throw(words);
  const std::string id = output.substr(0, output.find_first_of(";\n"));  // "123;cluster"
  if (!parse_whole_number<std::uint64_t>(id)) throw InputError("sbatch printed no job id but: " + one_line(output));
  return id;
}

SlurmStates states_of(const std::vector<std::string>& job_ids) {
  SlurmStates states;
  const std::set<std::string> ids(job_ids.begin(), job_ids.end());
  if (ids.empty()) return states;
  add_queue(states, ids);
  add_accounts(states, ids);
  return states;
}

void cancel_jobs(const std::vector<std::string>& job_ids) {
  std::vector<std::string> words = {"scancel"};
  words.insert(words.end(), job_ids.begin(), job_ids.end());
  static_cast<void>(call_or_throw(words));
}

// By array and task: the job id of one of the tasks is that of the whole array.
bool requeue_own_task() {
  const char* const array = std::getenv("SLURM_ARRAY_JOB_ID");
  const char* const task = std::getenv("SLURM_ARRAY_TASK_ID");
  if (array == nullptr || task == nullptr) return false;
  return call({"scontrol", "requeue", fmt::format("{}_{}", array, task)}).is_well;
}

}  // namespace mwt
