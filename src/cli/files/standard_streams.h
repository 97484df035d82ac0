#pragma once

#include <string>

namespace multipath {

/// To be called before anything is opened. Standard descriptors that the caller of the program has closed are taken, so
/// that no file gets their number and with it what is printed; printing to them stays an error. A reader of standard
/// output who leaves, and a file beyond the permitted size, become errors of write() instead of signals that end the
/// program with its temporary files left behind.
void prepare_standard_streams();

// Names of files may hold what a terminal takes for commands: printed text has '?' for control characters, but for line
// feeds and tabs.

/// Prints on standard output, at once. Throws OutputError.
void print(std::string text);

/// Prints on standard error.
void print_note(std::string text);

} // namespace multipath
