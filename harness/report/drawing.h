// Calls the scripts of plots/ that draw what a report wrote.
#pragma once

#include <string>

namespace mwt {

/// Runs plots/SCRIPT on the folder. The script is sought beside the sources that this program was built from, or moved
/// with. Returns an empty text, or one line why nothing is drawn now, with the remedy; `needs` names what the script
/// needs to be installed.
[[nodiscard]] std::string draw_by_script(const std::string& script, const std::string& folder,
                                         const std::string& needs);

}  // namespace mwt
