#pragma once

#include "export/patch_table.h"
#include "scene/scene.h"

#include <memory>
#include <string>

namespace multipath {

/// The result in a table (.csv) or in the state of a finished run, whatever the file is called.
struct ResultFile
{
    PatchTable table;                   ///< of a state the one that `solve -o FILE.csv` would have written
    std::unique_ptr<const Scene> scene; ///< of a state

    /// `beside`: see read_patch_table. Throws InputError, ArchiveError.
    explicit ResultFile(const std::string& path, const PatchTable* beside = nullptr);
};

/// True if two scenes have the same surfaces and sides, in whichever patches.
bool have_same_surfaces(const Scene& a, const Scene& b);

} // namespace multipath
