#include "scene/obj/obj_changes.h"

#include "scene/input_error.h"
#include "scene/text/text_format.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

namespace multipath {

namespace {

/// Tells of each face whether it has a name.
struct NamedFaces
{
    std::vector<bool> materials; ///< per material of the mesh
    std::vector<bool> groups;

    bool has(const ObjFace& face) const { return materials[face.material] || groups[face.group]; }
};

/// As results call it.
std::string name_of_material(const ObjName& material)
{
    return material.name.empty() ? "default" : material.name;
}

std::string some_names(const ObjMesh& mesh)
{
    constexpr std::size_t most = 12;
    std::vector<std::string> names;
    for (const ObjName& material : mesh.materials)
        names.push_back("`" + name_of_material(material) + "`");
    for (const std::string& group : mesh.groups)
        if (!group.empty())
            names.push_back("`" + group + "`");
    if (names.size() > most) {
        const std::string rest = std::to_string(names.size() - most);
        names.resize(most);
        return join(names) + " and " + rest + " more";
    }
    return join(names);
}

NamedFaces faces_named(const std::string& option, const std::string& name, const ObjMesh& mesh)
{
    NamedFaces found = {std::vector<bool>(mesh.materials.size()), std::vector<bool>(mesh.groups.size())};
    bool any = false;
    for (std::size_t k = 0; k < mesh.materials.size(); ++k)
        if (name_of_material(mesh.materials[k]) == name)
            any = found.materials[k] = true;
    for (std::size_t k = 0; k < mesh.groups.size() && !any; ++k)
        found.groups[k] = !name.empty() && mesh.groups[k] == name;
    if (any || std::find(found.groups.begin(), found.groups.end(), true) != found.groups.end()) {
        if (std::none_of(mesh.faces.begin(), mesh.faces.end(), [&](const ObjFace& face) { return found.has(face); }))
            throw SettingsError(mesh.path + ": " + option + ": `" + name +
                                "` has no face, or none that is not ignored; "
                                "expected the name of one that has");
        return found;
    }
    throw SettingsError(mesh.path + ": " + option + ": no material or object is called `" + name +
                        "`, expected one of its names: " + some_names(mesh));
}

void leave_out(const std::string& name, ObjMesh& mesh)
{
    const NamedFaces out = faces_named("--ignore", name, mesh);
    std::size_t corner = 0;
    std::size_t kept_corners = 0;
    std::size_t kept = 0;
    for (const ObjFace& face : mesh.faces) {
        const std::size_t end = corner + face.corner_count;
        if (!out.has(face)) {
            std::copy(mesh.corners.begin() + static_cast<std::ptrdiff_t>(corner),
                      mesh.corners.begin() + static_cast<std::ptrdiff_t>(end),
                      mesh.corners.begin() + static_cast<std::ptrdiff_t>(kept_corners));
            kept_corners += face.corner_count;
            mesh.faces[kept++] = face;
        }
        corner = end;
    }
    mesh.corners.resize(kept_corners);
    mesh.faces.resize(kept);
    if (mesh.faces.empty())
        throw SettingsError(mesh.path + ": --ignore: no face is left, expected names that not all faces have");
}

void add_lamp(const ObjChanges::Lamp& lamp, ObjMesh& mesh, std::vector<LampMaterial>& lamps)
{
    const NamedFaces lit = faces_named("--lamp", lamp.name, mesh);
    for (std::uint32_t k = 0; k < lit.materials.size(); ++k)
        if (lit.materials[k])
            lamps.push_back({k, lamp.emittance, ""});
    std::map<std::uint32_t, std::uint32_t> own; // for each material of the object
    for (ObjFace& face : mesh.faces) {
        if (!lit.groups[face.group])
            continue;
        const auto [entry, is_new] = own.try_emplace(face.material, static_cast<std::uint32_t>(mesh.materials.size()));
        if (is_new) {
            mesh.materials.push_back(ObjName(mesh.materials[face.material]));
            lamps.push_back({entry->second, lamp.emittance, lamp.name});
        }
        face.material = entry->second;
    }
}

std::string lower_case(std::string text)
{
    for (char& c : text)
        c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return text;
}

/// Of polygons.
struct Areas
{
    std::vector<double> materials;
    std::vector<double> groups;
};

Areas areas_of(const ObjMesh& mesh)
{
    Areas areas = {std::vector<double>(mesh.materials.size()), std::vector<double>(mesh.groups.size())};
    std::size_t first = 0;
    for (const ObjFace& face : mesh.faces) {
        Vec3 sum;
        const Vec3 origin = mesh.vertices[mesh.corners[first]];
        for (std::size_t k = 1; k + 1 < face.corner_count; ++k)
            sum = sum + cross(mesh.vertices[mesh.corners[first + k]] - origin,
                              mesh.vertices[mesh.corners[first + k + 1]] - origin);
        areas.materials[face.material] += 0.5 * length(sum);
        areas.groups[face.group] += 0.5 * length(sum);
        first += face.corner_count;
    }
    return areas;
}

} // namespace

std::vector<LampMaterial> apply(const ObjChanges& changes, ObjMesh& mesh)
{
    for (const std::string& name : changes.ignored)
        leave_out(name, mesh);
    std::vector<LampMaterial> lamps;
    for (const ObjChanges::Lamp& lamp : changes.lamps)
        add_lamp(lamp, mesh, lamps);
    return lamps;
}

std::vector<std::string> likely_lamps(const ObjMesh& mesh)
{
    // Lamps first, then what daylight comes through, in some languages of public models.
    constexpr std::array<std::string_view, 32> words = {
        "lamp",    "light",   "bulb",     "emit",   "emis", "lumi",   "neon",   "fluo",
        "glow",    "led_",    "licht",    "leucht", "luce", "luz",    "svjetl", "svetl",
        "lantern", "chandel", "candle",   "sconce", "sky",  "himmel", "window", "fenster",
        "fenetre", "ventana", "finestra", "prozor", "glas", "vidrio", "vetro",  "staklo"};
    const Areas areas = areas_of(mesh);
    std::vector<std::string> materials; // --lamp takes a name for that of a material first
    for (const ObjName& material : mesh.materials)
        materials.push_back(name_of_material(material));
    std::vector<std::string> names;
    const auto add = [&](const std::string& name, std::string_view word) {
        if (lower_case(name).find(word) != std::string::npos &&
            std::find(names.begin(), names.end(), name) == names.end())
            names.push_back(name);
    };
    for (const std::string_view word : words) {
        for (std::size_t k = 0; k < mesh.materials.size(); ++k)
            if (areas.materials[k] > 0.0)
                add(mesh.materials[k].name, word);
        for (std::size_t k = 0; k < mesh.groups.size(); ++k)
            if (areas.groups[k] > 0.0 &&
                std::find(materials.begin(), materials.end(), mesh.groups[k]) == materials.end())
                add(mesh.groups[k], word);
    }
    if (names.empty()) {
        const std::vector<double>& of = areas.materials;
        names.push_back(materials[static_cast<std::size_t>(std::max_element(of.begin(), of.end()) - of.begin())]);
    }
    return names;
}

} // namespace multipath
