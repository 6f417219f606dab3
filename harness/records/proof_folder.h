// The proofs of a study's optima: the folder proofs/ within its results.
#pragma once

#include <string>
#include <vector>

#include "harness/records/records.h"

namespace mwt {

/// Where the proof of the instance's optimum lies in the results folder, if it has one.
[[nodiscard]] std::string proof_file(const std::string& results_folder, const std::string& instance_id);

/// Makes the folder for proofs, and removes what killed writers left there. Precondition: no other process writes there
/// (FolderLock). Throws InputError: it cannot be made.
void prepare_proof_folder(const std::string& results_folder);

/// Copies the proofs of these instances from the first of the results folders that has them. Throws InputError: a copy
/// cannot be written.
void copy_proofs(const std::vector<std::string>& from, const std::string& to,
                 const std::vector<InstanceRecord>& instances);

}  // namespace mwt
