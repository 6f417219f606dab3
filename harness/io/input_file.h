// Reading a whole file at once.
#pragma once

#include <string>

namespace mwt {

/// The content of the file at `path`; `-` is standard input. Fifos and terminals are read to their
/// end. Throws InputError naming the file and the remedy: missing, a folder, a device, a fifo of more than 4 GB, no
/// permission, a failing disk.
[[nodiscard]] std::string read_file(const std::string& path);

/// How messages name the file at `path`: "standard input" for `-`.
[[nodiscard]] std::string source_name(const std::string& path);

}  // namespace mwt
