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

/// The first names of materials and groups, for a message.
std::string names_in(const ObjMesh& mesh)
{
    std::vector<std::string> names;
    for (const ObjName& material : mesh.materials)
        names.push_back("`" + name_of_material(material) + "`");
    for (const std::vector<std::string>& list : {mesh.other_names, mesh.groups})
        for (const std::string& name : list)
            if (const std::string quoted = "`" + name + "`";
                !name.empty() && std::find(names.begin(), names.end(), quoted) == names.end())
                names.push_back(quoted);
    return first_of(names, 12);
}

/// Throws SettingsError if no material or group has the name, or no face.
NamedFaces faces_named(const std::string& name, const ObjMesh& mesh)
{
    bool any = false;
    const auto are_named = [&](const auto& list, const auto& name_of) {
        std::vector<bool> result(list.size());
        for (std::size_t k = 0; k < list.size(); ++k)
            if (name_of(list[k]) == name)
                any = result[k] = true;
        return result;
    };
    const auto itself = [](const std::string& text) { return text; };
    NamedFaces found = {are_named(mesh.materials, name_of_material), std::vector<bool>(mesh.groups.size()),
                        std::vector<bool>(mesh.other_names.size())};
    if (!any && !name.empty()) {
        found.groups = are_named(mesh.groups, itself);
        found.other_names = are_named(mesh.other_names, itself);
    }
    if (any) {
        if (std::none_of(mesh.faces.begin(), mesh.faces.end(), [&](const ObjFace& face) { return found.has(face); }))
            throw SettingsError(mesh.path + ": `" + name +
                                "` has no faces, or all of them are ignored; "
                                "expected a name that has faces");
        return found;
    }
    if (const std::string plain(name_in(name)); plain != name)
        return faces_named(plain, mesh);
    throw SettingsError(mesh.path + ": no material or object is called `" + name + "`, expected one of " +
                        names_in(mesh));
}

void leave_out(const std::string& name, ObjMesh& mesh)
{
    const NamedFaces out = faces_named(name, mesh);
    std::size_t corner = 0;
    std::size_t kept_corners = 0;
    std::size_t kept = 0;
    for (const ObjFace& face : mesh.faces) {
        const std::size_t end = corner + face.corner_count;
        if (!out.has(face)) {
            for (LargeVector<std::uint32_t>* list : {&mesh.corners, &mesh.corner_points})
                if (!list->empty())
                    std::copy(list->begin() + static_cast<std::ptrdiff_t>(corner),
                              list->begin() + static_cast<std::ptrdiff_t>(end),
                              list->begin() + static_cast<std::ptrdiff_t>(kept_corners));
            kept_corners += face.corner_count;
            mesh.faces[kept++] = face;
        }
        corner = end;
    }
    mesh.corners.resize(kept_corners);
    mesh.corner_points.resize(std::min(mesh.corner_points.size(), kept_corners));
    mesh.faces.resize(kept);
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
