#include "harness/explore/server/kept_points.h"

#include <algorithm>
#include <utility>

#include "geometry/point_set.h"
#include "harness/explore/frame.h"

namespace mwt {

std::optional<std::string> KeptPoints::keep(const std::string& bytes) {
  const auto points = bytes.size() <= max_bytes_ ? points_in(bytes) : std::nullopt;
  if (!points || points->empty()) return std::nullopt;
  std::string name = instance_id(*points);
  if (find(name)) return name;
  const std::lock_guard lock(mutex_);
  kept_.push_front({name, std::make_shared<const std::string>(bytes)});
  for (bytes_ += bytes.size(); bytes_ > max_bytes_; kept_.pop_back()) bytes_ -= kept_.back().bytes->size();
  return name;
}

std::shared_ptr<const std::string> KeptPoints::find(const std::string& name) {
  const std::lock_guard lock(mutex_);
  const auto found = std::ranges::find(kept_, name, &Kept::name);
  if (found == kept_.end()) return nullptr;
  std::rotate(kept_.begin(), found, found + 1);
  return kept_.front().bytes;
}

}  // namespace mwt
