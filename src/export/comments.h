#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

// The comments of a file, such as "command: multipath solve room.obj", which say where it comes from.

namespace multipath {

/// As tables and OBJs begin with them: a `# ` line for each.
std::string comment_lines(const std::vector<std::string>& comments);

/// What the comment "name: value" says; the first one if there are several.
std::optional<std::string> comment_value(const std::vector<std::string>& comments, std::string_view name);

} // namespace multipath
