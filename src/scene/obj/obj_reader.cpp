// From text to surfaces: parse_obj() parses the file, and apply() makes the changes of the user. cut_into_pieces() cuts
// polygons into triangles and parallelograms, merge_triangles() rejoins rectangles that the exporter cut, and cut_out()
// removes what is transparent. The MTL files give the materials, and add_textures() reads their images. In the end
// require_physics() refuses a scene that has no meaningful result, and advises what helps.

#include "scene/obj/obj_reader.h"

#include "base/errors.h"
#include "base/lists.h"
#include "base/text_format.h"
#include "scene/obj/cutouts.h"
#include "scene/obj/light_advice.h"
#include "scene/obj/mesh_pieces.h"
#include "scene/obj/mtl_reader.h"
#include "scene/obj/obj_mesh.h"
#include "scene/obj/obj_textures.h"
#include "scene/obj/parallelogram_merge.h"
#include "scene/text/text_lines.h"
#include "scene/text/text_words.h"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace multipath {

namespace {

constexpr Rgb default_reflectance = {0.5, 0.5, 0.5}; ///< [1] of faces without a defined material

using Names = std::vector<std::string>;

void append(Names& list, const Names& more)
{
    list.insert(list.end(), more.begin(), more.end());
}

/// "`a`, `b` and 7 more"
std::string some_names(const Names& names)
{
    return first_of(mapped(names, in_quotes), 5);
}

/// Reads the MTL files that a mesh names, each once. Returns the names of missing ones.
Names read_libraries(const ObjMesh& mesh, MaterialLibrary& library, SceneFile& scene)
{
    Names missing;
    for (const ObjName& names : mesh.libraries) {
        const TextLocation place = {mesh.path, names.line};
        const MtlFiles named = find_mtl_files(names.name, place);
        for (const std::string& file : named.found)
            if (!is_among(file, scene.material_files))
                scene.material_files.push_back(file);
        for (const std::string& name : named.missing)
            if (!is_among(name, missing)) {
                missing.push_back(name);
                scene.warnings.push_back(name_of(place) + ": material file " + in_quotes(name) + " not found");
            }
    }
    for (const std::string& file : scene.material_files)
        read_mtl(file, library);
    append(scene.warnings, library.warnings);
    return missing;
}

/// Gives the materials of the mesh their names in the library, where a comment may follow either. Of two materials of
/// the mesh with one name the first remains.
void name_materials(const MaterialLibrary& library, ObjMesh& mesh)
{
    std::unordered_map<std::string, std::uint32_t> defined = library.number_of_name;
    for (std::uint32_t k = 0; k < library.materials.size(); ++k)
        defined.emplace(name_in(library.materials[k].material.name), k);
    std::unordered_map<std::string, std::uint32_t> number_of_name;
    std::vector<std::uint32_t> numbers;
    std::vector<ObjName> materials;
    for (const ObjName& used : mesh.materials) {
        const std::string plain(name_in(used.name));
        const auto found = defined.find(defined.count(used.name) > 0 ? used.name : plain);
        const std::string& name = found != defined.end() ? library.materials[found->second].material.name : plain;
        const auto [entry, is_new] = number_of_name.emplace(name, static_cast<std::uint32_t>(materials.size()));
        numbers.push_back(entry->second);
        if (is_new)
            materials.push_back({name, used.line});
    }
    mesh.materials = std::move(materials);
    for (ObjFace& face : mesh.faces)
        face.material = numbers[face.material];
}

/// Lowers each channel of the reflectances to the limit [1].
void limit_reflectances(double limit, MaterialLibrary& library, SceneFile& scene)
{
    Names lowered;
    for (MtlMaterial& definition : library.materials) {
        const Rgb rho = definition.material.reflectance;
        definition.material.reflectance = by_channel([&](double r) { return std::min(r, limit); }, rho);
        if (limit == 1.0)
            continue;
        definition.flaw.clear();
        if (definition.material.reflectance != rho)
            lowered.push_back(definition.material.name);
    }
    if (!lowered.empty())
        scene.warnings.push_back(scene.path + format(": reflectance lowered to the limit of %g: ", limit) +
                                 some_names(lowered));
}

/// The definition of each material of the mesh; the default material, with a warning, where no file has one.
std::vector<MtlMaterial> definitions_of(const ObjMesh& mesh, const MaterialLibrary& library, SceneFile& scene)
{
    const Names names = mesh.material_names();
    std::vector<MtlMaterial> definitions;
    for (std::size_t k = 0; k < mesh.materials.size(); ++k) {
        const ObjName& used = mesh.materials[k];
        if (const auto entry = library.number_of_name.find(used.name); entry != library.number_of_name.end()) {
            definitions.push_back(library.materials[entry->second]);
            continue;
        }
        MtlMaterial standing_in;
        standing_in.material = {names[k], default_reflectance, {}, name_of({mesh.path, used.line})};
        standing_in.is_unknown = !used.name.empty();
        const std::string warning =
            standing_in.material.source + ": " +
            (used.name.empty() ? "faces without a material" : "material " + in_quotes(used.name) + " is not defined") +
            ", grey with Kd = 0.5 stands in" + (mesh.colours.empty() ? "" : " where vertices have no colours");
        if (!is_among(warning, scene.warnings)) // not of a lamp's copy
            scene.warnings.push_back(warning);
        definitions.push_back(std::move(standing_in));
    }
    return definitions;
}

/// Takes the definitions of the materials that surfaces have, each once although a lamp has a copy, with the mean
/// reflectances of textures and colours. Those that no surface has are left in the library.
std::vector<MtlMaterial> take_used(const std::vector<MtlMaterial>& definitions, const std::vector<bool>& is_used,
                                   MaterialLibrary& library, SceneFile& scene)
{
    std::vector<MtlMaterial> used;
    std::unordered_set<std::string> names;
    for (std::size_t k = 0; k < definitions.size(); ++k) {
        if (!is_used[k] || !names.insert(definitions[k].material.name).second)
            continue;
        used.push_back(definitions[k]);
        const Material& material = used.back().material = scene.materials[k];
        if (used.back().is_unknown && material.reflectance == default_reflectance &&
            material.texture == Material::no_texture) // no vertices colour it
            scene.unknown_materials.push_back(material.name);
    }
    const auto is_taken = [&](const MtlMaterial& m) { return names.count(m.material.name) > 0; };
    library.materials.erase(std::remove_if(library.materials.begin(), library.materials.end(), is_taken),
                            library.materials.end());
    for (const MtlMaterial& m : library.materials)
        scene.unused_materials.push_back(m.material.source + ": " + m.material.name);
    return used;
}

template <typename Condition>
Names names_where(const std::vector<MtlMaterial>& materials, Condition condition)
{
    Names names;
    for (const MtlMaterial& m : materials)
        if (condition(m))
            names.push_back(m.material.name);
    return names;
}

bool reflects_everything(const MtlMaterial& m)
{
    const Rgb rho = m.material.reflectance;
    return std::max({rho.r, rho.g, rho.b}) == 1.0;
}

void make_lamps(const std::vector<LampMaterial>& lamps, std::vector<Material>& materials)
{
    for (const LampMaterial& lamp : lamps) {
        Material& material = materials[lamp.material];
        material.emittance = lamp.emittance;
        if (!lamp.object.empty())
            material.name += " of " + lamp.object;
    }
}

/// Why a scene has no light. `unused`: the materials that no surface has.
std::string explain_darkness(const ObjMesh& mesh, const Names& missing_files, const Names& unread_textures,
                             const std::vector<MtlMaterial>& unused, const SceneFile& scene)
{
    std::string problem = "no emitter, expected a face whose material has Ke above 0 (1e-30 or more)";
    if (mesh.libraries.empty())
        problem += "; no material file is named (`mtllib`)";
    const auto list = [&](const char* cause, const Names& names) {
        if (!names.empty())
            problem += cause + some_names(names);
    };
    list("; no such material file: ", missing_files);
    list("; used but not defined: ", scene.unknown_materials);
    list("; emitting but used by no face: ",
         names_where(unused, [](const MtlMaterial& m) { return m.material.emittance != Rgb{}; }));
    if (!unread_textures.empty())
        problem += "; textures that are not read: " + first_of(unread_textures, 5);
    return problem;
}

/// Throws InputError for a material that reflects more light than it receives, and for a scene without light, whose
/// problem is `darkness`. The advice avoids all the problems found; the message ends with what it is for ("to lower
/// it").
void require_physics(const std::vector<MtlMaterial>& used, const std::optional<std::string>& darkness,
                     const ObjMesh& mesh, const SceneFile& scene)
{
    const auto bright = std::find_if(used.begin(), used.end(), [](const MtlMaterial& m) { return !m.flaw.empty(); });
    const bool is_bright = bright != used.end();
    if (!is_bright && !darkness)
        return;
    std::vector<Advice> advice;
    // Before there is a lamp it is unknown which surfaces it would light; those with Kd = 1 may trap its light.
    if (is_bright || std::any_of(used.begin(), used.end(), reflects_everything))
        advice.push_back({Remedy::reflectance_limit, "0.9"});
    if (!darkness)
        throw InputError(bright->flaw + "; to lower it", std::move(advice));
    const LightAdvice light = advised_light(mesh, scene);
    advice.insert(advice.end(), light.advice.begin(), light.advice.end());
    throw InputError((is_bright ? bright->flaw + "; " : mesh.path + ": ") + *darkness + "; " + light.text,
                     std::move(advice));
}

void warn_of_materials(const std::vector<MtlMaterial>& used, Names& warnings)
{
    const auto warn = [&](const std::string& flaw, const auto& has_flaw) {
        const auto first = std::find_if(used.begin(), used.end(), has_flaw);
        if (first != used.end())
            warnings.push_back(first->material.source + ": " + flaw + ": " + some_names(names_where(used, has_flaw)));
    };
    warn("Kd = 1 reflects all light of a colour, lower it if that is not meant", reflects_everything);
    warn("no Kd, so the material reflects nothing",
         [](const MtlMaterial& m) { return m.kd_line == 0 && m.material.reflectance == Rgb{}; });
    warn("transparent by `d`, but opaque here unless its faces are ignored",
         [](const MtlMaterial& m) { return m.opacity < 1.0; });
}

void add_surfaces(const LargeVector<Piece>& pieces, const ObjMesh& mesh, SceneFile& scene)
{
    scene.surfaces.reserve(pieces.size());
    scene.material.reserve(pieces.size());
    scene.group.reserve(pieces.size());
    scene.line.reserve(pieces.size());
    for (const ObjGroup& group : mesh.groups) {
        scene.groups.push_back(group.name);
        scene.other_names.push_back(group.other);
    }
    for (const Piece& piece : pieces) {
        const ObjFace& face = mesh.faces[piece.face];
        const Vec3 origin = mesh.at(piece.corners[0]);
        scene.surfaces.push_back({piece.is_triangle() ? Shape::triangle : Shape::parallelogram, origin,
                                  mesh.at(piece.corners[1]) - origin, mesh.at(piece.end_of_v()) - origin});
        scene.material.push_back(face.material);
        scene.group.push_back(face.group);
        scene.line.push_back(face.line);
    }
}

std::string summary(const SceneFile& scene, const ObjMesh& mesh)
{
    const auto emitters = std::count_if(scene.materials.begin(), scene.materials.end(),
                                        [](const Material& m) { return m.emittance != Rgb{}; });
    return counted(scene.materials.size(), "material") + ", " + counted(static_cast<std::size_t>(emitters), "emitter") +
           ", " + counted(mesh.faces.size(), "face") + " -> " + counted(scene.surfaces.size(), "surface");
}

} // namespace

SceneFile read_obj(const std::string& path, const ObjChanges& changes)
{
    ObjMesh mesh = parse_obj(path);
    for (Vec3& vertex : mesh.vertices)
        vertex = changes.unit * vertex;
    SceneFile scene;
    scene.path = path;
    scene.warnings = mesh.warnings;
    MaterialLibrary library;
    const Names missing_files = read_libraries(mesh, library, scene);
    scene.texture_files = library.texture_files;
    name_materials(library, mesh);
    const std::vector<LampMaterial> lamps = apply(changes, mesh);
    limit_reflectances(changes.reflectance_limit, library, scene);
    const std::vector<MtlMaterial> definitions = definitions_of(mesh, library, scene);
    for (const MtlMaterial& definition : definitions) {
        scene.materials.push_back(definition.material);
        mesh.textured.push_back(!definition.reflectance_map.found.empty() || !definition.opacity_map.found.empty());
    }

    const SceneScale scale = scale_of(mesh);
    MeshPieces cut = cut_into_pieces(mesh, scale);
    append(scene.warnings, cut.warnings);
    std::vector<bool> has_pieces(mesh.materials.size());
    for (const Piece& piece : cut.pieces)
        has_pieces[mesh.faces[piece.face].material] = true;
    if (cut.pieces.empty())
        refuse({path, mesh.faces.front().line}, "no face of the file has an area");
    constexpr double smallest_extent = 1e-9; // the counterpart of the largest coordinate, 1e9
    if (scale.extent < smallest_extent)
        refuse({path, 0}, "all faces lie within 1e-9 of each other, expected a scene of sensible size");
    merge_triangles(cut.pieces, mesh, scale);
    TextureFiles textures;
    append(scene.warnings, cut_out(definitions, scale, textures, mesh, cut.pieces));
    if (cut.pieces.empty())
        refuse({path, 0}, "every face is transparent, expected textures with opaque pixels");

    add_surfaces(cut.pieces, mesh, scene);
    const Names unread = add_textures(definitions, cut, mesh, textures, changes.reflectance_limit, scene);
    const std::vector<MtlMaterial> used = take_used(definitions, has_pieces, library, scene);
    warn_of_materials(used, scene.warnings);
    make_lamps(lamps, scene.materials);
    const bool lit = std::any_of(scene.material.begin(), scene.material.end(),
                                 [&](std::uint32_t m) { return scene.materials[m].emittance != Rgb{}; });
    std::optional<std::string> darkness;
    if (!lit && !changes.lit_from_outside)
        darkness = explain_darkness(mesh, missing_files, unread, library.materials, scene);
    require_physics(used, darkness, mesh, scene);
    scene.counts = summary(scene, mesh);
    return scene;
}

} // namespace multipath
