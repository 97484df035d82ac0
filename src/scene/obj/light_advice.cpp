#include "scene/obj/light_advice.h"

#include "base/text_format.h"
#include "geometry/intersector/surface_sizes.h"
#include "scene/text/text_lines.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <unordered_map>

namespace multipath {

namespace {

constexpr double advised_emittance = 10.0; // [W/m^2]

/// The index of the first word for a lamp or a window in a name; the number of these words if there is none.
std::size_t rank_as_lamp(const std::string& name)
{
    // Words for lamps first, then for windows, in languages that occur in public models.
    constexpr std::array<std::string_view, 32> words = {
        "lamp",    "light",   "bulb",     "emit",   "emis", "lumi",   "neon",   "fluo",
        "glow",    "led_",    "licht",    "leucht", "luce", "luz",    "svjetl", "svetl",
        "lantern", "chandel", "candle",   "sconce", "sky",  "himmel", "window", "fenster",
        "fenetre", "ventana", "finestra", "prozor", "glas", "vidrio", "vetro",  "staklo"};
    const std::string text = lower_case(name);
    const auto found = std::find_if(words.begin(), words.end(),
                                    [&](std::string_view word) { return text.find(word) != std::string::npos; });
    return static_cast<std::size_t>(found - words.begin());
}

/// A material or object that could be made a lamp.
struct LampCandidate
{
    std::string name;
    double area; ///< [m^2]
};

/// Those of the names that belong to surfaces; `numbers` holds the index of each surface's name.
std::vector<LampCandidate> candidates(const std::vector<std::string>& names, const std::vector<std::uint32_t>& numbers,
                                      const SurfaceList& surfaces)
{
    std::unordered_map<std::string, double> areas; // [m^2] by name
    for (std::size_t s = 0; s < surfaces.size(); ++s)
        areas[names[numbers[s]]] += surfaces[s].area();
    std::vector<LampCandidate> result;
    for (const std::string& name : names)
        if (const auto found = areas.find(name); found != areas.end())
            result.push_back({name, found->second});
    return result;
}

} // namespace

LightAdvice advised_light(const ObjMesh& mesh, const SceneFile& scene)
{
    const auto materials = candidates(mesh.material_names(), scene.material, scene.surfaces);
    std::vector<LampCandidate> all = candidates(scene.groups, scene.group, scene.surfaces);
    all.insert(all.begin(), materials.begin(), materials.end());
    LampCandidate lamp = *std::min_element(all.begin(), all.end(), [](const LampCandidate& a, const LampCandidate& b) {
        return rank_as_lamp(a.name) < rank_as_lamp(b.name);
    });
    if (rank_as_lamp(lamp.name) == rank_as_lamp("")) {
        if (!is_interior(scene.surfaces))
            return {"to light it by sky and sun",
                    {{Remedy::sky, format("%g", advised_emittance)}, {Remedy::sun, "150,40,20"}}};
        lamp = *std::max_element(materials.begin(), materials.end(),
                                 [](const LampCandidate& a, const LampCandidate& b) { return a.area < b.area; });
    }
    return {"to make a lamp of material or object " + in_quotes(lamp.name) +
                format(" (%.3g m^2, so %.3g W)", lamp.area, advised_emittance * lamp.area),
            {{Remedy::lamp, lamp.name + format("=%g", advised_emittance)}}};
}

} // namespace multipath
