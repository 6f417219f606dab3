#include "harness/run/callgrind/marks.h"

#include <valgrind/callgrind.h>

namespace mwt {

CallgrindMark::CallgrindMark() { CALLGRIND_START_INSTRUMENTATION; }

CallgrindMark::~CallgrindMark() { CALLGRIND_STOP_INSTRUMENTATION; }

}  // namespace mwt
