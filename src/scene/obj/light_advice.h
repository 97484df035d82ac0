#pragma once

#include "base/errors.h"
#include "scene/obj/obj_mesh.h"
#include "scene/scene_file.h"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace multipath {

/// A material or object that could be made a lamp.
struct LampCandidate
{
    std::string name;     ///< as ObjChanges::Lamp takes it; "default" for faces without a material
    bool is_group;        ///< true for an object or group, false for a material
    std::uint32_t number; ///< index into ObjMesh::groups or ObjMesh::materials
    double area;          ///< [m^2] area of all its surfaces
};

/// The candidates for lamps of a scene. Only those with area are listed.
struct LampCandidates
{
    std::vector<LampCandidate> by_name;   ///< names that suggest lamps or windows, the most likely first
    std::vector<LampCandidate> materials; ///< all materials, the largest first
};

/// Lists the candidates. Here and below, `scene` holds the faces of the mesh as surfaces; SceneFile::material and
/// SceneFile::group hold indices into ObjMesh::materials and ObjMesh::groups.
LampCandidates lamp_candidates(const ObjMesh& mesh, const SceneFile& scene);

constexpr double advised_emittance = 10.0; ///< [W/m^2] of proposed lamps and skies

/// A proposal how to light a scene that has no light.
struct LightAdvice
{
    std::vector<Advice> advice;      ///< a lamp, or a sky and a sun in the south-south-east
    std::string lamp;                ///< material or object to be made a lamp; empty: use a sky
    double lamp_area = 0.0;          ///< [m^2] area of the surfaces of the lamp; without meaning for a sky
    std::vector<std::string> others; ///< the other names in LampCandidates::by_name, the most likely first
    /// [1] Estimated share of the lamp's light that reaches fronts of other surfaces; for a sky, the mean view factor
    /// from the fronts to the sky, estimated as the share of cosine-distributed rays that leave the scene.
    double lit_share = 0.0;
};

/// Tries up to four of LampCandidates::by_name, then a sky, then up to four of LampCandidates::materials, and proposes
/// the first whose lit_share is at least 5 %; if there is none, the one with the largest share.
LightAdvice advised_light(const LampCandidates& candidates, const SceneFile& scene);

/// A way to light a scene, with estimates of the light.
struct LightYield
{
    Advice advice;
    double emitted;  ///< [W]; NaN for a sky or sun
    double arriving; ///< [W] that reaches fronts directly, before any reflection
};

/// The yields of up to 12 lamps (the candidates by name, then the largest materials), followed by those of a sky and a
/// sun.
std::vector<LightYield> light_yields(const LampCandidates& candidates, const SceneFile& scene);

/// Thrown for a scene without emitters. The advice lights it. `candidates` and `scene` are the arguments for
/// light_yields().
class DarkScene : public InputError
{
public:
    DarkScene(const InputError& error, LampCandidates lamps, const SceneFile& file)
        : InputError(error), candidates(std::move(lamps)), scene(std::make_shared<const SceneFile>(file))
    {
    }

    LampCandidates candidates;
    std::shared_ptr<const SceneFile> scene;
};

} // namespace multipath
