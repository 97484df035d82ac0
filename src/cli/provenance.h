#pragma once

#include "cli/command_line.h"
#include "cli/option_table.h"
#include "scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// What every output says of where it comes from: version, the command that makes it again, seed, scene. Options that
/// do not change the result (threads, outputs, messages) are left out, so that the same result has the same bytes.
/// RecordedCommand reads it back.
std::vector<std::string> provenance(const CommandTable& table, const CommandLine& line, const Scene& scene);

/// The same for what is made without a scene.
std::vector<std::string> provenance(const CommandTable& table, const CommandLine& line);

/// Does the option of this long name stand in provenance?
bool is_recorded(std::string_view option);

} // namespace multipath
