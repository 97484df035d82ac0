#pragma once

#include "parallel/archive.h"
#include "scene/scene.h"

#include <cstdint>
#include <memory>

namespace multipath {

/// A scene as a state file keeps it, so that the file alone is enough to go on or to make pictures.
struct ArchivedScene
{
    std::shared_ptr<const SceneFile> file; ///< shared with the scene; none before one is read
    double patch_size = 0.0;               ///< [scene units]
    std::uint64_t two_sided = 0;
    std::uint64_t patches = 0;
    std::uint64_t hash = 0; ///< of the scene

    void visit(Archive& archive);
};

ArchivedScene archived(const Scene& scene);

/// Builds it again. Throws ArchiveError where it is not the scene that was kept.
Scene restored(const ArchivedScene& archived);

} // namespace multipath
