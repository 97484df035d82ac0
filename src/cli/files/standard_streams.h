#pragma once

#include <string>

namespace multipath {

/// Prepares the standard streams; must be called before any file is opened. Opens /dev/null for standard descriptors
/// that are closed, so that no file gets their number and receives what is printed. Printing to such a descriptor
/// remains an error. Ignores SIGPIPE and SIGXFSZ: a reader that closes standard output, and a file above the size
/// limit, become errors of write() instead of signals that would end the program and leave temporary files.
void prepare_standard_streams();

// File names may contain control sequences of terminals. Control characters except line feeds and tabs are therefore
// printed as '?'.

/// Prints on standard output, unbuffered. Throws OutputError, or ReaderGone if the reader has closed it.
void print(std::string text);

/// Prints on standard error; errors are ignored.
void print_note(std::string text);

} // namespace multipath
