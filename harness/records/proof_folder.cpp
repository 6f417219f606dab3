#include "harness/records/proof_folder.h"

#include <filesystem>

#include "base/error.h"
#include "harness/io/input_file.h"
#include "harness/io/output_file.h"

namespace mwt {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "proofs";

}  // namespace

std::string proof_file(const std::string& results_folder, const std::string& instance_id) {
  return (fs::path(results_folder) / kFolder / (instance_id + ".mwtproof")).string();
}

void prepare_proof_folder(const std::string& results_folder) {
  const fs::path folder = fs::path(results_folder) / kFolder;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder, error)) {
    throw InputError(folder.string() +
                     ": cannot make this folder for proofs: " + (error ? error.message() : "a file is in its place"));
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    if (is_temporary_name(entry.path().filename().string())) fs::remove(entry.path(), error);
  }
}

void copy_proofs(const std::vector<std::string>& from, const std::string& to,
                 const std::vector<InstanceRecord>& instances) {
  bool is_prepared = false;
  for (const InstanceRecord& instance : instances) {
    if (!instance.verified) continue;
    if (!is_prepared) prepare_proof_folder(to);
    is_prepared = true;
    for (const std::string& folder : from) {
      const std::string file = proof_file(folder, instance.instance_id);
      if (!fs::exists(file)) continue;
      write_file_atomically(proof_file(to, instance.instance_id), read_file(file));
      break;
    }
  }
}

}  // namespace mwt
