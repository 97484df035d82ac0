#include "scene/obj/light_check.h"

#include "scene/text/text_lines.h"
#include "scene/vertex_weld.h"

#include <algorithm>
#include <cstdint>

namespace multipath {

namespace {

/// "`a`, `b` and 7 more"
std::string list_of(const std::vector<std::string>& names)
{
    constexpr std::size_t most_names = 5;
    std::string list;
    for (std::size_t i = 0; i < std::min(names.size(), most_names); ++i)
        list += (i == 0 ? "" : ", ") + in_quotes(names[i]);
    return list + (names.size() > most_names ? " and " + std::to_string(names.size() - most_names) + " more" : "");
}

template <typename Condition>
std::vector<std::string> names_where(const std::vector<MtlMaterial>& materials, Condition condition)
{
    std::vector<std::string> names;
    for (const MtlMaterial& m : materials)
        if (condition(m))
            names.push_back(m.material.name);
    return names;
}

bool emits(const MtlMaterial& m)
{
    return m.material.emittance != Rgb{};
}

bool reflects_everything(const MtlMaterial& m)
{
    const Rgb rho = m.material.reflectance;
    return std::max({rho.r, rho.g, rho.b}) == 1.0;
}

/// Modellers write ambient light into Ka, which ends at 1, and the same for most materials. A lamp sticks out: it is
/// above 1 where others are not.
std::vector<std::string> lamps_by_ambient(const std::vector<MtlMaterial>& used)
{
    std::vector<std::string> lamps = names_where(used, [](const MtlMaterial& m) {
        return std::max({m.ambient.r, m.ambient.g, m.ambient.b}) > 1.0;
    });
    return lamps.size() < used.size() || used.size() == 1 ? lamps : std::vector<std::string>{};
}

void require_emitter(const UsedMaterials& materials, const ObjMesh& mesh, EmissionFrom emission_from)
{
    if (std::any_of(materials.used.begin(), materials.used.end(), emits))
        return;
    const std::string keyword = emission_from == EmissionFrom::ka ? "Ka" : "Ke";
    std::string problem = "no emitter, expected a face whose material has " + keyword + " above 0";
    const std::vector<std::string> idle = names_where(materials.unused, emits);
    const std::vector<std::string> lamps = lamps_by_ambient(materials.used);
    if (mesh.libraries.empty())
        problem += "; no material file is named (`mtllib`)";
    if (!materials.unknown_names.empty())
        problem += "; used but defined nowhere: " + list_of(materials.unknown_names) +
                   (materials.files.empty() ? "" : ", read " + list_of(materials.files));
    const std::vector<std::string> too_dark =
        names_where(materials.used, [](const MtlMaterial& m) { return m.emission_too_small; });
    if (!too_dark.empty())
        problem += "; below 1e-30, which counts as 0: " + list_of(too_dark);
    if (!idle.empty())
        problem += "; emitting but used by no face: " + list_of(idle);
    if (emission_from == EmissionFrom::ke && !lamps.empty())
        problem += "; Ka makes a lamp of " + list_of(lamps) + ": try --emission-from Ka";
    refuse({mesh.path, 0}, problem);
}

/// Every edge is run through as often one way as the other, as on the walls of a room or the sides of a block.
bool is_closed(const ObjMesh& mesh)
{
    const LargeVector<std::uint32_t> welded = weld(mesh.vertices);
    LargeVector<std::uint64_t> edges;
    LargeVector<std::uint64_t> reversed_edges;
    std::size_t first = 0;
    for (const ObjFace& face : mesh.faces) {
        for (std::size_t i = 0; i < face.corner_count; ++i) {
            const std::uint64_t from = welded[mesh.corners[first + i]];
            const std::uint64_t to = welded[mesh.corners[first + (i + 1) % face.corner_count]];
            edges.push_back((from << 32) | to);
            reversed_edges.push_back((to << 32) | from);
        }
        first += face.corner_count;
    }
    std::sort(edges.begin(), edges.end());
    std::sort(reversed_edges.begin(), reversed_edges.end());
    return edges == reversed_edges;
}

void require_absorption(const UsedMaterials& materials, const ObjMesh& mesh)
{
    const auto all_reflect = [&](double Rgb::*channel) {
        return std::all_of(materials.used.begin(), materials.used.end(),
                           [&](const MtlMaterial& m) { return m.material.reflectance.*channel == 1.0; });
    };
    if (materials.default_used || !(all_reflect(&Rgb::r) || all_reflect(&Rgb::g) || all_reflect(&Rgb::b)))
        return;
    if (is_closed(mesh))
        refuse({mesh.path, 0}, "nothing absorbs: the surfaces are closed and every material has Kd = 1 in the same "
                               "colour, expected Kd below 1 in one of them");
}

void add_warning(std::vector<std::string>& warnings, const std::vector<MtlMaterial>& used,
                 bool (*has_flaw)(const MtlMaterial&), const std::string& flaw)
{
    const auto first = std::find_if(used.begin(), used.end(), has_flaw);
    if (first != used.end())
        warnings.push_back(first->material.source + ": " + flaw + ": " + list_of(names_where(used, has_flaw)));
}

} // namespace

std::vector<std::string> check_light(const UsedMaterials& materials, const ObjMesh& mesh, EmissionFrom emission_from)
{
    require_emitter(materials, mesh, emission_from);
    require_absorption(materials, mesh);

    std::vector<std::string> warnings;
    add_warning(warnings, materials.used, reflects_everything,
                "Kd = 1 reflects all light of a colour, lower it if that is not meant");
    add_warning(
        warnings, materials.used, [](const MtlMaterial& m) { return m.kd_line == 0; },
        "no Kd, so the material reflects nothing");
    return warnings;
}

} // namespace multipath
