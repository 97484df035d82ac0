#include "scene/obj/light_advice.h"

#include "base/text_format.h"
#include "scene/text/text_lines.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

namespace multipath {

namespace {

constexpr double advised_emittance = 10.0; // [W/m^2]

/// A material or object that could be made a lamp.
struct LampCandidate
{
    std::string name;
    double area; ///< [m^2]
};

std::string lower_case(std::string text)
{
    for (char& c : text)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

/// Adds the names that belong to surfaces and are not in the list; `numbers` holds the index of each surface's name.
void add_candidates(const std::vector<std::string>& names, const std::vector<std::uint32_t>& numbers,
                    const SurfaceList& surfaces, std::vector<LampCandidate>& candidates)
{
    std::vector<double> areas(names.size()); // [m^2]
    for (std::size_t s = 0; s < surfaces.size(); ++s)
        areas[numbers[s]] += surfaces[s].area();
    for (std::size_t k = 0; k < names.size(); ++k)
        if (areas[k] > 0.0 && std::none_of(candidates.begin(), candidates.end(),
                                           [&](const LampCandidate& other) { return other.name == names[k]; }))
            candidates.push_back({names[k], areas[k]});
}

/// Those whose names suggest lamps or windows, the most likely first.
std::vector<LampCandidate> named_like_lamps(const std::vector<LampCandidate>& candidates)
{
    // Words for lamps first, then for windows, in languages that occur in public models.
    constexpr std::array<std::string_view, 32> words = {
        "lamp",    "light",   "bulb",     "emit",   "emis", "lumi",   "neon",   "fluo",
        "glow",    "led_",    "licht",    "leucht", "luce", "luz",    "svjetl", "svetl",
        "lantern", "chandel", "candle",   "sconce", "sky",  "himmel", "window", "fenster",
        "fenetre", "ventana", "finestra", "prozor", "glas", "vidrio", "vetro",  "staklo"};
    const auto rank = [&](const LampCandidate& candidate) {
        const std::string name = lower_case(candidate.name);
        return std::find_if(words.begin(), words.end(),
                            [&](std::string_view word) { return name.find(word) != std::string::npos; });
    };
    std::vector<LampCandidate> result;
    std::copy_if(candidates.begin(), candidates.end(), std::back_inserter(result),
                 [&](const LampCandidate& candidate) { return rank(candidate) != words.end(); });
    std::stable_sort(result.begin(), result.end(),
                     [&](const LampCandidate& a, const LampCandidate& b) { return rank(a) < rank(b); });
    return result;
}

} // namespace

LightAdvice advised_light(const ObjMesh& mesh, const SceneFile& scene, bool is_closed_room)
{
    std::vector<LampCandidate> candidates;
    add_candidates(mesh.material_names(), scene.material, scene.surfaces, candidates);
    const auto largest =
        std::max_element(candidates.begin(), candidates.end(),
                         [](const LampCandidate& a, const LampCandidate& b) { return a.area < b.area; });
    const std::vector<LampCandidate> in_room = {*largest};
    add_candidates(mesh.groups, scene.group, scene.surfaces, candidates);
    std::vector<LampCandidate> lamps = named_like_lamps(candidates);
    if (lamps.empty() && is_closed_room)
        lamps = in_room;
    if (lamps.empty())
        return {"to light it by sky and sun",
                {{Remedy::sky, format("%g", advised_emittance)}, {Remedy::sun, "150,40,20"}}};
    const LampCandidate lamp = lamps[0];
    std::vector<std::string> others;
    for (std::size_t k = 1; k < lamps.size(); ++k)
        others.push_back(in_quotes(lamps[k].name));
    return {"to make a lamp of material or object " + in_quotes(lamp.name) +
                format(" (%.3g m^2, so %.3g W)", lamp.area, advised_emittance * lamp.area) +
                (others.empty() ? "" : ", or another: " + first_of(others, 5)),
            {{Remedy::lamp, lamp.name + format("=%g", advised_emittance)}}};
}

} // namespace multipath
