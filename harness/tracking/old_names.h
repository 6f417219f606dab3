// Names that earlier versions of the program recorded, in results and in histories.
#pragma once

#include <string>

namespace mwt {

/// The present name of a column or an algorithm; most are unchanged.
[[nodiscard]] std::string present_name(const std::string& name);

/// The parameters of `algorithm`, its present name, in their present canonical form.
[[nodiscard]] std::string present_params(const std::string& algorithm, const std::string& params);

}  // namespace mwt
