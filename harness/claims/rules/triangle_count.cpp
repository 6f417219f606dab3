// C3: how many triangles a triangulation has.
#include <fmt/core.h>

#include <map>

#include "harness/claims/rules/rules.h"
#include "harness/claims/selection.h"

namespace mwt::claims {

namespace {

Finding judge_triangle_count(const StudyRecords& records) {
  std::map<std::string, std::uint64_t> expected;
  for (const InstanceRecord& instance : records.instances) {
    expected[instance.instance_id] = 2 * std::uint64_t{instance.distinct} - instance.hull_size - 2;
  }
  Finding finding;
  finding.rows = finished_runs(
      records, [&](const RunRecord& run) { return run.triangles.has_value() && expected.contains(run.instance_id); });
  std::size_t agreeing = 0;
  for (const RunRecord* run : finding.rows) agreeing += run->triangles == expected.at(run->instance_id) ? 1U : 0U;
  if (finding.rows.empty()) return finding;
  finding.verdict = agreeing == finding.rows.size() ? ClaimVerdict::reproduced : ClaimVerdict::refuted;
  finding.measured =
      fmt::format("so in {} of {} checked triangulations (h: points on the hull's boundary, collinear ones included)",
                  grouped(agreeing), grouped(finding.rows.size()));
  return finding;
}

}  // namespace

Claim triangle_count() {
  return {"C3",
          "Every triangulation of n points, h of them on the convex hull, has 2n - h - 2 triangles",
          "2, 5.1.3",
          "every finished run, joined with its instance",
          "reproduced: all of them; refuted: any differs",
          "mwt generate clustered --n 1000 -o p.csv && mwt solve p.csv --algorithm sweep",
          judge_triangle_count};
}

}  // namespace mwt::claims
