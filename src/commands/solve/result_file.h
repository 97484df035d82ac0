#pragma once

#include "export/patch_table.h"
#include "scene/scene.h"

#include <memory>
#include <string>

namespace multipath {

/// A result read from a table of patches (.csv) or from the state of a run. The content of the file decides which, not
/// its extension.
struct ResultFile
{
    PatchTable table;                   ///< for a state, the table that `solve -o FILE.csv` would have written
    std::unique_ptr<const Scene> scene; ///< for a state; otherwise null

    /// `beside`: see read_patch_table(). Throws InputError or ArchiveError for a faulty file, and InputError for a run
    /// of which no piece or round is finished (see finished_solution).
    explicit ResultFile(const std::string& path, const PatchTable* beside = nullptr);
};

/// True if two scenes have the same surfaces, and both or neither are two-sided; their patches may differ.
bool have_same_surfaces(const Scene& a, const Scene& b);

} // namespace multipath
