#include "scene/obj/obj_changes.h"

#include "base/errors.h"
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
    std::vector<bool> other_names;

    bool has_object(const ObjFace& face) const { return groups[face.group] || other_names[face.other_name]; }
    bool has(const ObjFace& face) const { return materials[face.material] || has_object(face); }
};

/// Throws SettingsError if no face has a material, group or object of this name.
NamedFaces faces_named(const std::string& name, const ObjMesh& mesh)
{
    const auto are_named = [&](const std::vector<std::string>& names) {
        std::vector<bool> result;
        for (const std::string& other : names)
            result.push_back(other == name);
        return result;
    };
    NamedFaces found = {are_named(mesh.material_names()), std::vector<bool>(mesh.groups.size()),
                        std::vector<bool>(mesh.other_names.size())};
    const auto any_face = [&] {
        return std::any_of(mesh.faces.begin(), mesh.faces.end(), [&](const ObjFace& face) { return found.has(face); });
    };
    if (any_face())
        return found;
    if (!name.empty()) {
        found.groups = are_named(mesh.groups);
        found.other_names = are_named(mesh.other_names);
    }
    if (any_face())
        return found;
    if (const std::string plain(name_in(name)); plain != name)
        return faces_named(plain, mesh);
    std::vector<std::string> names;
    for (const std::vector<std::string>& list : {mesh.material_names(), mesh.other_names, mesh.groups})
        for (const std::string& other : list)
            if (const std::string quoted = "`" + other + "`";
                !other.empty() && std::find(names.begin(), names.end(), quoted) == names.end())
                names.push_back(quoted);
    throw SettingsError(mesh.path + ": no material or object is called `" + name + "` and has faces, expected one of " +
                        first_of(names, 12));
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
        if (!lit.has_object(face))
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
