#include "crossings.h"

#include "bench_items.h"
#include "bench_scenes.h"
#include "contest.h"
#include "embree_scene.h"
#include "geometry/intersector/intersector.h"
#include "geometry/intersector/kernel.h"
#include "geometry/intersector/surface_sizes.h"
#include "sampling/random.h"
#include "sampling/warp.h"
#include "scene/obj/obj_reader.h"
#include "transport/lines/global_lines.h"
#include "transport/lines/local_rays.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

namespace multipath {

namespace {

constexpr std::size_t line_count = 64 * block;

/// Surfaces for us, the same as triangles for Embree.
struct Rivals
{
    std::string name;
    SurfaceList surfaces;
    std::vector<int> cuts; ///< n x n cells of every surface for Embree; 0: the surfaces are triangles
};

std::vector<Line> chords_through(const SurfaceList& surfaces)
{
    const Bounds box = bounds_of(surfaces);
    std::vector<Line> lines(line_count);
    GlobalLines(box).lines(some_items(line_count).data(), line_count, lines.data());
    return lines;
}

/// Diffuse rays from all surfaces, in turns of 64.
std::vector<Line> rays_from(const SurfaceList& surfaces, std::vector<std::uint32_t>& from)
{
    const std::vector<Item> items = some_items(line_count);
    std::vector<Line> rays;
    for (std::size_t k = 0; k < line_count; ++k) {
        from.push_back(static_cast<std::uint32_t>(k / 64 % surfaces.size()));
        rays.push_back(local_line({from.back(), surfaces[from.back()]}, items[k]));
    }
    return rays;
}

/// Rays between points that are uniform on all surfaces and face each other, 64 in turn from one surface: as far as the
/// parameter 1.
std::vector<Line> shadow_rays_among(const SurfaceList& surfaces, std::vector<std::uint32_t>& from,
                                    std::vector<std::uint32_t>& targets)
{
    std::vector<double> areas;
    for (const Surface& surface : surfaces)
        areas.push_back(surface.area() + (areas.empty() ? 0.0 : areas.back()));
    const auto some_surface = [&](std::uint64_t seed, std::uint64_t number) {
        const double area = bits_to_unit(random_bits(seed, number)) * areas.back();
        return static_cast<std::uint32_t>(std::lower_bound(areas.begin(), areas.end() - 1, area) - areas.begin());
    };
    const std::vector<Item> items = some_items(line_count);
    constexpr std::uint64_t most_tries = 64 * 64; // from one surface
    std::vector<Line> rays;
    std::uint64_t tries = 0;
    for (std::uint64_t group = 0; rays.size() < line_count; ++group)
        for (std::uint64_t t = 0; t < most_tries && rays.size() < line_count; ++t, ++tries) {
            const std::uint32_t start = some_surface(1, group);
            const std::uint32_t target = some_surface(2, tries);
            const Item& item = items[rays.size()];
            const Vec3 origin = square_to_uniform_surface(surfaces[start], item[0], item[1]);
            const Vec3 way = square_to_uniform_surface(surfaces[target], item[2], item[3]) - origin;
            const double grazing = 0.001 * length(way);
            if (dot(way, surfaces[start].normal()) > grazing && -dot(way, surfaces[target].normal()) > grazing) {
                from.push_back(start);
                targets.push_back(target);
                rays.push_back({origin, way});
                if (rays.size() % 64 == 0)
                    break;
            }
        }
    return rays;
}

/// Lines block by block, each in the same memory: as the solvers have them, whose lines have just been made.
class FreshLines
{
public:
    explicit FreshLines(std::vector<Line> lines) : all_(std::move(lines)), block_(block) {}

    /// One run for each block.
    void feed(Contestant& contestant) const
    {
        contestant.parts = all_.size() / block;
        contestant.prepare = [this](std::size_t part) {
            number_ = part;
            std::copy_n(all_.begin() + static_cast<std::ptrdiff_t>(block * part), block, block_.begin());
        };
    }
    const std::vector<Line>& lines() const { return block_; }
    std::size_t first() const { return block * number_; } ///< number of the first of them

private:
    std::vector<Line> all_;
    mutable std::vector<Line> block_;
    mutable std::size_t number_ = 0;
};

/// Embree on each mesh of the rivals; none where it is not at hand.
std::vector<Contestant> embrees_of(const Rivals& rivals, const std::string& unit, const FreshLines& fresh,
                                   double (EmbreeScene::*count)(const std::vector<Line>&) const)
{
    std::vector<Contestant> contestants;
    if (!EmbreeScene::available())
        return contestants;
    for (const int cut : rivals.cuts) {
        const SurfaceList triangles = cut == 0 ? rivals.surfaces : as_triangles(rivals.surfaces, cut);
        const auto mesh = std::make_shared<const EmbreeScene>(triangles);
        contestants.push_back({EmbreeScene::version() + ", " + std::to_string(triangles.size()) + " triangles", unit,
                               [mesh, &fresh, count] {
                                   use((*mesh.*count)(fresh.lines()));
                                   return static_cast<double>(block);
                               }});
    }
    return contestants;
}

/// Best kernel against each Embree, then all kernels against the first one.
void compare_all_hits(const Rivals& rivals)
{
    const FreshLines fresh(chords_through(rivals.surfaces));
    std::vector<Contestant> contestants = embrees_of(rivals, "lines", fresh, &EmbreeScene::count_all_hits);
    const std::size_t embrees = contestants.size();
    std::vector<std::unique_ptr<Intersector>> intersectors;
    const auto add = [&](const FilterKernel* kernel, bool in_blocks, const std::string& rival) {
        intersectors.push_back(std::make_unique<Intersector>(rivals.surfaces, *kernel));
        const Intersector& intersector = *intersectors.back();
        const auto lists = std::make_shared<HitLists>();
        const auto run_block = [&intersector, &fresh, lists] {
            intersector.all_hits(fresh.lines().data(), block, *lists);
            use(static_cast<double>(lists->hit_count()));
            return static_cast<double>(block);
        };
        const auto run_one_by_one = [&intersector, &fresh] {
            std::vector<Hit> hits;
            for (const Line& line : fresh.lines()) {
                intersector.all_hits(line, hits);
                use(static_cast<double>(hits.size()));
            }
            return static_cast<double>(block);
        };
        contestants.push_back(
            {std::string(kernel->name) + (in_blocks ? ", in blocks" : ", line by line") +
                 (rival.empty() ? "" : " /" + rival.substr(8)),
             "lines", in_blocks ? std::function<double()>(run_block) : std::function<double()>(run_one_by_one), rival});
    };
    const std::vector<const FilterKernel*> kernels = available_kernels();
    for (std::size_t e = 0; e < embrees; ++e)
        add(kernels.front(), true, contestants[e].name);
    for (const FilterKernel* kernel : kernels) {
        if (kernel != kernels.front() || embrees == 0)
            add(kernel, true, embrees > 0 ? contestants[0].name : "");
        if (kernel == kernels.front())
            add(kernel, false, embrees > 0 ? contestants[0].name : "");
    }
    for (Contestant& contestant : contestants)
        fresh.feed(contestant);
    compete("all hits along chords: " + rivals.name, contestants);
}

/// The rays of `fresh` by closest_hits_from, or by hits_on_targets if there are targets.
void compare_first_hits(const std::string& title, const Rivals& rivals, const FreshLines& fresh,
                        const std::vector<std::uint32_t>& from, const std::vector<std::uint32_t>& targets)
{
    std::vector<Contestant> contestants = embrees_of(
        rivals, "rays", fresh, targets.empty() ? &EmbreeScene::count_closest_hits : &EmbreeScene::count_occluded);
    const std::size_t embrees = contestants.size();
    std::vector<std::unique_ptr<Intersector>> intersectors;
    const auto add = [&](const FilterKernel* kernel, const std::string& rival) {
        intersectors.push_back(std::make_unique<Intersector>(rivals.surfaces, *kernel));
        const Intersector& intersector = *intersectors.back();
        const auto found = std::make_shared<FirstHits>();
        contestants.push_back(
            {std::string(kernel->name) + ", in blocks" + (rival.empty() ? "" : " /" + rival.substr(8)), "rays",
             [&, found] {
                 const std::size_t first = fresh.first();
                 if (targets.empty())
                     intersector.closest_hits_from(&from[first], fresh.lines().data(), block, *found);
                 else
                     intersector.hits_on_targets(&from[first], &targets[first], fresh.lines().data(), block, *found);
                 use(found->is_hit(0) ? 1.0 : 0.0);
                 return static_cast<double>(block);
             },
             rival});
    };
    const std::vector<const FilterKernel*> kernels = available_kernels();
    for (std::size_t e = 0; e < embrees; ++e)
        add(kernels.front(), contestants[e].name);
    for (const FilterKernel* kernel : kernels)
        if (kernel != kernels.front() || embrees == 0)
            add(kernel, embrees > 0 ? contestants[0].name : "");
    if (targets.empty())
        contestants.push_back(
            {"one by one", "rays",
             [&] {
                 for (std::size_t k = 0; k < block; ++k)
                     use(intersectors[0]->closest_hit_from(from[fresh.first() + k], fresh.lines()[k]) ? 1.0 : 0.0);
                 return static_cast<double>(block);
             },
             embrees > 0 ? contestants[0].name : ""});
    for (Contestant& contestant : contestants)
        fresh.feed(contestant);
    compete(title + rivals.name, contestants);
}

void compare_closest_hits(const Rivals& rivals)
{
    std::vector<std::uint32_t> from;
    const FreshLines fresh(rays_from(rivals.surfaces, from));
    compare_first_hits("closest hit of diffuse rays: ", rivals, fresh, from, {});
}

void compare_shadow_rays(const Rivals& rivals)
{
    std::vector<std::uint32_t> from;
    std::vector<std::uint32_t> targets;
    const FreshLines fresh(shadow_rays_among(rivals.surfaces, from, targets));
    compare_first_hits("shadow rays: ", rivals, fresh, from, targets);
}

} // namespace

namespace {

void compare(const Rivals& rivals)
{
    compare_all_hits(rivals);
    compare_closest_hits(rivals);
    compare_shadow_rays(rivals);
}

} // namespace

void compare_rooms()
{
    compare({"room of 37 rectangles", room_with_boxes(5), {1, 16, 164}});
    compare({"room of 301 rectangles", room_with_boxes(49), {1}});
}

void compare_soups()
{
    compare({"soup of 20,000 triangles", triangle_soup(20000, 0.05), {0}});
    compare({"soup of 1,000,000 triangles", triangle_soup(1000000, 0.01), {0}});
}

void compare_file(const std::string& path)
{
    ObjChanges changes;
    changes.lit_from_outside = true; // lamps do not matter here
    const SurfaceList surfaces = read_obj(path, changes).surfaces;
    compare({path + ", " + std::to_string(surfaces.size()) + " surfaces", surfaces, {1}});
}

} // namespace multipath
