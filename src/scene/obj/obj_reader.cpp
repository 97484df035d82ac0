// From text to surfaces: parse_obj() parses the file, and apply() makes the changes of the user. cut_into_pieces() cuts
// polygons into triangles and parallelograms, merge_triangles() rejoins rectangles that the exporter cut, and cut_out()
// removes what is transparent. The MTL files give the materials, and add_textures() reads their images. In the end
// require_physics() refuses a scene that has no meaningful result, and advises what helps.

#include "scene/obj/obj_reader.h"

#include "base/errors.h"
#include "base/text_format.h"
#include "geometry/intersector/surface_sizes.h"
#include "scene/obj/cutouts.h"
#include "scene/obj/light_advice.h"
#include "scene/obj/mesh_pieces.h"
#include "scene/obj/mtl_reader.h"
#include "scene/obj/obj_mesh.h"
#include "scene/obj/obj_textures.h"
#include "scene/obj/parallelogram_merge.h"
#include "scene/surface_edges.h"
#include "scene/text/text_lines.h"
#include "scene/text/text_words.h"
#include "scene/vertex_weld.h"

#include <algorithm>
#include <filesystem>
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

bool contains(const Names& list, const std::string& name)
{
    return std::find(list.begin(), list.end(), name) != list.end();
}

/// "`a`, `b` and 7 more"
std::string some_names(Names names)
{
    for (std::string& name : names)
        name = in_quotes(name);
    return first_of(names, 5);
}

/// Reads the MTL files that a mesh names, each once. Returns the names of missing ones.
Names read_libraries(const ObjMesh& mesh, EmissionFrom emission_from, MaterialLibrary& library, SceneFile& scene)
{
    const std::string folder = std::filesystem::path(mesh.path).parent_path().string();
    Names missing;
    for (const ObjName& names : mesh.libraries) {
        const TextLocation place = {mesh.path, names.line};
        MtlFiles named = find_mtl_files(names.name, place);
        if (!named.missing.empty())
            named = find_mtl_files(name_in(names.name), place);
        for (const std::string& file : named.found)
            if (!contains(scene.material_files, file))
                scene.material_files.push_back(file);
        for (const std::string& name : named.missing)
            if (!contains(missing, name)) {
                missing.push_back(name);
                scene.warnings.push_back(name_of(place) + ": material file " + in_quotes(name) +
                                         " not found in the folder " + in_quotes(folder.empty() ? "." : folder));
            }
    }
    for (const std::string& file : scene.material_files)
        read_mtl(file, emission_from, library);
    append(scene.warnings, library.warnings);
    return missing;
}

/// Gives the materials their names, without the comments after them. Of two materials of the mesh with one name the
/// first remains. A ` # ` in `usemtl` is part of the name if the library has that name.
void name_materials(MaterialLibrary& library, ObjMesh& mesh)
{
    Names texts;
    for (const MtlMaterial& material : library.materials)
        texts.push_back(material.material.name);
    const Names defined = without_comments(std::move(texts));
    const std::unordered_map<std::string, std::uint32_t> number_of_text = std::move(library.number_of_name);
    library.number_of_name.clear();
    for (std::uint32_t k = 0; k < defined.size(); ++k) {
        library.materials[k].material.name = defined[k];
        library.number_of_name.emplace(defined[k], k);
    }

    texts.clear();
    for (const ObjName& used : mesh.materials)
        if (name_in(used.name) != used.name)
            texts.push_back(used.name);
    const Names plain_names = without_comments(std::move(texts));
    auto next = plain_names.begin();
    std::unordered_map<std::string, std::uint32_t> number_of_name;
    std::vector<std::uint32_t> numbers;
    std::vector<ObjName> materials;
    for (const ObjName& used : mesh.materials) {
        std::string name(name_in(used.name));
        const std::string& undefined_name = name != used.name ? *next++ : used.name;
        if (const auto same_text = number_of_text.find(used.name); same_text != number_of_text.end())
            name = defined[same_text->second];
        else if (number_of_text.count(name) == 0)
            name = undefined_name;
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
        Rgb& reflectance = definition.material.reflectance;
        const Rgb rho = reflectance;
        reflectance = {std::min(rho.r, limit), std::min(rho.g, limit), std::min(rho.b, limit)};
        if (limit < 1.0)
            definition.flaw.clear();
        if (limit < 1.0 && reflectance != rho)
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
    std::string files;
    for (const std::string& file : scene.material_files)
        files += (files.empty() ? " in " : " or ") + in_quotes(std::filesystem::path(file).filename().string());
    for (std::size_t k = 0; k < mesh.materials.size(); ++k) {
        const ObjName& used = mesh.materials[k];
        if (const auto entry = library.number_of_name.find(used.name); entry != library.number_of_name.end()) {
            definitions.push_back(library.materials[entry->second]);
            continue;
        }
        MtlMaterial standing_in;
        standing_in.material = {names[k], default_reflectance, {}, name_of({mesh.path, used.line})};
        const std::string warning =
            standing_in.material.source + ": " +
            (used.name.empty() ? "faces without a material"
                               : "material " + in_quotes(used.name) + " is not defined" + files) +
            ", grey with Kd = 0.5 stands in" + (mesh.colours.empty() ? "" : " where vertices have no colours");
        if (!contains(scene.warnings, warning)) // not of a lamp's copy
            scene.warnings.push_back(warning);
        definitions.push_back(std::move(standing_in));
    }
    return definitions;
}

/// The definitions of the materials that faces have, each once, with the mean reflectances of textures and colours.
std::vector<MtlMaterial> used_definitions(const std::vector<MtlMaterial>& definitions, const SceneFile& scene)
{
    std::vector<bool> is_used(definitions.size());
    for (const std::uint32_t material : scene.material)
        is_used[material] = true;
    std::vector<MtlMaterial> used;
    std::unordered_set<std::string> names;
    for (std::size_t k = 0; k < definitions.size(); ++k) {
        if (!is_used[k] || !names.insert(definitions[k].material.name).second)
            continue;
        used.push_back(definitions[k]);
        used.back().material = scene.materials[k];
    }
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

/// True if every edge occurs equally often in both directions, as in the walls of a room or the faces of a block.
bool is_closed(const ObjMesh& mesh)
{
    const LargeVector<std::uint32_t> welded = weld(mesh.vertices);
    LargeVector<FaceEdge> edges;
    std::vector<std::uint32_t> corners;
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        corners.clear();
        for (std::uint32_t k = 0; k < mesh.faces[face].corner_count; ++k)
            corners.push_back(welded[mesh.corners[mesh.faces[face].first_corner + k].vertex]);
        add_edges(face, corners, edges);
    }
    bool closed = true;
    for_each_edge(std::move(edges), [&](auto begin, auto end) {
        const auto upward = std::count_if(begin, end, [](const FaceEdge& side) { return side.upward; });
        closed = closed && 2 * upward == end - begin;
    });
    return closed;
}

/// Why a scene has no light.
std::string explain_darkness(const std::string& keyword, const ObjMesh& mesh, const Names& missing_files,
                             const MaterialLibrary& library, const SceneFile& scene)
{
    std::string problem = "no emitter, expected a face whose material has " + keyword + " above 0";
    if (mesh.libraries.empty())
        problem += "; no material file is named (`mtllib`)";
    const auto list = [&](const char* cause, const Names& names) {
        if (!names.empty())
            problem += cause + some_names(names);
    };
    list("; no such material file: ", missing_files);
    list("; used but not defined: ", scene.unknown_materials);
    list("; below 1e-30, which counts as 0: ",
         names_where(library.materials, [](const MtlMaterial& m) { return m.is_used && m.emission_too_small; }));
    list("; emitting but used by no face: ", names_where(library.materials, [](const MtlMaterial& m) {
             return !m.is_used && m.material.emittance != Rgb{};
         }));
    return problem;
}

/// Throws InputError for a scene that would give no result, or a wrong one. The advice avoids all the problems found;
/// the message ends with what it is for ("to lower it").
void require_physics(const std::vector<MtlMaterial>& used, bool lit, EmissionFrom emission_from, const ObjMesh& mesh,
                     const MaterialLibrary& library, const SceneFile& scene, const Names& missing_files,
                     const Names& unread_textures)
{
    const auto is_closed_room = [&] { return is_interior(scene.surfaces) && is_closed(mesh); };
    const auto all_reflect = [&](double Rgb::*channel) {
        return std::all_of(used.begin(), used.end(),
                           [&](const MtlMaterial& m) { return m.material.reflectance.*channel >= 1.0; });
    };
    Names problems;
    std::vector<Advice> advice;
    const auto too_bright =
        std::find_if(used.begin(), used.end(), [](const MtlMaterial& m) { return !m.flaw.empty(); });
    if (too_bright != used.end())
        problems.push_back(too_bright->flaw);
    if ((all_reflect(&Rgb::r) || all_reflect(&Rgb::g) || all_reflect(&Rgb::b)) && is_closed_room())
        problems.push_back(
            "nothing absorbs light: the surfaces are closed and every material has Kd = 1 in the same colour, "
            "expected Kd below 1 in one of them");
    if (!unread_textures.empty() && !(problems.empty() && lit))
        problems.push_back("textures that are not read: " + first_of(unread_textures, 5));
    // Before there is a lamp it is unknown which surfaces it would light; those with Kd = 1 may trap its light.
    const bool may_trap = std::any_of(used.begin(), used.end(), reflects_everything);
    if (!problems.empty() || (!lit && may_trap))
        advice.push_back({Remedy::reflectance_limit, "0.9"});
    if (!lit) {
        // Modellers store ambient reflection in Ka, which is at most 1. A lamp stands out: above 1, unlike others.
        const Names lamps_by_ambient = names_where(used, [](const MtlMaterial& m) {
            return std::max({m.ambient.r, m.ambient.g, m.ambient.b}) > 1.0;
        });
        LightAdvice light = {"to read lamps from Ka (" + some_names(lamps_by_ambient) + ")",
                             {{Remedy::emission_from, "Ka"}}};
        if (emission_from == EmissionFrom::ka || lamps_by_ambient.empty() ||
            (lamps_by_ambient.size() == used.size() && used.size() > 1))
            light = advised_light(mesh, scene, is_closed_room());
        problems.push_back(
            explain_darkness(emission_from == EmissionFrom::ka ? "Ka" : "Ke", mesh, missing_files, library, scene));
        problems.push_back(light.text);
        advice.insert(advice.end(), light.advice.begin(), light.advice.end());
    }
    if (problems.empty())
        return;
    throw InputError((too_bright != used.end() ? "" : mesh.path + ": ") + join(problems, "; ") +
                         (lit ? "; to lower it" : ""),
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
    warn("transparent by `d` or `Tr`, but opaque here unless its faces are ignored",
         [](const MtlMaterial& m) { return m.opacity < 1.0; });
}

void add_surfaces(const LargeVector<Piece>& pieces, const ObjMesh& mesh, SceneFile& scene)
{
    scene.surfaces.reserve(pieces.size());
    scene.material.reserve(pieces.size());
    scene.group.reserve(pieces.size());
    scene.line.reserve(pieces.size());
    if (mesh.other_names.size() > 1)
        scene.other_names = mesh.other_names;
    for (const Piece& piece : pieces) {
        const ObjFace& face = mesh.faces[piece.face];
        const Vec3 origin = mesh.at(piece.corners[0]);
        scene.surfaces.push_back({piece.is_triangle() ? Shape::triangle : Shape::parallelogram, origin,
                                  mesh.at(piece.corners[1]) - origin, mesh.at(piece.end_of_v()) - origin});
        scene.material.push_back(face.material);
        scene.group.push_back(face.group);
        scene.line.push_back(face.line);
        if (!scene.other_names.empty())
            scene.other_name.push_back(face.other_name);
    }
}

/// Lists the materials that no file defines, unless vertices colour them, and those that no face uses.
void list_odd_materials(const std::vector<MtlMaterial>& definitions, const ObjMesh& mesh,
                        const std::vector<bool>& has_pieces, MaterialLibrary& library, SceneFile& scene)
{
    for (std::size_t k = 0; k < definitions.size(); ++k) {
        const std::string& name = mesh.materials[k].name;
        const auto entry = library.number_of_name.find(name);
        const bool is_grey =
            scene.materials[k].reflectance == default_reflectance && scene.materials[k].texture == Material::no_texture;
        if (entry != library.number_of_name.end())
            library.materials[entry->second].is_used |= has_pieces[k];
        else if (!name.empty() && is_grey && !contains(scene.unknown_materials, name))
            scene.unknown_materials.push_back(name);
    }
    for (const MtlMaterial& m : library.materials)
        if (!m.is_used)
            scene.unused_materials.push_back(m.material.source + ": " + m.material.name);
}

std::string summary(const SceneFile& scene, const ObjMesh& mesh, std::size_t merged_pairs, std::size_t zero_area_faces)
{
    Names notes;
    const auto note = [&](std::size_t count, const char* noun, const char* fate) {
        if (count != 0)
            notes.push_back(counted(count, noun) + fate);
    };
    note(merged_pairs, "pair", " of triangles joined");
    note(zero_area_faces, "zero-area face", " dropped");
    note(mesh.faces_without_corners, "face", " of fewer than three vertices dropped");
    note(scene.unknown_materials.size(), "unknown material", " replaced");
    note(scene.unused_materials.size(), "material", " not used");
    const auto emitters = std::count_if(scene.materials.begin(), scene.materials.end(),
                                        [](const Material& m) { return m.emittance != Rgb{}; });
    return counted(scene.materials.size(), "material") + ", " + counted(static_cast<std::size_t>(emitters), "emitter") +
           ", " + counted(mesh.faces.size() + mesh.faces_without_corners, "face") + " -> " +
           counted(scene.surfaces.size(), "surface") + (notes.empty() ? "" : "; " + join(notes));
}

} // namespace

SceneFile read_obj(const std::string& path, EmissionFrom emission_from, const ObjChanges& changes)
{
    ObjMesh mesh = parse_obj(path);
    for (Vec3& vertex : mesh.vertices)
        vertex = changes.unit * vertex;
    SceneFile scene;
    scene.path = path;
    scene.warnings = mesh.warnings;
    MaterialLibrary library;
    const Names missing_files = read_libraries(mesh, emission_from, library, scene);
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
    const std::size_t merged_pairs = merge_triangles(cut.pieces, mesh, scale);
    TextureFiles textures;
    append(scene.warnings, cut_out(definitions, scale, textures, mesh, cut.pieces));
    if (cut.pieces.empty())
        refuse({path, 0}, "every face is transparent, expected textures with opaque pixels");

    scene.groups = mesh.groups;
    add_surfaces(cut.pieces, mesh, scene);
    const Names unread = add_textures(definitions, cut, mesh, textures, changes.reflectance_limit, scene);
    list_odd_materials(definitions, mesh, has_pieces, library, scene);
    const std::vector<MtlMaterial> used = used_definitions(definitions, scene);
    warn_of_materials(used, scene.warnings);
    make_lamps(lamps, scene.materials);
    const bool lit = std::any_of(scene.material.begin(), scene.material.end(),
                                 [&](std::uint32_t m) { return scene.materials[m].emittance != Rgb{}; });
    require_physics(used, changes.lit_from_outside || lit, emission_from, mesh, library, scene, missing_files, unread);
    scene.dropped_faces = cut.zero_area_faces + mesh.faces_without_corners;
    scene.counts = summary(scene, mesh, merged_pairs, cut.zero_area_faces);
    return scene;
}

} // namespace multipath
