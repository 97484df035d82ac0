#pragma once

#include "scene/text_lines.h"

#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// The files that the argument of `mtllib` names, as paths that can be opened. Names are relative to the folder of the
/// OBJ file; they may be several, in quotes, contain blanks or backslashes, or have the wrong case.
/// Throws InputError at `place` for a name without a file.
std::vector<std::string> find_mtl_files(std::string_view names, TextPlace place);

} // namespace multipath
