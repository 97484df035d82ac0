#pragma once

#include <string>
#include <string_view>

namespace multipath {

/// The text of a file of the folder src/viewer/page, by its name; the Makefile puts the files into the program. Throws
/// std::logic_error for a name that is not there.
std::string_view page_file(std::string_view name);

} // namespace multipath
