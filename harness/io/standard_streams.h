// Standard input, output and error as a program finds them.
#pragma once

namespace mwt {

/// Opens /dev/null on whichever of the descriptors 0, 1 and 2 are closed: the first file that the program opens would
/// otherwise get such a number, and what is printed would land in that file. To be called before any file is opened.
/// Ends the program with exit code 3 if there is no /dev/null.
void open_closed_standard_streams();

}  // namespace mwt
