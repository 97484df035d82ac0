#pragma once

#include "export/patch_table_reader.h"

#include <string>

namespace multipath {

/// The result in a table (.csv) or in the state of a finished run, whatever the file is called. Throws InputError,
/// ArchiveError.
PatchTable read_result(const std::string& path);

} // namespace multipath
