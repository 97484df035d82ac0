// Advice for scenes without light. Candidates for lamps are found by words in their names and by area. How much of the
// light of a candidate, a sky or a sun would arrive is estimated with up to 32,768 rays each: enough to rank them.

#include "scene/obj/light_advice.h"

#include "base/text_format.h"
#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/intersector.h"
#include "scene/daylight.h"
#include "scene/facing.h"
#include "scene/random_ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace multipath {

namespace {

std::string lower_case(std::string text)
{
    for (char& c : text)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

/// [m^2] The total area of each material or group; `numbers` holds that of each surface.
std::vector<double> areas_of(const SceneFile& scene, const std::vector<std::uint32_t>& numbers, std::size_t count)
{
    std::vector<double> areas(count);
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
        areas[numbers[s]] += scene.surfaces[s].area();
    return areas;
}

/// Materials and objects whose names suggest lamps or windows, the most likely first.
std::vector<LampCandidate> candidates_by_name(const ObjMesh& mesh, const SceneFile& scene)
{
    // Words for lamps first, then for windows, in languages that occur in public models.
    constexpr std::array<std::string_view, 32> words = {
        "lamp",    "light",   "bulb",     "emit",   "emis", "lumi",   "neon",   "fluo",
        "glow",    "led_",    "licht",    "leucht", "luce", "luz",    "svjetl", "svetl",
        "lantern", "chandel", "candle",   "sconce", "sky",  "himmel", "window", "fenster",
        "fenetre", "ventana", "finestra", "prozor", "glas", "vidrio", "vetro",  "staklo"};
    const std::vector<double> of_materials = areas_of(scene, scene.material, mesh.materials.size());
    const std::vector<double> of_groups = areas_of(scene, scene.group, mesh.groups.size());
    std::vector<std::string> materials; // a lamp is first looked for among these
    for (const ObjName& material : mesh.materials)
        materials.push_back(name_of_material(material));
    std::vector<LampCandidate> result;
    const auto add = [&](const std::string& name, std::string_view word, bool is_group, std::size_t number) {
        const double area = is_group ? of_groups[number] : of_materials[number];
        if (lower_case(name).find(word) != std::string::npos &&
            std::none_of(result.begin(), result.end(), [&](const LampCandidate& c) { return c.name == name; }))
            result.push_back({name, is_group, static_cast<std::uint32_t>(number), area});
    };
    for (const std::string_view word : words) {
        for (std::size_t k = 0; k < mesh.materials.size(); ++k)
            if (of_materials[k] > 0.0)
                add(mesh.materials[k].name, word, false, k);
        for (std::size_t k = 0; k < mesh.groups.size(); ++k)
            if (of_groups[k] > 0.0 && std::find(materials.begin(), materials.end(), mesh.groups[k]) == materials.end())
                add(mesh.groups[k], word, true, k);
    }
    return result;
}

/// All materials that have area, the largest first.
std::vector<LampCandidate> candidates_by_area(const ObjMesh& mesh, const SceneFile& scene)
{
    const std::vector<double> areas = areas_of(scene, scene.material, mesh.materials.size());
    std::vector<LampCandidate> result;
    for (std::uint32_t k = 0; k < areas.size(); ++k)
        if (areas[k] > 0.0)
            result.push_back({name_of_material(mesh.materials[k]), false, k, areas[k]});
    std::stable_sort(result.begin(), result.end(),
                     [&](const LampCandidate& a, const LampCandidate& b) { return areas[a.number] > areas[b.number]; });
    return result;
}

/// Rays from the fronts of some surfaces, with an approximately cosine-weighted distribution, or all in one direction.
class Rays
{
public:
    /// Rays from the surfaces for which `from` is true.
    template <class Condition>
    Rays(const SurfaceList& surfaces, Condition from, std::optional<Vec3> direction = std::nullopt)
    {
        std::vector<std::uint32_t> chosen;
        for (std::uint32_t s = 0; s < surfaces.size(); ++s)
            if (from(s))
                chosen.push_back(s);
        constexpr std::size_t most = 4096;
        const std::size_t rays_per_surface = std::max(std::size_t{8}, 8 * most / std::max(chosen.size(), most / 64));
        RandomRay random;
        for (std::size_t k = 0; k < std::min(chosen.size(), most); ++k) {
            const std::uint32_t s = chosen[k * chosen.size() / std::min(chosen.size(), most)];
            const Surface& surface = surfaces[s];
            for (std::size_t ray = 0; ray < rays_per_surface; ++ray) {
                const Vec3 point = random.point(surface);
                const Vec3 diffuse = random.direction(surface.normal());
                from_.push_back(s);
                weights_.push_back(surface.area() * (direction ? dot(surface.normal(), *direction) : 1.0));
                lines_.push_back({point, direction.value_or(diffuse)});
            }
        }
    }

    /// The share of the light whose rays satisfy a condition on their first hit (null without a hit).
    template <class Condition>
    double share(const Intersector& intersector, Condition wanted)
    {
        intersector.closest_hits_from(from_.data(), lines_.data(), lines_.size(), hits_);
        double part = 0.0;
        double all = 0.0;
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            part += wanted(hits_.is_hit(k) ? &hits_[k] : nullptr) ? weights_[k] : 0.0;
            all += weights_[k];
        }
        return all > 0.0 ? part / all : 0.0;
    }

private:
    std::vector<std::uint32_t> from_;
    std::vector<Line> lines_;
    std::vector<double> weights_; ///< [m^2]
    FirstHits hits_;
};

/// [1] The share of a lamp's light that reaches fronts of other surfaces, after surfaces that look away from the light
/// were turned over.
double lit_share(const SceneFile& scene, const LampCandidate& lamp)
{
    SceneFile lit;
    lit.surfaces = scene.surfaces;
    lit.materials = {Material{}, Material{"lamp", {}, {1.0, 1.0, 1.0}, ""}};
    const std::vector<std::uint32_t>& numbers = lamp.is_group ? scene.group : scene.material;
    for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
        lit.material.push_back(numbers[s] == lamp.number ? 1 : 0);
    lit.group.assign(scene.surfaces.size(), 0);
    lit.line.assign(scene.surfaces.size(), 0);
    std::optional<Intersector> intersector(std::in_place, lit.surfaces);
    const std::vector<std::uint32_t> turned = surfaces_to_turn(lit, *intersector, false);
    for (const std::uint32_t s : turned)
        turn_over(lit, s);
    if (!turned.empty())
        intersector.emplace(lit.surfaces);
    return Rays(lit.surfaces, [&](std::uint32_t s) { return lit.material[s] == 1; })
        .share(*intersector, [&](const Hit* hit) { return hit && hit->front && lit.material[hit->surface] == 0; });
}

/// [1] The share of light from all fronts that leaves the scene; by reciprocity, how much of a sky they see.
double open_share(const SceneFile& scene, const Intersector& intersector)
{
    return Rays(scene.surfaces, [](std::uint32_t) { return true; }).share(intersector, [](const Hit* hit) {
        return hit == nullptr;
    });
}

/// [m^2] The sunlit area of fronts, projected along the direction of the sun.
double sunlit_area(const SceneFile& scene, const Intersector& intersector, Vec3 towards_sun)
{
    double turned = 0.0; // the same without shadows
    for (const Surface& surface : scene.surfaces)
        turned += surface.area() * std::max(0.0, dot(surface.normal(), towards_sun));
    const auto faces_sun = [&](std::uint32_t s) { return dot(scene.surfaces[s].normal(), towards_sun) > 0.0; };
    Rays rays(scene.surfaces, faces_sun, towards_sun);
    return turned * rays.share(intersector, [](const Hit* hit) { return hit == nullptr; });
}

constexpr double azimuth = 150.0;
constexpr double elevation = 40.0;
constexpr double sun_irradiance = 20.0; // [W/m^2]

const Advice sky_advice = {Remedy::sky, format("%g", advised_emittance)};
const Advice sun_advice = {Remedy::sun, format("%g,%g,%g", azimuth, elevation, sun_irradiance)};

Advice lamp_advice(const std::string& name)
{
    return {Remedy::lamp, name + format("=%g", advised_emittance)};
}

} // namespace

LampCandidates lamp_candidates(const ObjMesh& mesh, const SceneFile& scene)
{
    return {candidates_by_name(mesh, scene), candidates_by_area(mesh, scene)};
}

LightAdvice advised_light(const LampCandidates& candidates, const SceneFile& scene)
{
    constexpr double enough = 0.05;
    constexpr std::size_t most_tried = 4; // each needs an intersector of its own
    LightAdvice result;
    for (const LampCandidate& candidate : candidates.by_name)
        result.others.push_back(candidate.name);
    const auto take_best_of = [&](std::vector<LampCandidate> tried) {
        tried.resize(std::min(tried.size(), most_tried));
        for (const LampCandidate& candidate : tried) {
            const double share = lit_share(scene, candidate);
            if (result.lamp.empty() || share > result.lit_share) {
                result.lamp = candidate.name;
                result.lamp_area = candidate.area;
                result.lit_share = share;
            }
            if (share >= enough)
                break;
        }
    };
    take_best_of(candidates.by_name);
    if (result.lit_share < enough) {
        const double open = open_share(scene, Intersector(scene.surfaces));
        if (open < enough)
            take_best_of(candidates.materials);
        if (open >= enough || open > result.lit_share) {
            result.lamp.clear();
            result.lit_share = open;
        }
    }
    result.advice = result.lamp.empty() ? std::vector{sky_advice, sun_advice} : std::vector{lamp_advice(result.lamp)};
    result.others.erase(std::remove(result.others.begin(), result.others.end(), result.lamp), result.others.end());
    return result;
}

std::vector<LightYield> light_yields(const LampCandidates& candidates, const SceneFile& scene)
{
    constexpr std::size_t most_lamps = 12;
    std::vector<LampCandidate> lamps = candidates.by_name;
    for (const LampCandidate& material : candidates.materials)
        if (std::none_of(lamps.begin(), lamps.end(), [&](const LampCandidate& c) { return c.name == material.name; }))
            lamps.push_back(material);
    lamps.resize(std::min(lamps.size(), most_lamps));
    std::vector<LightYield> yields;
    for (const LampCandidate& lamp : lamps) {
        const double power = advised_emittance * lamp.area;
        yields.push_back({lamp_advice(lamp.name), power, power * lit_share(scene, lamp)});
    }
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const Intersector intersector(scene.surfaces);
    double area = 0.0;
    for (const Surface& surface : scene.surfaces)
        area += surface.area();
    yields.push_back({sky_advice, unknown, advised_emittance * area * open_share(scene, intersector)});
    const Sun sun = sun_at(azimuth, elevation, {0.0, 1.0, 0.0}, {sun_irradiance, sun_irradiance, sun_irradiance});
    yields.push_back({sun_advice, unknown, sun_irradiance * sunlit_area(scene, intersector, sun.direction)});
    return yields;
}

} // namespace multipath
