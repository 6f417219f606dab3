// C14: a theorem, which no measurement decides.
#include "harness/claims/rules/rules.h"

namespace mwt::claims {

Claim np_hardness() {
  return {"C14",
          "MWT is NP-hard, shown by reducing triangulation to 3-SAT",
          "3",
          "none: a theorem",
          "by citation: the statement is true, proved in 2008; the source report's argument is none, for it reduces in "
          "the wrong direction",
          "",
          [](const StudyRecords&) {
            Finding finding;
            finding.verdict = ClaimVerdict::by_citation;
            finding.measured =
                "true (W. Mulzer, G. Rote, Minimum-weight triangulation is NP-hard, J. ACM 55, 2008); to show "
                "it, 3-SAT would have to be reduced to triangulation, not triangulation to 3-SAT. As a model of "
                "triangulations the source report's formula is right: algorithm boolean_model solves it, and its "
                "models are exactly the triangulations (tests count them on every family; 586 on the source "
                "report's example)";
            return finding;
          }};
}

}  // namespace mwt::claims
