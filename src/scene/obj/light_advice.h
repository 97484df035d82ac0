#pragma once

#include "scene/input_error.h"
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
    std::string name;
    bool is_group;
    std::uint32_t number; ///< index into the materials or groups of the mesh
    double area;          ///< [m^2]
};

/// Candidates whose names suggest lamps or windows, the most likely first, and all materials, the largest first.
struct LampCandidates
{
    std::vector<LampCandidate> by_name;
    std::vector<LampCandidate> materials;
};

/// Here and below, `scene` holds the faces of the mesh as surfaces, with the mesh's indices of materials and groups.
LampCandidates lamp_candidates(const ObjMesh& mesh, const SceneFile& scene);

constexpr double advised_emittance = 10.0; ///< [W/m^2] of lamps and sky

/// Options for a command line, each preceded by a space. The sun stands in the south-south-east.
std::string lamp_option(const std::string& name);
std::string sky_option();
std::string sun_option();

/// A proposal how to light a scene that has no light.
struct LightAdvice
{
    std::string lamp;                ///< material or object to make a lamp; empty: use a sky
    double lamp_area = 0.0;          ///< [m^2] of its surfaces
    std::vector<std::string> others; ///< other candidates by name
    double lit_share = 0.0;          ///< [1] estimate: share of the light of this lamp or sky that reaches a front
};

/// Prefers a candidate by name, then a sky if fronts see out of the scene, then one of the largest materials. A choice
/// is good enough if 5 % of its light reaches a front; if none is, the best of those tried counts.
LightAdvice advised_light(const LampCandidates& candidates, const SceneFile& scene);

/// An option that lights a scene, with estimates of the power.
struct LightYield
{
    std::string option; ///< quoted for a shell, preceded by a space
    double emitted;     ///< [W]; NaN for sky and sun
    double arriving;    ///< [W] on fronts, before reflection
};

/// The yields of up to 12 lamps (candidates by name, then the largest materials), a sky and a sun.
std::vector<LightYield> light_yields(const LampCandidates& candidates, const SceneFile& scene);

/// A scene without emitters; the message proposes one.
class DarkScene : public InputError
{
public:
    DarkScene(const std::string& message, LampCandidates lamps, const SceneFile& file)
        : InputError(message), candidates(std::move(lamps)), scene(std::make_shared<const SceneFile>(file))
    {
    }

    LampCandidates candidates;
    std::shared_ptr<const SceneFile> scene;
};

} // namespace multipath
