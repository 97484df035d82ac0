#include "export/state/scene_archive.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace multipath {

namespace {

void visit_materials(Archive& archive, std::vector<Material>& materials)
{
    std::vector<std::string> names;
    std::vector<std::string> sources;
    std::vector<Rgb> reflectances;
    std::vector<Rgb> emittances;
    for (const Material& material : materials) {
        names.push_back(material.name);
        sources.push_back(material.source);
        reflectances.push_back(material.reflectance);
        emittances.push_back(material.emittance);
    }
    archive.texts("material names", names);
    archive.texts("material sources", sources);
    archive.growing_list<double>("reflectances", reflectances);
    archive.growing_list<double>("emittances", emittances);
    if (names.size() != sources.size() || names.size() != reflectances.size() || names.size() != emittances.size())
        throw ArchiveError("the state is damaged: no such materials");
    materials.clear();
    for (std::size_t m = 0; m < names.size(); ++m)
        materials.push_back({names[m], reflectances[m], emittances[m], sources[m]});
}

void visit_surfaces(Archive& archive, SurfaceList& surfaces)
{
    std::vector<std::uint32_t> shapes;
    std::vector<Vec3> corners; // origin and edges of each
    for (const Surface& surface : surfaces) {
        shapes.push_back(surface.shape == Shape::triangle ? 1 : 0);
        corners.insert(corners.end(), {surface.origin, surface.edge_u, surface.edge_v});
    }
    archive.growing_list<std::uint32_t>("triangles", shapes);
    corners.resize(3 * shapes.size());
    archive.list<double>("surfaces", corners);
    surfaces.clear();
    for (std::size_t s = 0; s < shapes.size(); ++s)
        surfaces.push_back({shapes[s] == 1 ? Shape::triangle : Shape::parallelogram, corners[3 * s], corners[3 * s + 1],
                            corners[3 * s + 2]});
}

// Checks of the properties that readers of scenes guarantee and the program relies on.

bool all_within(std::initializer_list<double> values, double low, double high)
{
    return std::all_of(values.begin(), values.end(), [&](double x) { return low <= x && x <= high; });
}

bool is_sound(const Surface& surface)
{
    constexpr double far = 1e30;
    const auto near = [&](Vec3 v) { return all_within({v.x, v.y, v.z}, -far, far); };
    const double area = surface.area();
    return near(surface.origin) && near(surface.edge_u) && near(surface.edge_v) && area > 0.0 && std::isfinite(area);
}

bool is_sound(const Material& material)
{
    const Rgb rho = material.reflectance;
    const Rgb emittance = material.emittance;
    return all_within({rho.r, rho.g, rho.b}, 0.0, 1.0) &&
           all_within({emittance.r, emittance.g, emittance.b}, 0.0, 1e30);
}

template <class List>
void require_sound(const List& list)
{
    for (const auto& element : list)
        if (!is_sound(element))
            throw ArchiveError("the state is damaged: no such surface or material");
}

void require_below(const std::vector<std::uint32_t>& numbers, std::size_t limit)
{
    for (const std::uint32_t number : numbers)
        if (number >= limit)
            throw ArchiveError("the state is damaged: no such material or group");
}

} // namespace

void ArchivedScene::visit(Archive& archive)
{
    SceneFile kept = file ? *file : SceneFile{};
    std::vector<std::string> path = {kept.path};
    archive.texts("path", path);
    kept.path = path.empty() ? "" : path[0];
    archive.texts("groups", kept.groups);
    archive.texts("warnings", kept.warnings);
    visit_materials(archive, kept.materials);
    visit_surfaces(archive, kept.surfaces);
    for (std::vector<std::uint32_t>* numbers : {&kept.material, &kept.group, &kept.line})
        numbers->resize(kept.surfaces.size());
    archive.list<std::uint32_t>("material", kept.material);
    archive.list<std::uint32_t>("group", kept.group);
    archive.list<std::uint32_t>("line", kept.line);
    archive.value<double>("patch size", patch_size);
    archive.value<std::uint64_t>("two-sided", two_sided);
    archive.value<std::uint64_t>("patches", patches);
    archive.value<std::uint64_t>("hash", hash);
    require_sound(kept.surfaces);
    require_sound(kept.materials);
    require_below(kept.material, kept.materials.size());
    require_below(kept.group, kept.groups.size());
    if (archive.reads())
        file = std::make_shared<const SceneFile>(std::move(kept));
}

ArchivedScene archived(const Scene& scene)
{
    return {scene.shared_file(), scene.patch_size(), scene.two_sided() ? 1u : 0u, scene.patch_count(), scene.hash()};
}

Scene restored(const ArchivedScene& archived)
{
    const double sides = archived.two_sided != 0 ? 2.0 : 1.0;
    const bool fits =
        archived.patch_size > 0.0 && sides * cell_count(archived.file->surfaces, archived.patch_size) ==
                                         static_cast<double>(archived.patches); // before memory is taken for them
    if (!fits)
        throw ArchiveError("the state is damaged: its scene has other patches");
    Scene scene(archived.file, archived.patch_size, archived.two_sided != 0, 1);
    if (scene.hash() != archived.hash)
        throw ArchiveError("the state is damaged: its scene is not the one that was solved");
    return scene;
}

} // namespace multipath
