#pragma once

#include <string_view>

namespace multipath {

/// To be called before anything is opened. Standard descriptors that the caller of the program has closed are taken, so
/// that no file gets their number and with it what is printed; printing to them stays an error. A reader of standard
/// output who leaves, and a file beyond the permitted size, become errors of write() instead of signals that end the
/// program with its temporary files left behind.
void prepare_standard_streams();

/// Prints on standard output, at once. Throws OutputError.
void print(std::string_view text);

} // namespace multipath
