// The one exception for a user's mistake: its message is one line that names the place and the remedy.
#pragma once

#include <stdexcept>

namespace mwt {

/// Something the user gave cannot be used: a file, a name, a parameter, a number of points. Exit code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace mwt
