// Executes a plan: instance by instance its optimum, then its runs, each in a process of its own.
#pragma once

#include "harness/io/progress.h"
#include "harness/rating/optimum_cache.h"
#include "harness/records/results_folder.h"
#include "harness/run/catalogue.h"
#include "harness/study/plan.h"
#include "harness/study/rows.h"
#include "harness/study/study_results.h"

namespace mwt {

/// Makes every instance that something is missing of, once; seeks its optimum unless its row has one, then executes its
/// missing runs; adds every row to `results`. With more than one job, instances overlap. An instance whose recorded
/// optimum was disproved meanwhile is made again in the end, and its optimum sought. Returns early, without losing a
/// row, when an interrupt is requested. `cache` may be null.
void execute_plan(const Plan& plan, const Catalogue& catalogue, const RowContext& context, const ResultsFolder& folder,
                  int jobs, OptimumCache* cache, Progress& progress, StudyResults& results);

}  // namespace mwt
