#include "harness/study/study_session.h"

#include <algorithm>

#include "harness/environment.h"
#include "harness/study/interrupt.h"

namespace mwt {

namespace {

constexpr std::chrono::milliseconds kPatience{200};

}  // namespace

std::shared_ptr<const Instance> InstanceMaker::make(std::size_t position) {
  if (!last_ || position != last_position_) {
    const PlannedInstance& planned = plan_.instances[position];
    last_ = std::make_shared<const Instance>(make_instance(planned.make_points(), planned.label()));
    last_position_ = position;
  }
  return last_;
}

StudySession::StudySession(const Study& the_study, const Catalogue& the_catalogue, const RunOptions& the_options,
                           std::ostream& the_out)
    : study(the_study),
      catalogue(the_catalogue),
      options(the_options),
      out(the_out),
      plan(part_of(make_plan(study, catalogue), options.shard)),
      folder(options.folder, study, options.resume),
      environment(describe_environment(study.name, options.jobs, options.shard.text())),
      instances(plan) {
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
