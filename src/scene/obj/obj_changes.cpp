#include "scene/obj/obj_changes.h"

#include "base/errors.h"
#include "base/lists.h"
#include "base/text_format.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <map>

namespace multipath {

namespace {

/// The faces with some name, by their material, or by their group or object.
struct NamedFaces
{
    std::vector<bool> materials; ///< per material of the mesh
    std::vector<bool> groups;

    bool has(const ObjFace& face) const { return materials[face.material] || groups[face.group]; }
};

/// Throws SettingsError if no face has a material, group or object of this name.
NamedFaces faces_named(const std::string& name, const ObjMesh& mesh)
{
    std::vector<std::string> names = mesh.material_names();
    const auto is_named = [&](const std::string& material) { return material == name || name_in(material) == name; };
    NamedFaces found = {mapped(names, is_named), std::vector<bool>(mesh.groups.size())};
    const auto any_face = [&] {
        return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const ObjFace& face) { return found.has(face); });
    };
    if (any_face())
        return found;
    for (std::size_t k = 0; k < mesh.groups.size() && !name.empty(); ++k)
        found.groups[k] = mesh.groups[k].name == name || mesh.groups[k].other == name;
    if (any_face())
        return found;
    for (const ObjGroup& group : mesh.groups)
        names.insert(names.end(), {group.name, group.other});
    std::vector<std::string> choices; // each once
    for (const std::string& other : names)
        if (!other.empty() && !is_among("`" + other + "`", choices))
            choices.push_back("`" + other + "`");
    throw SettingsError(mesh.path + ": no material or object is called `" + name + "` and has faces, expected one of " +
                        first_of(choices, 12));
}

void leave_out(const std::string& name, ObjMesh& mesh)
{
    const NamedFaces out = faces_named(name, mesh);
    const auto is_out = [&](const ObjFace& face) { return out.has(face); };
    mesh.faces.erase(std::remove_if(mesh.faces.begin(), mesh.faces.end(), is_out), mesh.faces.end());
    if (mesh.faces.empty())
        throw SettingsError(mesh.path + ": no face is left, expected ignored names that leave some faces");
}

void add_lamp(const ObjChanges::Lamp& lamp, ObjMesh& mesh, std::vector<LampMaterial>& lamps)
{
    const NamedFaces lit = faces_named(lamp.name, mesh);
    for (std::uint32_t k = 0; k < lit.materials.size(); ++k)
        if (lit.materials[k])
            lamps.push_back({k, lamp.emittance, ""});
    std::map<std::uint32_t, std::uint32_t> own; // copy of each material of the object
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

} // namespace multipath
