// From text to surfaces: parse_obj reads the words of the file, cut_into_pieces makes flat pieces of its polygons,
// merge_triangles undoes what exporters cut, and the MTL files say what the pieces do with light.

#include "scene/obj/obj_reader.h"

#include "scene/obj/light_check.h"
#include "scene/obj/mesh_pieces.h"
#include "scene/obj/mtl_reader.h"
#include "scene/obj/obj_mesh.h"
#include "scene/obj/parallelogram_merge.h"
#include "scene/text/text_lines.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <unordered_set>
#include <utility>

namespace multipath {

namespace {

constexpr double default_reflectance = 0.5; ///< [1] of what has no material, or one that is not defined

void append(std::vector<std::string>& list, std::vector<std::string> more)
{
    list.insert(list.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

std::vector<std::string> find_libraries(const ObjMesh& mesh)
{
    std::vector<std::string> files;
    std::unordered_set<std::string> known;
    for (const ObjName& names : mesh.libraries)
        for (const std::string& file : find_mtl_files(names.name, {mesh.path, names.line}))
            if (known.insert(file).second)
                files.push_back(file);
    return files;
}

MaterialLibrary read_libraries(const std::vector<std::string>& files, EmissionFrom emission_from)
{
    MaterialLibrary library;
    for (const std::string& file : files)
        read_mtl(file, emission_from, library);
    return library;
}

/// What the faces of a mesh are made of, by the numbers that they use.
struct MaterialList
{
    std::vector<Material> materials;
    UsedMaterials by_origin;
    std::vector<std::string> warnings;
};

/// For each material of the mesh, whether anything that was not dropped has it.
std::vector<bool> materials_of(const LargeVector<Piece>& pieces, const ObjMesh& mesh)
{
    std::vector<bool> has_pieces(mesh.materials.size(), false);
    for (const Piece& piece : pieces)
        has_pieces[mesh.faces[piece.face].material] = true;
    return has_pieces;
}

/// " in `a.mtl` or `b.mtl`"
std::string in_files(const std::vector<std::string>& files)
{
    std::string text;
    for (const std::string& file : files)
        text += (text.empty() ? " in " : " or ") + in_quotes(file);
    return text;
}

/// Adds the default material in place of one that the faces name but no file defines.
void add_default_material(const ObjMesh& mesh, const ObjName& name, MaterialList& list)
{
    const bool has_name = !name.name.empty();
    Material material;
    material.name = has_name ? name.name : "default";
    material.reflectance = {default_reflectance, default_reflectance, default_reflectance};
    material.source = name_of({mesh.path, name.line});
    const std::string flaw =
        has_name ? "material " + in_quotes(name.name) + " is not defined" + in_files(list.by_origin.files)
                 : "faces without a material";
    list.warnings.push_back(material.source + ": " + flaw + ", grey with Kd = 0.5 stands in");
    list.materials.push_back(std::move(material));
    list.by_origin.default_used = true;
    if (has_name)
        list.by_origin.unknown_names.push_back(name.name);
}

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
            is_used[entry->second] = has_pieces[i];
        }
    }
    for (std::size_t i = 0; i < library.materials.size(); ++i)
        (is_used[i] ? list.by_origin.used : list.by_origin.unused).push_back(std::move(library.materials[i]));
    return list;
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
    for (const Piece& piece : pieces) {
        const ObjFace& face = mesh.faces[piece.face];
        scene.surfaces.push_back(surface_of(piece, mesh.vertices));
        scene.material.push_back(face.material);
        scene.group.push_back(face.group);
        scene.line.push_back(face.line);
    }
}

/// "1 face", "2 faces"
std::string counted(std::size_t count, const std::string& noun)
{
    return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

struct DropCounts
{
    std::size_t merged_pairs = 0;
    std::size_t zero_area_faces = 0;
};

std::string summary(const SceneFile& scene, const ObjMesh& mesh, const UsedMaterials& materials, DropCounts counts)
{
    const auto emits = [](const Material& m) { return m.emittance != Rgb{}; };
    const auto emitter_count = std::count_if(scene.materials.begin(), scene.materials.end(), emits);
    std::vector<std::string> notes;
    if (counts.merged_pairs != 0)
        notes.push_back(counted(counts.merged_pairs, "pair") + " of triangles joined");
    if (counts.zero_area_faces != 0)
        notes.push_back(counted(counts.zero_area_faces, "zero-area face") + " dropped");
    if (mesh.faces_without_corners != 0)
        notes.push_back(counted(mesh.faces_without_corners, "face") + " of fewer than three vertices dropped");
    if (!materials.unknown_names.empty())
        notes.push_back(counted(materials.unknown_names.size(), "unknown material") + " replaced");
    if (!materials.unused.empty())
        notes.push_back(counted(materials.unused.size(), "material") + " not used");

    std::string text = counted(scene.materials.size(), "material") + ", " +
                       counted(static_cast<std::size_t>(emitter_count), "emitter") + ", " +
                       counted(mesh.faces.size() + mesh.faces_without_corners, "face") + " -> " +
                       counted(scene.surfaces.size(), "surface");
    for (std::size_t i = 0; i < notes.size(); ++i)
        text += (i == 0 ? "; " : ", ") + notes[i];
    return text;
}

} // namespace

SceneFile read_obj(const std::string& path, EmissionFrom emission_from)
{
    ObjMesh mesh = parse_obj(path);
    std::vector<std::string> material_files = find_libraries(mesh);
    MaterialLibrary library = read_libraries(material_files, emission_from);
    const SceneScale scale = scale_of(mesh);
    MeshPieces cut = cut_into_pieces(mesh, scale);
    MaterialList list = look_up_materials(mesh, std::move(library), materials_of(cut.pieces, mesh), material_files);
    if (cut.pieces.empty())
        refuse({path, mesh.faces.front().line}, "no face of the file has an area");
    constexpr double smallest_extent = 1e-9; // as largest_coordinate
    if (scale.extent < smallest_extent)
        refuse({path, 0}, "all faces lie within 1e-9 of each other, expected a scene of sensible size");

    SceneFile scene;
    scene.path = path;
    scene.material_files = std::move(material_files);
    scene.warnings = std::move(mesh.warnings);
    append(scene.warnings, std::move(list.warnings));
    append(scene.warnings, std::move(cut.warnings));
    append(scene.warnings, check_light(list.by_origin, mesh, emission_from));
    scene.materials = std::move(list.materials);
    scene.groups = mesh.groups;
    const std::size_t merged_pairs = merge_triangles(cut.pieces, mesh, scale);
    add_surfaces(cut.pieces, mesh, scene);
    scene.unknown_materials = list.by_origin.unknown_names;
    for (const MtlMaterial& unused : list.by_origin.unused)
        scene.unused_materials.push_back(unused.material.source + ": " + unused.material.name);
    scene.dropped_faces = cut.zero_area_faces + mesh.faces_without_corners;
    scene.counts = summary(scene, mesh, list.by_origin, {merged_pairs, cut.zero_area_faces});
    return scene;
}

} // namespace multipath
