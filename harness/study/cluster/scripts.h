// The scripts that Slurm runs.
#pragma once

#include <string>

#include "harness/study/cluster/cluster_folder.h"
#include "harness/study/cluster/slurm.h"
#include "harness/study/study.h"

namespace mwt {

/// The file names of the scripts, within the folder.
[[nodiscard]] std::string script_name(JobKind kind);

/// The script of a kind of job, whose options are those of `request` and what the study's limits call for. Throws
/// InputError: the folder's path holds characters that sbatch or a shell would not take literally.
[[nodiscard]] std::string script_text(JobKind kind, const std::string& folder, const Study& study,
                                      const SlurmRequest& request);

}  // namespace mwt
