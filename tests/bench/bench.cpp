// The benchmark of record: how many items, lines and rays per second of one thread's processor time, and how they
// compare. Figures of one run are comparable with each other, not with those of another machine or hour: every figure
// is the median over rounds in which all take their turn, every ratio the median of the rounds' ratios.
//
// usage: bench [GROUP...]     of sequences, mapping, crossings, solvers, patches, threads; without any, all

#include "bench_scenes.h"
#include "contest.h"
#include "embree_scene.h"
#include "geometry/intersector.h"
#include "radiosity/solve.h"
#include "sampling/sequence.h"
#include "sampling/warp_kernel.h"
#include "scene/obj_reader.h"
#include "transport/line_sampling.h"
#include "transport/local_ray.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

using namespace multipath;

namespace {

constexpr std::size_t block = 4096;
constexpr std::size_t line_count = 64 * block;

std::vector<Item> some_items(std::size_t count)
{
    std::vector<Item> items(count);
    make_sequence("sobol", 1)->generate(0, items);
    return items;
}

void compare_sequences()
{
    std::vector<Contestant> contestants;
    for (const std::string name : {"random", "sobol", "sobol-shift", "sobol-owen", "halton", "halton:11,13,17,19",
                                   "halton-permuted", "kronecker"})
        contestants.push_back({name, "4-D items", [name] {
                                   const auto sequence = make_sequence(name, 1);
                                   constexpr std::size_t blocks = 500;
                                   std::vector<Item> items(block);
                                   for (std::size_t k = 0; k < blocks; ++k) {
                                       sequence->generate(block * k, items);
                                       use(items[k % block][k % 4]);
                                   }
                                   return static_cast<double>(blocks * block);
                               }});
    compete("sequences", contestants);
}

void compare_maps(const Scene& scene)
{
    const std::vector<Item> items = some_items(block);
    std::vector<Contestant> contestants;
    constexpr int repeats = 100;
    for (const Chords chords : {Chords::sphere, Chords::box}) {
        const std::string from = chords == Chords::sphere ? " of the sphere" : " of the box";
        contestants.push_back({"one by one" + from, "lines", [=, &scene] {
                                   const GlobalLines lines(scene.bounds(), chords);
                                   for (int k = 0; k < repeats; ++k)
                                       for (const Item& item : items)
                                           use(lines.line(item).direction.x);
                                   return static_cast<double>(repeats * items.size());
                               }});
        contestants.push_back({"in blocks" + from, "lines",
                               [=, &scene] {
                                   const GlobalLines lines(scene.bounds(), chords);
                                   std::vector<Line> found(items.size());
                                   for (int k = 0; k < repeats; ++k) {
                                       lines.lines(items.data(), items.size(), found.data());
                                       use(found[static_cast<std::size_t>(k)].direction.x);
                                   }
                                   return static_cast<double>(repeats * items.size());
                               },
                               "one by one" + from});
    }
    for (const WarpKernel* kernel : available_warp_kernels())
        contestants.push_back({std::string("square to sphere, ") + kernel->name, "points", [=] {
                                   SquarePoints square{};
                                   WarpedPoints points{};
                                   for (std::size_t k = 0; k < warp_block; ++k) {
                                       square.a[k] = items[k][0];
                                       square.b[k] = items[k][1];
                                   }
                                   constexpr int calls = 4000;
                                   for (int k = 0; k < calls; ++k) {
                                       kernel->uniform_sphere(square, warp_block, points);
                                       square.a[k % 256] = 0.5 + 0.5 * points.z[k % 256];
                                   }
                                   use(points.x[0]);
                                   return static_cast<double>(calls * warp_block);
                               }});
    compete("mapping items to lines", contestants);
}

/// Surfaces for us, the same as triangles for Embree.
struct Rivals
{
    std::string name;
    std::vector<Surface> surfaces;
    std::vector<int> cuts; ///< n x n cells of every surface for Embree; 0: the surfaces are triangles
};

std::vector<Line> chords_through(const std::vector<Surface>& surfaces)
{
    Bounds box;
    for (const Surface& surface : surfaces)
        box.include(surface.bounds());
    std::vector<Line> lines(line_count);
    GlobalLines(box).lines(some_items(line_count).data(), line_count, lines.data());
    return lines;
}

/// Diffuse rays from all surfaces, in turns of 64.
std::vector<Line> rays_from(const std::vector<Surface>& surfaces, std::vector<std::uint32_t>& from)
{
    const std::vector<Item> items = some_items(line_count);
    std::vector<Line> rays;
    for (std::size_t k = 0; k < line_count; ++k) {
        from.push_back(static_cast<std::uint32_t>(k / 64 % surfaces.size()));
        rays.push_back(local_line({from.back(), surfaces[from.back()]}, items[k]));
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
        const std::vector<Surface> triangles = cut == 0 ? rivals.surfaces : as_triangles(rivals.surfaces, cut);
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

void compare_closest_hits(const Rivals& rivals)
{
    std::vector<std::uint32_t> from;
    const FreshLines fresh(rays_from(rivals.surfaces, from));
    std::vector<Contestant> contestants = embrees_of(rivals, "rays", fresh, &EmbreeScene::count_closest_hits);
    const std::size_t embrees = contestants.size();
    std::vector<std::unique_ptr<Intersector>> intersectors;
    const auto add = [&](const FilterKernel* kernel, const std::string& rival) {
        intersectors.push_back(std::make_unique<Intersector>(rivals.surfaces, *kernel));
        const Intersector& intersector = *intersectors.back();
        const auto found = std::make_shared<FirstHits>();
        contestants.push_back(
            {std::string(kernel->name) + ", in blocks" + (rival.empty() ? "" : " /" + rival.substr(8)), "rays",
             [&intersector, &fresh, &from, found] {
                 intersector.closest_hits_from(&from[fresh.first()], fresh.lines().data(), block, *found);
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
    compete("closest hit of diffuse rays: " + rivals.name, contestants);
}

void compare_crossings()
{
    std::vector<Rivals> all;
    all.push_back({"room of 37 rectangles", room_with_boxes(5), {1, 16, 164}});
    all.push_back({"room of 301 rectangles", room_with_boxes(49), {1}});
    all.push_back({"soup of 20,000 triangles", triangle_soup(20000, 0.05), {0}});
    all.push_back({"soup of 1,000,000 triangles", triangle_soup(1000000, 0.01), {0}});
    for (const Rivals& rivals : all) {
        compare_all_hits(rivals);
        compare_closest_hits(rivals);
    }
}

Contestant solver(const std::string& name, const Scene& scene, Method method, std::uint64_t lines, int threads = 1)
{
    return {name, "lines", [&scene, method, lines, threads] {
                SolveOptions options;
                options.method = method;
                options.lines = lines;
                options.threads = threads;
                use(solve(scene, options, [](double) {}).radiosity[0].r);
                return static_cast<double>(lines);
            }};
}

void compare_solvers()
{
    const Scene scene = scene_of(room_with_boxes(5), 1000);
    compete("whole solvers, RGB, 37 rectangles, " + std::to_string(scene.patch_count()) + " patches, 2^21 lines",
            {solver("global", scene, Method::global, 1u << 21),
             solver("first shot", scene, Method::first_shot, 1u << 21),
             solver("extended first shot", scene, Method::extended, 1u << 21),
             solver("local", scene, Method::local, 1u << 21), solver("line reuse", scene, Method::reuse, 1u << 21)});
}

void compare_patches()
{
    std::vector<std::unique_ptr<Scene>> scenes;
    std::vector<Contestant> contestants;
    for (const std::uint64_t patches : {1000, 10000, 100000, 1000000}) {
        scenes.push_back(std::make_unique<Scene>(scene_of(room_with_boxes(5), patches)));
        contestants.push_back(solver(std::to_string(scenes.back()->patch_count()) + " patches", *scenes.back(),
                                     Method::global, 1u << 22));
    }
    for (std::size_t k = 1; k < contestants.size(); ++k)
        contestants[k].rival = contestants[0].name;
    compete("global pass over the number of patches", contestants);
}

/// Here the clock on the wall counts, and the two take turns.
void compare_threads()
{
    std::printf("\nspeed-up by a second thread (by the clock, median of 7)\n");
    const Scene scene = scene_of(room_with_boxes(5), 3000);
    const std::vector<std::pair<const char*, Method>> methods = {{"global", Method::global},
                                                                 {"first shot", Method::first_shot},
                                                                 {"extended first shot", Method::extended},
                                                                 {"local", Method::local},
                                                                 {"line reuse", Method::reuse}};
    for (const auto& [name, method] : methods) {
        std::vector<double> ratios;
        for (int round = 0; round < 7; ++round) {
            double seconds[2];
            for (const int threads : {1, 2}) {
                const auto start = std::chrono::steady_clock::now();
                solver(name, scene, method, 1u << 22, threads).run();
                seconds[threads - 1] = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            }
            ratios.push_back(seconds[0] / seconds[1]);
        }
        std::sort(ratios.begin(), ratios.end());
        std::printf("  %-44s %8.2f  (%.2f ... %.2f)\n", name, ratios[3], ratios.front(), ratios.back());
    }
}

} // namespace

int main(int argc, char** argv)
{
    const std::vector<std::string> wanted(argv + 1, argv + argc);
    const auto runs = [&](const char* group) {
        return wanted.empty() || std::find(wanted.begin(), wanted.end(), group) != wanted.end();
    };
    std::printf("processor time of one thread; median of 7 interleaved rounds (slowest ... fastest)\n");
    if (!EmbreeScene::available())
        std::printf("Embree was not found when this was built: no comparison with it\n");
    if (runs("sequences"))
        compare_sequences();
    if (runs("mapping"))
        compare_maps(scene_of(room_with_boxes(5), 1000));
    if (runs("crossings"))
        compare_crossings();
    if (runs("solvers"))
        compare_solvers();
    if (runs("patches"))
        compare_patches();
    if (runs("threads"))
        compare_threads();
    return 0;
}
