// A Scene joins three views of the same surfaces: the Intersector for rays and lines, the tessellation into patches,
// and what each patch reflects and emits. Quantities that vary over a surface (textures, shadows of the sun) are
// averaged over each patch here, once, since radiosity is constant over a patch.

#include "scene/scene.h"

#include "base/errors.h"
#include "base/lists.h"
#include "base/mix_bits.h"
#include "geometry/intersector/hit_lists.h"
#include "geometry/intersector/intersector.h"
#include "geometry/intersector/surface_sizes.h"
#include "parallel/blocks.h"

#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace multipath {

namespace {

/// Chains mix_bits() over 64-bit values; -0 counts as 0.
class Hash
{
public:
    template <class... Values>
    void add(const Values&... values)
    {
        (chain(values), ...);
    }
    std::uint64_t value() const { return state_; }

private:
    void chain(std::uint64_t value) { state_ = mix_bits(state_ ^ value); }
    void chain(double value) { chain(bits_of(value)); }
    void chain(Vec3 v) { add(v.x, v.y, v.z); }
    void chain(Rgb c) { add(c.r, c.g, c.b); }

    std::uint64_t state_ = 0xcbf29ce484222325u;
};

} // namespace

std::uint64_t scene_hash(const SceneFile& file, const LargeVector<Tessellation>& tessellations, bool two_sided)
{
    Hash hash;
    hash.add(std::uint64_t{two_sided});
    for (std::size_t s = 0; s < file.surfaces.size(); ++s) {
        const Surface& surface = file.surfaces[s];
        const Material& material = file.materials[file.material[s]];
        const Tessellation& tessellation = tessellations[s];
        hash.add(std::uint64_t{surface.shape == Shape::triangle}, surface.origin, surface.edge_u, surface.edge_v,
                 material.reflectance, material.emittance, std::uint64_t{tessellation.cells_u},
                 std::uint64_t{tessellation.cells_v});
        if (material.texture != Material::no_texture) {
            const TextureFrame& frame = file.texture_frames[s];
            hash.add(file.textures[material.texture]->hash(), material.texture_scale);
            for (const TexturePoint p : {frame.origin, frame.along_u, frame.along_v})
                hash.add(p.s, p.t, frame.known ? 1.0 : 0.0);
        }
        for (std::uint32_t cell = 0; tessellation.trees && cell < tessellation.cell_count(); ++cell)
            hash.add(std::uint64_t{tessellation.level(cell)});
    }
    if (file.sun)
        hash.add(file.sun->direction, file.sun->irradiance);
    return hash.value();
}

double cell_count(const SceneFile& file, double patch_size)
{
    return cell_count(file.without_sky(), patch_size) + file.sky_surfaces;
}

namespace {

LargeVector<Tessellation> tessellate_all(const SceneFile& file, double patch_size)
{
    LargeVector<Tessellation> result;
    result.reserve(file.surfaces.size());
    for (const Surface& surface : file.surfaces)
        result.push_back(result.size() < file.own_surfaces() ? tessellate(surface, patch_size) : Tessellation{});
    return result;
}

Surface turned_over(const Surface& s)
{
    return {s.shape, s.origin, s.edge_v, s.edge_u};
}

} // namespace

std::vector<std::string> input_files(const SceneFile& file)
{
    std::vector<std::string> files = {file.path};
    files.insert(files.end(), file.material_files.begin(), file.material_files.end());
    files.insert(files.end(), file.texture_files.begin(), file.texture_files.end());
    for (const Material& material : file.materials) // "file:line"; states do not hold material_files
        files.push_back(material.source.substr(0, material.source.rfind(':')));
    return files;
}

void turn_over(SceneFile& file, std::size_t surface)
{
    file.surfaces[surface] = turned_over(file.surfaces[surface]);
    if (surface < file.texture_frames.size())
        std::swap(file.texture_frames[surface].along_u, file.texture_frames[surface].along_v);
}

SceneFile flipped(SceneFile file)
{
    for (std::size_t s = 0; s < file.surfaces.size(); ++s)
        turn_over(file, s);
    file.is_flipped = !file.is_flipped;
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
      intersector_(std::make_shared<const Intersector>(file_->surfaces, threads, file_->sky_surfaces)),
      bounds_(bounds_of(file_->surfaces)),
      tessellations_(tessellate_all(*file_, patch_size))
{
    if (file_->surfaces.empty())
        throw InputError(file_->path + ": the scene has no surface; expected at least one face with an area");

    number_cells();
    cell_area_.reserve(tessellations_.size());
    Rgb reflecting_area;
    compute_textured_reflectances(threads);
    for (std::uint32_t s = 0; s < file_->surfaces.size(); ++s) {
        const Material& material = surface_material(s);
        const double area = file_->surfaces[s].area();
        const double sides_area = (two_sided ? 2.0 : 1.0) * area;
        cell_area_.push_back(area / static_cast<double>(tessellations_[s].cell_count()));
        total_area_ += sides_area;
        own_area_ += is_sky(s) ? 0.0 : sides_area;
        (is_sky(s) ? sky_power_ : lamp_power_) += area * material.emittance;
        reflecting_area += sides_area * material.reflectance;
    }
    average_reflectance_ = (1.0 / total_area_) * reflecting_area;
    compute_sunlight(threads);
    if (!file_->sun && !(mean(lamp_power_ + sky_power_) > 0.0))
        throw InputError(file_->path + ": no emitter: the scene has no light; expected a material with Ke above 0");
}

void Scene::number_cells()
{
    const std::uint64_t cells = sum_over(tessellations_, &Tessellation::cell_count);
    const std::uint64_t patches = two_sided_ ? 2 * cells : cells;
    constexpr std::uint64_t patch_limit = std::uint64_t{1} << 31;
    if (patches >= patch_limit)
        throw SettingsError(file_->path + ": this patch size gives " + std::to_string(patches) +
                                " patches; expected fewer than 2^31",
                            {{Remedy::patch_size, "", "sets a larger one"}});
    cell_count_ = static_cast<std::uint32_t>(cells);
    patch_count_ = static_cast<std::uint32_t>(patches);
    first_cell_.clear();
    first_cell_.reserve(tessellations_.size());
    surface_of_.clear();
    surface_of_.reserve(cell_count_);
    for (std::uint32_t s = 0; s < tessellations_.size(); ++s) {
        first_cell_.push_back(static_cast<std::uint32_t>(surface_of_.size()));
        surface_of_.resize(surface_of_.size() + tessellations_[s].cell_count(), s);
    }
    hash_ = scene_hash(*file_, tessellations_, two_sided_);
}

namespace {

/// The number of these points of a surface that the sun reaches.
std::size_t count_sunlit(const Scene& scene, std::uint32_t surface, const std::vector<Vec3>& points)
{
    const std::vector<Line> rays = mapped(points, [&](Vec3 point) { return Line{point, scene.file().sun->direction}; });
    const std::vector<std::uint32_t> from(points.size(), surface);
    FirstHits hits;
    scene.intersector().closest_hits_from(from.data(), rays.data(), rays.size(), hits);
    std::size_t count = 0;
    for (std::size_t k = 0; k < rays.size(); ++k)
        count += !hits.is_hit(k) || scene.is_sky(hits[k].surface) ? 1 : 0;
    return count;
}

/// The share of a patch that the sun reaches, estimated from `count` points of the R2 sequence (Roberts 2018), an
/// additive recurrence of low discrepancy.
double sunlit_share(const Scene& scene, const Patch& patch, std::size_t count)
{
    constexpr double step_u = 0.7548776662466927;
    constexpr double step_v = 0.5698402909980532;
    const bool is_triangle = patch.shape.shape == Shape::triangle;
    // The first point, the middle of the square, is on an edge of the triangle, where rounding may hide the sun.
    const std::size_t first = is_triangle ? 1 : 0;
    std::vector<Vec3> points;
    points.reserve(count);
    for (std::size_t k = first; k < first + count; ++k) {
        double u = 0.5 + static_cast<double>(k) * step_u;
        double v = 0.5 + static_cast<double>(k) * step_v;
        u -= std::floor(u);
        v -= std::floor(v);
        const bool fold = is_triangle && u + v > 1.0;
        points.push_back(fold ? patch.shape.at(1.0 - u, 1.0 - v) : patch.shape.at(u, v));
    }
    return static_cast<double>(count_sunlit(scene, patch.surface, points)) / static_cast<double>(count);
}

} // namespace

void Scene::compute_textured_reflectances(int threads)
{
    if (file_->textures.empty())
        return;
    reflectance_.resize(cell_count_);
    parallel_numbers(static_cast<std::uint32_t>(file_->surfaces.size()), threads, [&](std::uint32_t s) {
        const Material& material = surface_material(s);
        const Tessellation& tessellation = tessellations_[s];
        for (std::uint32_t cell = 0; cell < tessellation.cell_count(); ++cell) {
            Rgb& reflectance = reflectance_[first_cell_[s] + cell];
            if (!is_textured(s)) {
                reflectance = material.reflectance;
                continue;
            }
            std::vector<std::array<double, 2>> uv;
            for (const GridPoint corner : tessellation.corners(cell))
                uv.push_back({static_cast<double>(corner.i) / tessellation.grid_u(),
                              static_cast<double>(corner.j) / tessellation.grid_v()});
            reflectance =
                material.texture_scale * texture_mean(*file_->textures[material.texture], file_->texture_frames[s], uv);
        }
    });
}

Rgb Scene::reflectance_at(std::uint32_t surface, double u, double v) const
{
    const Material& material = surface_material(surface);
    if (material.texture == Material::no_texture)
        return material.reflectance;
    const Texture& texture = *file_->textures[material.texture];
    const TextureFrame& frame = file_->texture_frames[surface];
    return material.texture_scale * (frame.known ? texture.at(frame.at(u, v)) : texture.mean());
}

void Scene::compute_sunlight(int threads)
{
    if (!file_->sun)
        return;
    sun_shares_.assign(patch_count_, 0.0);
    constexpr std::uint32_t patches_at_a_time = 64;
    parallel_ranges(patch_count_, patches_at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t i = first; i < end; ++i) {
            const Patch side = patch(i);
            const double cosine = dot(side.shape.normal(), file_->sun->direction);
            if (!(cosine > 0.0) || is_sky(side.surface))
                continue;
            double share = sunlit_share(*this, side, 64);
            if (share > 0.0 && share < 1.0) // the edge of a shadow
                share = sunlit_share(*this, side, 256);
            sun_shares_[i] = cosine * share;
        }
    });
    sun_power_ = {};
    for (std::uint32_t i = 0; i < patch_count_; ++i)
        sun_power_ += area(i) * sunlight(i);
}

Rgb Scene::sunlight(std::uint32_t surface, Vec3 point, Vec3 normal) const
{
    const double cosine = file_->sun ? dot(normal, file_->sun->direction) : 0.0;
    const bool of_sky = surface != Intersector::no_surface && is_sky(surface);
    if (!(cosine > 0.0) || of_sky || count_sunlit(*this, surface, {point}) == 0)
        return {};
    return cosine * file_->sun->irradiance;
}

Bounds Scene::own_bounds() const
{
    return bounds_of(file_->without_sky());
}

Scene Scene::refined(const std::vector<std::uint8_t>& levels, int threads) const
{
    Scene result = *this;
    std::size_t first = 0; // leaf of the surface
    for (Tessellation& tessellation : result.tessellations_) {
        tessellation.trees = nullptr;
        const std::uint64_t cells = tessellation.cell_count();
        std::size_t end = first;
        // A leaf of level l covers 4^-l of a cell; the leaves of this surface are those that cover all its cells.
        double covered = 0.0;
        bool whole = true;
        for (; end < levels.size() && covered < static_cast<double>(cells); ++end) {
            covered += std::ldexp(1.0, -2 * levels[end]);
            whole = whole && levels[end] == 0;
        }
        if (!whole || end - first != cells)
            tessellation.trees = std::make_shared<const CellTrees>(tessellation, levels.data() + first, end - first);
        first = end;
    }
    if (first != levels.size())
        throw std::invalid_argument("levels of more patches than the scene has");
    result.number_cells();
    result.compute_textured_reflectances(threads);
    result.compute_sunlight(threads);
    return result;
}

std::vector<std::uint8_t> Scene::levels() const
{
    std::vector<std::uint8_t> result;
    bool whole = true;
    for (const Tessellation& tessellation : tessellations_) {
        whole = whole && !tessellation.trees;
        for (std::uint32_t cell = 0; cell < tessellation.cell_count(); ++cell)
            result.push_back(tessellation.level(cell));
    }
    return whole ? std::vector<std::uint8_t>() : result;
}

std::vector<double> Scene::areas() const
{
    return serial_list(patch_count_, [this](std::uint32_t i) { return area(i); });
}

std::vector<double> Scene::weights() const
{
    return serial_list(patch_count_, [this](std::uint32_t i) { return is_sky_patch(i) ? 0.0 : area(i); });
}

Patch Scene::patch(std::uint32_t patch) const
{
    const std::uint32_t cell = cell_of(patch);
    const std::uint32_t s = surface_of_[cell];
    const Surface shape = tessellations_[s].cell(file_->surfaces[s], cell - first_cell_[s]);
    return {s, is_front(patch) ? shape : turned_over(shape)};
}

} // namespace multipath
