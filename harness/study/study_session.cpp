#include "harness/study/study_session.h"

#include <algorithm>
#include <utility>

#include "base/error.h"
#include "harness/run/interrupt.h"
#include "harness/run/machine/environment.h"

namespace mwt {

namespace {

constexpr std::chrono::milliseconds kPatience{200};

Plan shard_of(const Plan& whole, const Shard& shard, std::set<std::string>& ids_of_all) {
  ids_of_all = run_ids_of(whole);
  return part_of(whole, shard);
}

}  // namespace

InstanceMaker::InstanceMaker(const Plan& plan, const std::vector<InstanceRecord>& recorded) : plan_(plan) {
  for (const InstanceRecord& record : recorded) recorded_ids_[label_of_instance(record)] = record.instance_id;
}

std::shared_ptr<const Instance> InstanceMaker::make(std::size_t position) {
  if (last_ && position == last_position_) return last_;
  const PlannedInstance& planned = plan_.instances[position];
  auto made = std::make_shared<const Instance>(make_instance(planned.make_points(), planned.label()));
  const bool is_as_planned = planned.file_instance_id.empty() || made->id == planned.file_instance_id;
  if (!is_as_planned) throw InputError(planned.label() + ": the file has changed while the study ran");
  const auto recorded = recorded_ids_.find(planned.label());
  if (recorded != recorded_ids_.end() && made->id != recorded->second) {
    throw InputError(planned.label() + ": these are other points than those that were recorded under this name");
  }
  last_ = std::move(made);
  last_position_ = position;
  return last_;
}

StudySession::StudySession(const Study& the_study, const Catalogue& the_catalogue, const RunOptions& the_options,
                           std::ostream& the_out)
    : study(the_study),
      catalogue(the_catalogue),
      options(the_options),
      out(the_out),
      plan(shard_of(make_plan(study, catalogue), options.shard, planned_ids)),
      folder(options.folder, study, options.resume),
      environment(describe_environment(study.name, options.jobs, options.shard.text())),
      instances(plan, folder.instances()) {
  if (!options.cache_folder) return;
  cache.emplace(*options.cache_folder, [this](const std::string& warning) { announce("warning: " + warning); });
}

void StudySession::announce(const std::string& line) {
  if (progress != nullptr) {
    progress->announce(line);
  } else {
    out << "  " << line << '\n';
  }
}

void StudySession::settle(const std::string& instance_id, const std::string& label,
                          const std::vector<Disproof>& disproofs) {
  if (disproofs.empty()) return;
  double weight = disproofs.front().weight;
  for (const Disproof& disproof : disproofs) {
    ++outcome.contradictions;
    announce(label + ": " + disproof.text());
    weight = std::min(weight, disproof.weight);
    if (disproof.claim.id == instance_id) to_seek_again.insert(instance_id);
  }
  const auto discarded = cache ? cache->discard_disproved(instance_id, weight) : std::vector<std::string>();
  for (const std::string& path : discarded) announce("thrown out of the optimum cache: " + path);
  folder.settle(instance_id);
}

bool wait_for_room(ProcessPool& pool, Progress& progress) {
  while (pool.is_full() && !InterruptWatch::requested()) {
    pool.wait(kPatience);
    progress.refresh();
  }
  return !pool.is_full() && !InterruptWatch::requested();
}

void wait_for_all(ProcessPool& pool, Progress& progress) {
  while (!pool.is_empty() && !InterruptWatch::requested()) {
    pool.wait(kPatience);
    progress.refresh();
  }
  progress.finish();
}

}  // namespace mwt
