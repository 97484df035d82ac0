#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The comments of a file, such as "command: multipath solve room.obj", which record its provenance.

namespace multipath {

/// The comments as the first lines of a table or OBJ file, a `# ` line for each.
std::string comment_lines(const std::vector<std::string>& comments);

/// Value of the comment "name: value"; the first one if there are several.
std::optional<std::string> comment_value(const std::vector<std::string>& comments, std::string_view name);

} // namespace multipath
