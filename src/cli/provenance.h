#pragma once

#include "cli/options/command_line.h"
#include "scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// Origin of an output: version, the command that reproduces it, seed, and hash of the scene. Options that do not
/// change the result (threads, outputs, messages) are left out, so that the same result has the same bytes. The command
/// is one line that a POSIX shell reads back as the same words.
std::vector<std::string> provenance(const CommandTable& table, const CommandLine& line, const Scene& scene);

/// The same for outputs made without a scene.
std::vector<std::string> provenance(const CommandTable& table, const CommandLine& line);

/// True if provenance() records the option of this long name.
bool is_recorded(std::string_view option);

} // namespace multipath
