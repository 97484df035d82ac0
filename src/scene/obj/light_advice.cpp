#include "scene/obj/light_advice.h"

#include "base/text_format.h"
#include "geometry/intersector/surface_sizes.h"
#include "scene/text/text_lines.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

namespace multipath {

namespace {

constexpr double advised_emittance = 10.0; // [W/m^2]

/// The index of the first word for a lamp or a window in a name; the number of these words if there is none.
std::size_t rank_as_lamp(const std::string& name)
{
    constexpr std::array<std::string_view, 16> words = {"lamp", "light",  "bulb",    "emit",   "emis",    "lumi",
                                                        "neon", "glow",   "licht",   "leucht", "lantern", "candle",
                                                        "sky",  "window", "fenster", "glas"};
    const std::string text = lower_case(name);
    const auto found = std::find_if(words.begin(), words.end(),
                                    [&](std::string_view word) { return text.find(word) != std::string::npos; });
    return static_cast<std::size_t>(found - words.begin());
}

} // namespace

LightAdvice advised_light(const ObjMesh& mesh, const SceneFile& scene)
{
    const std::vector<std::string> names = mesh.material_names();
    std::map<std::string, double> materials, groups; // [m^2] by name
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
        materials[names[scene.material[s]]] += scene.surfaces[s].area();
        groups[scene.groups[scene.group[s]]] += scene.surfaces[s].area();
    }
    const std::size_t no_rank = rank_as_lamp("");
    std::string lamp;
    std::pair best = {no_rank + 1, 0.0}; // rank and minus the area
    const auto offer = [&](const std::string& name, double area) {
        if (const std::pair offered = {rank_as_lamp(name), -area}; area > 0.0 && offered < best) {
            lamp = name;
            best = offered;
        }
    };
    for (const std::string& name : names)
        offer(name, materials[name]);
    for (const std::string& name : scene.groups)
        if (rank_as_lamp(name) != no_rank)
            offer(name, groups[name]);
    const auto [rank, minus_area] = best;
    if (rank == no_rank && !is_interior(scene.surfaces))
        return {"to light it by sky and sun",
                {{Remedy::sky, format("%g", advised_emittance)}, {Remedy::sun, "150,40,20"}}};
    return {"to make a lamp of material or object " + in_quotes(lamp) +
                format(" (%.3g m^2, so %.3g W)", -minus_area, -minus_area * advised_emittance),
            {{Remedy::lamp, lamp + format("=%g", advised_emittance)}}};
}

} // namespace multipath
