// The limit of options such as --threads and --jobs.
#pragma once

namespace mwt {

/// The largest number of threads or processes that an option accepts.
inline constexpr int kMaxWorkers = 1024;

}  // namespace mwt
