#pragma once

#include "scene/obj/mesh_pieces.h"
#include "scene/obj/mtl_reader.h"
#include "scene/scene_file.h"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace multipath {

/// Reads image files, each once.
class TextureFiles
{
public:
    struct Loaded
    {
        std::shared_ptr<const Texture> texture; ///< null if there is a problem or no map
        std::string problem;                    ///< such as "not found"
    };

    const Loaded& load(const TextureMap& map);

private:
    std::map<std::pair<std::string, bool>, Loaded> known_; ///< by path, and whether it repeats
};

/// Reads the textures of a scene's materials and maps them onto its surfaces. The reflectance of a material with
/// `map_Kd` becomes Kd times the area-weighted mean of the texture over its surfaces, and the emittance of one with
/// `map_Ke` becomes Ke times such a mean. Beside a map, a missing Kd or Ke counts as 1, and so does 0, which many
/// programs write there, with a warning. The colours of pieces multiply Kd in the same way where a material has no map.
/// A map whose file is missing or cannot be read is ignored; one warning reports all of them. Returns them:
/// "`wood` (wood.png: not found)".
///
/// `definitions` has one entry per material of the scene, `cut.pieces` one per surface. Each channel of Kd is clamped
/// to at most `limit` (--reflectance-limit, without unit) before it multiplies a texture.
std::vector<std::string> add_textures(const std::vector<MtlMaterial>& definitions, const MeshPieces& cut,
                                      const ObjMesh& mesh, TextureFiles& files, double limit, SceneFile& scene);

} // namespace multipath
