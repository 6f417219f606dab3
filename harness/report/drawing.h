// Calls the scripts of plots/ that draw what a report wrote.
#pragma once

#include <string>
#include <vector>

namespace mwt {

/// Runs plots/SCRIPT with these arguments. The script is sought where this program is installed, else beside the
/// sources that it was built from, else beside these where they have been moved with the program. Returns an empty
/// text, or one line why it did nothing, with the remedy; `needs` names what the script needs to be installed.
[[nodiscard]] std::string draw_by_script(const std::string& script, const std::vector<std::string>& arguments,
                                         const std::string& needs);

/// The path of this program, for scripts that call it.
[[nodiscard]] std::string own_path();

}  // namespace mwt
