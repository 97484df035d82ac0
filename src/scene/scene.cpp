#include "scene/scene.h"

#include "geometry/surface_boxes.h"
#include "scene/input_error.h"
#include "scene/scene_hash.h"

#include <utility>

namespace multipath {

namespace {

std::vector<Tessellation> tessellate_all(const std::vector<Surface>& surfaces, double patch_size)
{
    std::vector<Tessellation> result;
    result.reserve(surfaces.size());
    for (const Surface& surface : surfaces)
        result.push_back(tessellate(surface, patch_size));
    return result;
}

Surface turned_over(const Surface& s)
{
    return {s.shape, s.origin, s.edge_v, s.edge_u};
}

} // namespace

SceneFile flipped(SceneFile file)
{
    for (Surface& surface : file.surfaces)
        surface = turned_over(surface);
    return file;
}

Scene::Scene(SceneFile file, double patch_size, bool two_sided, int threads)
    : Scene(std::make_shared<const SceneFile>(std::move(file)), patch_size, two_sided, threads)
{
}

Scene::Scene(std::shared_ptr<const SceneFile> file, double patch_size, bool two_sided, int threads)
    : file_(std::move(file)),
      two_sided_(two_sided),
      patch_size_(patch_size),
      intersector_(file_->surfaces, *available_kernels()[0], threads),
      bounds_(bounds_of(file_->surfaces)),
      tessellations_(tessellate_all(file_->surfaces, patch_size))
{
    if (file_->surfaces.empty())
        throw InputError(file_->path + ": the scene has no surface; expected at least one face with an area");

    std::uint64_t cells = 0;
    for (const Tessellation& tessellation : tessellations_)
        cells += tessellation.cell_count();
    const std::uint64_t patches = two_sided ? 2 * cells : cells;
    constexpr std::uint64_t patch_limit = std::uint64_t{1} << 31;
    if (patches >= patch_limit)
        throw SettingsError(file_->path + ": this patch size gives " + std::to_string(patches) +
                            " patches; expected fewer than 2^31; choose a larger one with --patch-size");
    cell_count_ = static_cast<std::uint32_t>(cells);
    patch_count_ = static_cast<std::uint32_t>(patches);

    surface_of_.reserve(cell_count_);
    Rgb reflecting_area;
    for (std::uint32_t s = 0; s < file_->surfaces.size(); ++s) {
        const Material& material = surface_material(s);
        const double area = file_->surfaces[s].area();
        const double sides_area = (two_sided ? 2.0 : 1.0) * area;
        first_cell_.push_back(static_cast<std::uint32_t>(surface_of_.size()));
        surface_of_.resize(surface_of_.size() + tessellations_[s].cell_count(), s);
        cell_area_.push_back(area / static_cast<double>(tessellations_[s].cell_count()));
        total_area_ += sides_area;
        source_power_ += area * material.emittance;
        reflecting_area += sides_area * material.reflectance;
    }
    average_reflectance_ = (1.0 / total_area_) * reflecting_area;
    hash_ = scene_hash(*file_, tessellations_, two_sided);
    if (!(mean(source_power_) > 0.0))
        throw InputError(file_->path + ": no emitter: the scene has no light; expected a material with Ke above 0");
}

std::vector<double> Scene::areas() const
{
    std::vector<double> areas(patch_count_);
    for (std::uint32_t i = 0; i < patch_count_; ++i)
        areas[i] = area(i);
    return areas;
}

Patch Scene::patch(std::uint32_t patch) const
{
    const std::uint32_t cell = cell_of(patch);
    const std::uint32_t s = surface_of_[cell];
    const Surface shape = tessellations_[s].cell(file_->surfaces[s], cell - first_cell_[s]);
    return {s, is_front(patch) ? shape : turned_over(shape)};
}

} // namespace multipath
