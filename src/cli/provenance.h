#pragma once

#include "cli/options/command_line.h"
#include "scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace multipath {

/// Origin of an output, one line per fact: version, the command as it was given, seed, hash of the scene, and the unit
/// of light if it is lux. Options that do not change the result (threads, outputs, messages) are left out of the
/// command, so that the same command gives the same bytes. The command is one line that a POSIX shell reads back as the
/// same words, but for control characters. `left_out`: further options that are not to be recorded.
std::vector<std::string> provenance(const CommandLine& line, const Scene& scene,
                                    const std::vector<std::string>& left_out = {});

/// The same for outputs made without a scene: version, command and seed.
std::vector<std::string> provenance(const CommandLine& line, const std::vector<std::string>& left_out = {});

/// True if provenance() records the option of this long name.
bool is_recorded(std::string_view option);

} // namespace multipath
