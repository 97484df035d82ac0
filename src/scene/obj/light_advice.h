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

/// A material or object that may become a lamp.
struct LampCandidate
{
    std::string name;
    bool is_group;
    std::uint32_t number; ///< in the mesh
    double area;          ///< [m^2]
};

/// Those that are called as lamps or windows are, the most likely first, and all materials, the largest first.
struct LampCandidates
{
    std::vector<LampCandidate> called;
    std::vector<LampCandidate> materials;
};

/// `scene`, here and below: the same faces as surfaces, with the numbers of the mesh's materials and groups.
LampCandidates lamp_candidates(const ObjMesh& mesh, const SceneFile& scene);

constexpr double advised_emittance = 10.0; ///< [W/m^2] of lamps and sky

/// Options for a command line, with a space before each. The sun stands in the south-east.
std::string lamp_option(const std::string& name);
std::string sky_option();
std::string sun_option();

/// What gives light to a scene that has none.
struct LightAdvice
{
    std::string lamp;                ///< material or object to become one; empty: better a sky
    double lamp_area = 0.0;          ///< [m^2] of its surfaces
    std::vector<std::string> others; ///< other likely lamps
    double lit_share = 0.0;          ///< [1] of the light of that lamp or sky that arrives on a front, about
};

/// Prefers what is called as lamps or windows are, unless its light would reach nothing; then a sky, if fronts see out;
/// then the material of the largest area that lights others.
LightAdvice advised_light(const LampCandidates& candidates, const SceneFile& scene);

/// An option that lights a scene, and about what it brings.
struct LightYield
{
    std::string option; ///< as a shell takes it
    double emitted;     ///< [W]; not a number of sky and sun
    double arriving;    ///< [W] on fronts, before reflection
};

/// Of likely lamps, the largest materials, a sky and a sun: about a dozen.
std::vector<LightYield> light_yields(const LampCandidates& candidates, const SceneFile& scene);

/// Nothing emits; the message advises what may.
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
