#pragma once

#include <string_view>

namespace multipath {

// File names may contain control sequences of terminals. Control characters except line feeds and tabs are therefore
// printed as '?'.

/// Prints on standard output, unbuffered. Throws OutputError, or ReaderGone if the reader has closed it.
void print(std::string_view text);

/// Prints on standard error; errors are ignored.
void print_note(std::string_view text);

} // namespace multipath
