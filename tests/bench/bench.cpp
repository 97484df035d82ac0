// The benchmark of record: how many items, lines and rays per second of one thread's processor time, and how they
// compare. Figures of one run are comparable with each other, not with those of another machine or hour: every figure
// is the median over rounds in which all take their turn, every ratio the median of the rounds' ratios.
//
// usage: bench [GROUP...]     of sequences, mapping, crossings, solvers, patches, threads; without any, all

#include "bench_items.h"
#include "bench_scenes.h"
#include "contest.h"
#include "crossings.h"
#include "embree_scene.h"
#include "radiosity/run/solve.h"
#include "sampling/sequence.h"
#include "sampling/warp_kernel.h"
#include "transport/lines/global_lines.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <thread>

using namespace multipath;

namespace {

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
                                   std::vector<Item> square(items.begin(), items.begin() + warp_block);
                                   WarpedPoints points;
                                   constexpr int calls = 4000;
                                   for (int k = 0; k < calls; ++k) {
                                       kernel->uniform_sphere(square.data(), warp_block, 0, points);
                                       square[k % 256][0] = 0.5 + 0.5 * points[k % 256].z;
                                   }
                                   use(points[0].x);
                                   return static_cast<double>(calls * warp_block);
                               }});
    compete("mapping items to lines", contestants);
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

void compare_patches(Method method, const std::string& name)
{
    std::vector<std::unique_ptr<Scene>> scenes;
    std::vector<Contestant> contestants;
    for (const std::uint64_t patches : {1000u, 10000u, 100000u, 1000000u}) {
        scenes.push_back(std::make_unique<Scene>(scene_of(room_with_boxes(5), patches)));
        contestants.push_back(
            solver(std::to_string(scenes.back()->patch_count()) + " patches", *scenes.back(), method, 1u << 22));
    }
    for (std::size_t k = 1; k < contestants.size(); ++k)
        contestants[k].rival = contestants[0].name;
    compete(name + " over the number of patches", contestants);
}

/// What the clock on the wall says.
template <class Work>
double seconds_of(const Work& work)
{
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void print_ratio(std::vector<double> ratios)
{
    std::sort(ratios.begin(), ratios.end());
    std::printf("  %6.2f  (%.2f ... %.2f)", ratios[ratios.size() / 2], ratios.front(), ratios.back());
}

/// One thread, two threads, and two runs of one thread at once take turns: the last tells what the machine gives.
void compare_threads()
{
    constexpr int rounds = 11;
    std::printf("\nspeed-up by a second thread (by the clock, median of %d), and what two runs at once gain\n", rounds);
    const Scene scene = scene_of(room_with_boxes(5), 3000);
    const std::vector<std::pair<const char*, Method>> methods = {{"global", Method::global},
                                                                 {"first shot", Method::first_shot},
                                                                 {"extended first shot", Method::extended},
                                                                 {"local", Method::local},
                                                                 {"line reuse", Method::reuse}};
    for (const auto& [name, method] : methods) {
        std::vector<double> two_threads;
        std::vector<double> two_runs;
        const Contestant alone = solver(name, scene, method, 1u << 22, 1);
        const Contestant shared = solver(name, scene, method, 1u << 22, 2);
        for (int round = 0; round < rounds; ++round) {
            const double one = seconds_of(alone.run);
            two_threads.push_back(one / seconds_of(shared.run));
            two_runs.push_back(2.0 * one / seconds_of([&] {
                                   std::thread other(alone.run);
                                   alone.run();
                                   other.join();
                               }));
        }
        std::printf("  %-28s", name);
        print_ratio(two_threads);
        print_ratio(two_runs);
        std::printf("\n");
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
    if (runs("rooms"))
        compare_rooms();
    if (runs("soups"))
        compare_soups();
    for (const std::string& name : wanted)
        if (name.size() > 4 && name.compare(name.size() - 4, 4, ".obj") == 0)
            compare_file(name);
    if (runs("solvers"))
        compare_solvers();
    if (runs("patches")) {
        compare_patches(Method::global, "global pass");
        compare_patches(Method::first_shot, "first shot and global pass");
    }
    if (runs("threads"))
        compare_threads();
    return 0;
}
