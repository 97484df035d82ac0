#pragma once

#include <string>

namespace multipath {

// File names may contain control sequences of terminals. Control characters except line feeds and tabs are therefore
// printed as '?'.

/// Prints on standard output, unbuffered. Throws OutputError, or ReaderGone if the reader has closed it.
void print(std::string text);

/// Prints on standard error; errors are ignored.
void print_note(std::string text);

} // namespace multipath
