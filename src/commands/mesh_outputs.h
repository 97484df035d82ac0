#pragma once

#include "cli/planned_outputs.h"
#include "commands/picture_options.h"
#include "export/patch_mesh.h"
#include "radiosity/solve.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace multipath {

/// Is this the format of a mesh file?
bool is_mesh(OutputFormat format);

/// A solution as a mesh, exposed as pictures of it are. The arguments must outlive it.
class SolvedMesh
{
public:
    SolvedMesh(const Scene& scene, const Solution& solution, const PictureOptions& options);

    /// The file in a mesh format.
    std::string bytes(OutputFormat format, std::vector<std::string> comments) const;

private:
    const Scene& scene_;
    const Solution& solution_;
    const PictureOptions& options_;
    PatchMesh mesh_;
};

} // namespace multipath
