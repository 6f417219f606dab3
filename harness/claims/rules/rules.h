// The claims with their rules, each defined in the file of this folder named beside it.
#pragma once

#include "harness/claims/claim.h"

namespace mwt::claims {

[[nodiscard]] Claim greedy_example();            // worked_examples.cpp: C1
[[nodiscard]] Claim insertion_example();         // worked_examples.cpp: C2
[[nodiscard]] Claim triangle_count();            // triangle_count.cpp: C3
[[nodiscard]] Claim greedy_alpha();              // greedy_alpha.cpp: C4
[[nodiscard]] Claim greedy_linear_bound();       // greedy_linear_bound.cpp: C5
[[nodiscard]] Claim insertion_logarithmic();     // insertion_logarithmic.cpp: C6
[[nodiscard]] Claim hull_lower_bound();          // hull_lower_bound.cpp: C7
[[nodiscard]] Claim insertion_step();            // insertion_step.cpp: C8
[[nodiscard]] Claim local_search_example();      // worked_examples.cpp: C9
[[nodiscard]] Claim local_search_probability();  // local_search_probability.cpp: C10
[[nodiscard]] Claim triangulation_numbers();     // triangulation_numbers.cpp: C11
[[nodiscard]] Claim running_times();             // running_times.cpp: C12
[[nodiscard]] Claim quadtree_alpha();            // quadtree_alpha.cpp: C13
[[nodiscard]] Claim np_hardness();               // np_hardness.cpp: C14
[[nodiscard]] Claim triangulation_growth();      // triangulation_growth.cpp: C15

}  // namespace mwt::claims
