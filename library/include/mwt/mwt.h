// Minimum weight triangulation: all headers of the library.
//
// Everything is in the namespace mwt::v1; an incompatible change would come as mwt::v2.
#pragma once

#include "mwt/files.h"        // IWYU pragma: export
#include "mwt/points.h"       // IWYU pragma: export
#include "mwt/triangulate.h"  // IWYU pragma: export

#define MWT_VERSION_MAJOR 1

namespace mwt::v1 {

/// "1.0.0": of the library that is linked.
[[nodiscard]] std::string version();

}  // namespace mwt::v1
