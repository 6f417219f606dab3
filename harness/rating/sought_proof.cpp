#include "harness/rating/sought_proof.h"

#include <filesystem>
#include <system_error>

namespace mwt {

namespace {

void remove_if_there(const std::string& file) {
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
}

}  // namespace

void SoughtProof::begin(const std::vector<OptimumKey>& cached) {
  if (path_.empty()) return;
  remove_if_there(path_);
  remove_if_there(candidate());
  for (const OptimumKey& key : cached) {
    if (!cache_->fetch_proof(key, path_)) continue;
    key_ = key;
    is_from_cache_ = is_tried_ = true;
    return;
  }
}

std::string SoughtProof::candidate_of(const AlgorithmInfo& source) {
  if (path_.empty() || !source.has_proofs) return "";
  is_tried_ = true;
  return candidate();
}

void SoughtProof::keep_if_better(const OptimumKey& key, const RatedRun& run) {
  std::error_code error;
  if (path_.empty() || !std::filesystem::exists(candidate(), error)) return;
  const double lower = run.status == RunStatus::ok ? run.certified_lower.value_or(-1) : -1;
  if (lower <= lower_) return remove_if_there(candidate());
  std::filesystem::rename(candidate(), path_, error);
  if (error) return;
  key_ = key;
  lower_ = lower;
}

bool SoughtProof::must_be_made_anew(const ProofCheck& check) {
  if (!is_from_cache_ || check.verdict == ProofVerdict::optimal) return false;
  cache_->discard_proof(*key_);
  remove_if_there(path_);
  key_.reset();
  is_from_cache_ = is_tried_ = false;
  return true;
}

void SoughtProof::cache_if_new(const ProofCheck& check) const {
  if (cache_ != nullptr && !is_from_cache_ && check.verdict == ProofVerdict::optimal) cache_->store_proof(*key_, path_);
}

}  // namespace mwt
