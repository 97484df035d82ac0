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
#include <iterator>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace multipath {

namespace {

constexpr double default_reflectance = 0.5; ///< [1] of faces without a defined material

void append(std::vector<std::string>& list, std::vector<std::string> more)
{
    list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// The MTL files that a mesh names, without repetitions, and warnings about missing ones.
struct Libraries
{
    std::vector<std::string> files;
    std::vector<std::string> missing;
    std::vector<std::string> warnings;
};

Libraries find_libraries(const ObjMesh& mesh)
{
    const std::string folder = std::filesystem::path(mesh.path).parent_path().string();
    Libraries result;
    std::unordered_set<std::string> known;
    for (const ObjName& names : mesh.libraries) {
        MtlFiles named = find_mtl_files(names.name, {mesh.path, names.line});
        if (!named.missing.empty())
            named = find_mtl_files(name_in(names.name), {mesh.path, names.line});
        for (const std::string& file : named.found)
            if (known.insert(file).second)
                result.files.push_back(file);
        for (const std::string& name : named.missing) {
            if (!known.insert("no " + name).second)
                continue;
            result.missing.push_back(name);
            result.warnings.push_back(name_of({mesh.path, names.line}) + ": material file " + in_quotes(name) +
                                      " not found in the folder " + in_quotes(folder.empty() ? "." : folder));
        }
    }
    return result;
}

/// Gives the materials their names, without the comments after them. Of two materials of the mesh with one name the
/// first remains. A ` # ` in `usemtl` is part of the name if the library has that name.
void name_materials(MaterialLibrary& library, ObjMesh& mesh)
{
    std::vector<std::string> texts;
    for (const MtlMaterial& material : library.materials)
        texts.push_back(material.material.name);
    const std::vector<std::string> defined = without_comments(std::move(texts));
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
    const std::vector<std::string> used_names = without_comments(std::move(texts));
    auto next = used_names.begin();
    std::unordered_map<std::string, std::uint32_t> number_of_name;
    std::vector<std::uint32_t> numbers;
    std::vector<ObjName> materials;
    for (ObjName& used : mesh.materials) {
        const std::string plain(name_in(used.name));
        const std::string name = plain != used.name ? *next++ : plain;
        const auto same_text = number_of_text.find(used.name);
        used.name = same_text != number_of_text.end() ? defined[same_text->second]
                    : number_of_text.count(plain) > 0 ? plain
                                                      : name;
        const auto [entry, is_new] = number_of_name.emplace(used.name, static_cast<std::uint32_t>(materials.size()));
        numbers.push_back(entry->second);
        if (is_new)
            materials.push_back(used);
    }
    mesh.materials = std::move(materials);
    for (ObjFace& face : mesh.faces)
        face.material = numbers[face.material];
}

/// The materials of a scene as its faces use them.
struct UsedMaterials
{
    std::vector<MtlMaterial> used;          ///< defined, and used by a face
    std::vector<MtlMaterial> unused;        ///< defined only
    std::vector<std::string> unknown_names; ///< used but not defined: replaced by the default material
    bool default_used = false;              ///< for unknown names, or for faces without a material
    std::vector<std::string> files;         ///< MTL files that were read
};

/// The materials of a mesh, by their indices in the mesh.
struct MaterialList
{
    std::vector<Material> materials;
    std::vector<MtlMaterial> definitions; ///< of the same materials
    UsedMaterials by_origin;
    std::vector<std::string> warnings;
};

/// For each material of the mesh, true if a face that was not dropped has it.
std::vector<bool> materials_of(const LargeVector<Piece>& pieces, const ObjMesh& mesh)
{
    std::vector<bool> has_pieces(mesh.materials.size(), false);
    for (const Piece& piece : pieces)
        has_pieces[mesh.faces[piece.face].material] = true;
    return has_pieces;
}

std::vector<std::string> quoted(std::vector<std::string> names)
{
    for (std::string& name : names)
        name = in_quotes(name);
    return names;
}

/// " in `a.mtl` or `b.mtl`"
std::string in_files(const std::vector<std::string>& files)
{
    return files.empty() ? "" : " in " + join(quoted(files), " or ");
}

/// Adds the default material in place of a material that faces use but no file defines.
void add_default_material(const ObjMesh& mesh, const ObjName& name, MaterialList& list)
{
    const bool has_name = !name.name.empty();
    Material material;
    material.name = name_of_material(name);
    material.reflectance = {default_reflectance, default_reflectance, default_reflectance};
    material.source = name_of({mesh.path, name.line});
    const std::string flaw =
        has_name ? "material " + in_quotes(name.name) + " is not defined" + in_files(list.by_origin.files)
                 : "faces without a material";
    const std::string warning = material.source + ": " + flaw + ", grey with Kd = 0.5 stands in" +
                                (mesh.colours.empty() ? "" : " where vertices have no colours");
    if (std::find(list.warnings.begin(), list.warnings.end(), warning) == list.warnings.end()) { // not of a lamp's copy
        list.warnings.push_back(warning);
        if (has_name)
            list.by_origin.unknown_names.push_back(name.name);
    }
    list.definitions.emplace_back();
    list.materials.push_back(std::move(material));
    list.by_origin.default_used = true;
}

/// Lowers each channel of the reflectances to the limit. Returns the names of the materials that exceeded it.
std::vector<std::string> limit_reflectances(double limit, MaterialLibrary& library)
{
    std::vector<std::string> lowered;
    for (MtlMaterial& material : library.materials) {
        const Rgb rho = material.material.reflectance;
        material.material.reflectance = {std::min(rho.r, limit), std::min(rho.g, limit), std::min(rho.b, limit)};
        if (limit < 1.0)
            material.flaw.clear();
        if (limit < 1.0 && material.material.reflectance != rho)
            lowered.push_back(material.material.name);
    }
    return lowered;
}

/// Looks up the materials of a mesh in the library; `has_pieces`: see materials_of().
MaterialList look_up_materials(const ObjMesh& mesh, MaterialLibrary library, const std::vector<bool>& has_pieces,
                               const std::vector<std::string>& files)
{
    MaterialList list;
    for (const std::string& file : files)
        list.by_origin.files.push_back(std::filesystem::path(file).filename().string());
    list.warnings = std::move(library.warnings);
    std::vector<bool> is_used(library.materials.size(), false);
    for (std::size_t i = 0; i < mesh.materials.size(); ++i) {
        const auto entry = library.number_of_name.find(mesh.materials[i].name);
        if (entry == library.number_of_name.end()) {
            add_default_material(mesh, mesh.materials[i], list);
        } else {
            list.materials.push_back(library.materials[entry->second].material);
            list.definitions.push_back(library.materials[entry->second]);
            is_used[entry->second] = is_used[entry->second] || has_pieces[i];
        }
    }
    for (std::size_t i = 0; i < library.materials.size(); ++i)
        (is_used[i] ? list.by_origin.used : list.by_origin.unused).push_back(std::move(library.materials[i]));
    return list;
}

/// "`a`, `b` and 7 more"
std::string some_names(const std::vector<std::string>& names)
{
    return first_of(quoted(names), 5);
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

bool emits_light(const MtlMaterial& m)
{
    return m.material.emittance != Rgb{};
}

bool reflects_everything(const MtlMaterial& m)
{
    const Rgb rho = m.material.reflectance;
    return std::max({rho.r, rho.g, rho.b}) == 1.0;
}

/// The materials that are probably lamps described by Ka. Modellers store ambient reflection in Ka, which is at most 1
/// and similar for most materials. A lamp stands out: it is above 1 while others are not.
std::vector<std::string> lamps_by_ambient(const std::vector<MtlMaterial>& used)
{
    std::vector<std::string> lamps = names_where(used, [](const MtlMaterial& m) {
        return std::max({m.ambient.r, m.ambient.g, m.ambient.b}) > 1.0;
    });
    return lamps.size() < used.size() || used.size() == 1 ? lamps : std::vector<std::string>{};
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

bool is_lit(const std::vector<Material>& materials, const std::vector<bool>& has_pieces)
{
    for (std::size_t k = 0; k < materials.size(); ++k)
        if (has_pieces[k] && materials[k].emittance != Rgb{})
            return true;
    return false;
}

/// A message that says why a scene has no light.
std::string explain_darkness(const UsedMaterials& materials, const ObjMesh& mesh,
                             const std::vector<std::string>& missing_files, EmissionFrom emission_from)
{
    const std::string keyword = emission_from == EmissionFrom::ka ? "Ka" : "Ke";
    std::string problem = "no emitter, expected a face whose material has " + keyword + " above 0";
    const std::vector<std::string> idle = names_where(materials.unused, emits_light);
    if (mesh.libraries.empty())
        problem += "; no material file is named (`mtllib`)";
    if (!missing_files.empty())
        problem += "; no such material file: " + some_names(missing_files);
    if (!materials.unknown_names.empty())
        problem += "; used but not defined" + (materials.files.empty() ? "" : " in " + some_names(materials.files)) +
                   ": " + some_names(materials.unknown_names);
    const std::vector<std::string> too_dark =
        names_where(materials.used, [](const MtlMaterial& m) { return m.emission_too_small; });
    if (!too_dark.empty())
        problem += "; below 1e-30, which counts as 0: " + some_names(too_dark);
    if (!idle.empty())
        problem += "; emitting but used by no face: " + some_names(idle);
    return problem;
}

/// True if every edge occurs equally often in both directions, as in the walls of a room or the faces of a block.
bool is_closed(const ObjMesh& mesh)
{
    const LargeVector<std::uint32_t> welded = weld(mesh.vertices);
    LargeVector<FaceEdge> edges;
    auto first = mesh.corners.begin();
    for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
        std::vector<std::uint32_t> corners(first, first + mesh.faces[face].corner_count);
        first += mesh.faces[face].corner_count;
        for (std::uint32_t& corner : corners)
            corner = welded[corner];
        add_edges(face, corners, edges);
    }
    bool closed = true;
    for_each_edge(std::move(edges), [&](auto begin, auto end) {
        const auto upward = std::count_if(begin, end, [](const FaceEdge& side) { return side.upward; });
        closed = closed && 2 * upward == end - begin;
    });
    return closed;
}

/// True if light could be reflected forever: the surfaces are a closed room, and all reflect all light of one channel.
bool nothing_absorbs(const UsedMaterials& materials, const ObjMesh& mesh, const SurfaceList& surfaces)
{
    const auto all_reflect = [&](double Rgb::*channel) {
        return std::all_of(materials.used.begin(), materials.used.end(),
                           [&](const MtlMaterial& m) { return m.material.reflectance.*channel >= 1.0; });
    };
    if (materials.default_used || !(all_reflect(&Rgb::r) || all_reflect(&Rgb::g) || all_reflect(&Rgb::b)))
        return false;
    return is_interior(surfaces) && is_closed(mesh);
}

/// Throws InputError for a scene that would give no result, or a wrong one. The advice avoids all the problems found;
/// the message ends with what it is for ("to lower it").
void require_physics(const UsedMaterials& materials, bool lit, const ObjMesh& mesh, const SceneFile& scene,
                     const std::vector<std::string>& missing_files, const std::vector<std::string>& unread_textures,
                     EmissionFrom emission_from)
{
    std::vector<std::string> problems;
    std::vector<Advice> advice;
    LampCandidates candidates;
    const auto too_bright = std::find_if(materials.used.begin(), materials.used.end(),
                                         [](const MtlMaterial& m) { return !m.flaw.empty(); });
    if (too_bright != materials.used.end())
        problems.push_back(too_bright->flaw);
    if (nothing_absorbs(materials, mesh, scene.surfaces))
        problems.push_back(
            "nothing absorbs light: the surfaces are closed and every material has Kd = 1 in the same colour, "
            "expected Kd below 1 in one of them");
    if (!unread_textures.empty() && !(problems.empty() && lit))
        problems.push_back("textures that are not read: " + first_of(unread_textures, 5));
    // Before there is a lamp it is unknown which surfaces it would light; those with Kd = 1 may trap its light.
    const bool may_trap = !names_where(materials.used, reflects_everything).empty();
    if (!problems.empty() || (!lit && may_trap))
        advice.push_back({Remedy::reflectance_limit, "0.9"});
    if (!lit) {
        candidates = lamp_candidates(mesh, scene);
        problems.push_back(explain_darkness(materials, mesh, missing_files, emission_from));
        const std::vector<std::string> by_ambient = lamps_by_ambient(materials.used);
        if (emission_from == EmissionFrom::ke && !by_ambient.empty()) {
            problems.push_back("to read lamps from Ka (" + some_names(by_ambient) + ")");
            advice.push_back({Remedy::emission_from, "Ka"});
        } else {
            const LightAdvice light = advised_light(candidates, scene);
            const bool sky = light.lamp.empty();
            const std::string others =
                light.others.empty() ? ""
                                     : (sky ? ", or make a lamp of " : ", or another: ") + some_names(light.others);
            problems.push_back(
                (sky ? "to light it by sky and sun"
                     : "to make a lamp of material or object " + in_quotes(light.lamp) +
                           format(" (%.3g m^2, so %.3g W)", light.lamp_area, advised_emittance * light.lamp_area)) +
                others);
            advice.insert(advice.end(), light.advice.begin(), light.advice.end());
        }
    }
    if (problems.empty())
        return;
    const std::string text = join(problems, "; ") + (lit ? "; to lower it" : "");
    const std::string message = too_bright != materials.used.end() ? text : name_of({mesh.path, 0}) + ": " + text;
    if (!lit)
        throw DarkScene(InputError(message, std::move(advice)), std::move(candidates), scene);
    throw InputError(message, std::move(advice));
}

void add_warning(std::vector<std::string>& warnings, const std::vector<MtlMaterial>& used,
                 bool (*has_flaw)(const MtlMaterial&), const std::string& flaw)
{
    const auto first = std::find_if(used.begin(), used.end(), has_flaw);
    if (first != used.end())
        warnings.push_back(first->material.source + ": " + flaw + ": " + some_names(names_where(used, has_flaw)));
}

std::vector<std::string> warnings_of_materials(const UsedMaterials& materials)
{
    std::vector<std::string> warnings;
    add_warning(warnings, materials.used, reflects_everything,
                "Kd = 1 reflects all light of a colour, lower it if that is not meant");
    add_warning(
        warnings, materials.used, [](const MtlMaterial& m) { return m.kd_line == 0; },
        "no Kd, so the material reflects nothing");
    add_warning(
        warnings, materials.used, [](const MtlMaterial& m) { return m.opacity < 1.0; },
        "transparent by `d` or `Tr`, but opaque here unless its faces are ignored");
    return warnings;
}

Surface surface_of(const Piece& piece, const LargeVector<Vec3>& vertices)
{
    const Vec3 origin = vertices[piece.corners[0]];
    const Vec3 along_u = vertices[piece.corners[1]];
    const Vec3 along_v = vertices[piece.corners[piece.is_triangle() ? 2 : 3]];
    return {piece.is_triangle() ? Shape::triangle : Shape::parallelogram, origin, along_u - origin, along_v - origin};
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
        scene.surfaces.push_back(surface_of(piece, mesh.vertices));
        scene.material.push_back(face.material);
        scene.group.push_back(face.group);
        scene.line.push_back(face.line);
        if (!scene.other_names.empty())
            scene.other_name.push_back(face.other_name);
    }
}

/// Marks the textured materials: their quads are cut in two if the texture does not form one parallelogram.
void mark_textured(const MaterialLibrary& library, ObjMesh& mesh)
{
    for (const ObjName& material : mesh.materials) {
        const auto entry = library.number_of_name.find(material.name);
        const MtlMaterial* const definition =
            entry != library.number_of_name.end() ? &library.materials[entry->second] : nullptr;
        mesh.textured.push_back(definition &&
                                !(definition->reflectance_map.found.empty() && definition->opacity_map.found.empty()));
    }
}

/// Replaces Kd by the mean reflectance of materials with textures or coloured vertices.
void take_colours(const SceneFile& scene, std::vector<MtlMaterial>& used)
{
    for (MtlMaterial& definition : used)
        for (const Material& material : scene.materials)
            if (material.name == definition.material.name && material.reflectance != definition.material.reflectance) {
                definition.material.reflectance = material.reflectance;
                definition.kd_line = std::max(definition.kd_line, std::uint32_t{1});
            }
}

std::string summary(const SceneFile& scene, const ObjMesh& mesh, const UsedMaterials& materials,
                    std::size_t merged_pairs, std::size_t zero_area_faces)
{
    const auto is_emitter = [](const Material& m) { return m.emittance != Rgb{}; };
    const auto emitter_count = std::count_if(scene.materials.begin(), scene.materials.end(), is_emitter);
    std::vector<std::string> notes;
    if (merged_pairs != 0)
        notes.push_back(counted(merged_pairs, "pair") + " of triangles joined");
    if (zero_area_faces != 0)
        notes.push_back(counted(zero_area_faces, "zero-area face") + " dropped");
    if (mesh.faces_without_corners != 0)
        notes.push_back(counted(mesh.faces_without_corners, "face") + " of fewer than three vertices dropped");
    if (!materials.unknown_names.empty())
        notes.push_back(counted(materials.unknown_names.size(), "unknown material") + " replaced");
    if (!materials.unused.empty())
        notes.push_back(counted(materials.unused.size(), "material") + " not used");

    const std::string text = counted(scene.materials.size(), "material") + ", " +
                             counted(static_cast<std::size_t>(emitter_count), "emitter") + ", " +
                             counted(mesh.faces.size() + mesh.faces_without_corners, "face") + " -> " +
                             counted(scene.surfaces.size(), "surface");
    return text + (notes.empty() ? "" : "; " + join(notes));
}

} // namespace

SceneFile read_obj(const std::string& path, EmissionFrom emission_from, const ObjChanges& changes)
{
    ObjMesh mesh = parse_obj(path);
    for (Vec3& vertex : mesh.vertices)
        vertex = changes.unit * vertex;
    Libraries libraries = find_libraries(mesh);
    MaterialLibrary library;
    for (const std::string& file : libraries.files)
        read_mtl(file, emission_from, library);
    name_materials(library, mesh);
    const std::vector<LampMaterial> lamps = apply(changes, mesh);
    std::vector<std::string> texture_files = std::move(library.texture_files);
    const std::vector<std::string> lowered = limit_reflectances(changes.reflectance_limit, library);
    const SceneScale scale = scale_of(mesh);
    mark_textured(library, mesh);
    MeshPieces cut = cut_into_pieces(mesh, scale);
    const std::vector<bool> has_pieces = materials_of(cut.pieces, mesh);
    MaterialList list = look_up_materials(mesh, std::move(library), has_pieces, libraries.files);
    if (cut.pieces.empty())
        refuse({path, mesh.faces.front().line}, "no face of the file has an area");
    constexpr double smallest_extent = 1e-9; // the counterpart of the largest coordinate, 1e9
    if (scale.extent < smallest_extent)
        refuse({path, 0}, "all faces lie within 1e-9 of each other, expected a scene of sensible size");

    SceneFile scene;
    scene.path = path;
    scene.material_files = std::move(libraries.files);
    scene.texture_files = std::move(texture_files);
    scene.warnings = std::move(mesh.warnings);
    append(scene.warnings, std::move(libraries.warnings));
    append(scene.warnings, std::move(list.warnings));
    if (!lowered.empty())
        scene.warnings.push_back(path +
                                 format(": reflectance lowered to the limit of %g: ", changes.reflectance_limit) +
                                 some_names(lowered));
    append(scene.warnings, std::move(cut.warnings));
    scene.materials = std::move(list.materials);
    scene.groups = mesh.groups;
    const std::size_t merged_pairs = merge_triangles(cut.pieces, mesh, scale);
    TextureFiles textures;
    append(scene.warnings, cut_out(list.definitions, scale, textures, mesh, cut.pieces));
    if (cut.pieces.empty())
        refuse({path, 0}, "every face is transparent, expected textures with opaque pixels");
    add_surfaces(cut.pieces, mesh, scene);
    const std::vector<std::string> unread =
        add_textures(list.definitions, cut, mesh, textures, changes.reflectance_limit, scene);
    take_colours(scene, list.by_origin.used);
    make_lamps(lamps, scene.materials);
    append(scene.warnings, warnings_of_materials(list.by_origin));
    require_physics(list.by_origin, changes.lit_from_outside || is_lit(scene.materials, materials_of(cut.pieces, mesh)),
                    mesh, scene, libraries.missing, unread, emission_from);
    for (const std::string& name : list.by_origin.unknown_names)
        if (std::any_of(scene.materials.begin(), scene.materials.end(), [&](const Material& material) {
                return material.name == name && material.texture == Material::no_texture &&
                       material.reflectance == Rgb{default_reflectance, default_reflectance, default_reflectance};
            })) // not coloured by its vertices
            scene.unknown_materials.push_back(name);
    for (const MtlMaterial& unused : list.by_origin.unused)
        scene.unused_materials.push_back(unused.material.source + ": " + unused.material.name);
    scene.dropped_faces = cut.zero_area_faces + mesh.faces_without_corners;
    scene.counts = summary(scene, mesh, list.by_origin, merged_pairs, cut.zero_area_faces);
    return scene;
}

} // namespace multipath
