#pragma once

#include "commands/recorded_command.h"

#include <optional>
#include <string>

namespace multipath {

/// The bytes of the file that the recorded command writes when it is run again, in this process, with its outputs in a
/// folder of its own that is gone afterwards. Nothing comes to standard output. `path` is the file with the record, for
/// messages; `threads` is the value of --threads.
/// Throws InputError for what is no command of `multipath` that writes such a file, or no command as provenance()
/// writes it (one with --output could overwrite anything), and for all that the command itself refuses; OutputError as
/// well.
std::string run_again(const RecordedCommand& record, const std::string& path,
                      const std::optional<std::string>& threads);

} // namespace multipath
