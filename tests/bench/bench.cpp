// The benchmark of record: how many items, lines and rays per second of one thread's CPU time. Figures of one run are
// comparable with each other, not with those of another machine or hour: every figure is the median over rounds in
// which all take their turn.

#include "geometry/intersector.h"
#include "radiosity/shooting.h"
#include "radiosity/solve.h"
#include "sampling/sequence.h"
#include "scene/obj_reader.h"
#include "transport/line_sampling.h"
#include "transport/local_ray.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

using namespace multipath;

namespace {

constexpr int rounds = 7;
constexpr std::size_t block = 4096;

double cpu_seconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// One row of the table: runs some work and returns how many pieces it did.
struct Contestant
{
    std::string name;
    std::string unit;
    std::function<double()> run;
    std::vector<double> per_second = {};
};

void measure(std::vector<Contestant>& contestants)
{
    for (int round = 0; round < rounds; ++round)
        for (Contestant& contestant : contestants) {
            const double start = cpu_seconds();
            const double pieces = contestant.run();
            contestant.per_second.push_back(pieces / (cpu_seconds() - start));
        }
    for (Contestant& contestant : contestants) {
        std::sort(contestant.per_second.begin(), contestant.per_second.end());
        std::printf("%-36s %9.2f  (%.2f ... %.2f) million %s/s\n", contestant.name.c_str(),
                    1e-6 * contestant.per_second[rounds / 2], 1e-6 * contestant.per_second.front(),
                    1e-6 * contestant.per_second.back(), contestant.unit.c_str());
    }
}

double sink = 0.0; ///< what is computed goes here, so that it must be computed

std::vector<Contestant> sequences()
{
    std::vector<Contestant> result;
    for (const char* name : {"random", "sobol", "sobol-shift", "sobol-owen", "halton", "halton:11,13,17,19",
                             "halton-permuted", "kronecker"})
        result.push_back({std::string("sequence ") + name, "4-D items", [name] {
                              const auto sequence = make_sequence(name, 1);
                              constexpr std::size_t blocks = 1000;
                              std::vector<Item> items(block);
                              for (std::size_t k = 0; k < blocks; ++k) {
                                  sequence->generate(block * k, items);
                                  sink += items[k % block][k % 4];
                              }
                              return static_cast<double>(blocks * block);
                          }});
    return result;
}

std::vector<Contestant> lines(const Scene& scene)
{
    const GlobalLines global_lines(scene.bounds());
    const auto items = [] {
        std::vector<Item> list(100 * block);
        make_sequence("sobol", 1)->generate(0, list);
        return list;
    };
    return {{"mapping items to chords", "lines",
             [=] {
                 static_cast<void>(scene);
                 const std::vector<Item> list = items();
                 for (const Item& item : list)
                     sink += global_lines.line(item).direction.x;
                 return static_cast<double>(list.size());
             }},
            {"all hits along chords", "lines",
             [=, &scene] {
                 std::vector<Hit> hits;
                 const std::vector<Item> list = items();
                 for (const Item& item : list) {
                     scene.intersector().all_hits(global_lines.line(item), hits);
                     sink += static_cast<double>(hits.size());
                 }
                 return static_cast<double>(list.size());
             }},
            {"closest hit of diffuse rays", "rays", [=, &scene] {
                 const std::vector<Item> list = items();
                 const Patch patch = scene.patch(0);
                 for (const Item& item : list)
                     sink += receiver(scene, patch.surface, local_line(patch, item));
                 return static_cast<double>(list.size());
             }}};
}

std::vector<Contestant> solvers(const Scene& scene)
{
    std::vector<Contestant> result;
    for (const Method method : {Method::global, Method::first_shot})
        result.push_back(
            {method == Method::global ? "solve, global" : "solve, first shot at ratio 1", "lines", [&scene, method] {
                 SolveOptions options;
                 options.method = method;
                 options.ratio = 1.0;
                 options.lines = 1u << 19;
                 sink += solve(scene, options, [](double) {}).radiosity[0].r;
                 return static_cast<double>(options.lines);
             }});
    return result;
}

} // namespace

int main()
{
    std::printf("one thread, CPU time, median of %d interleaved rounds (slowest ... fastest)\n", rounds);
    const Scene scene(read_obj("scenes/5cubes.obj"), 0.15);
    std::printf("scene: 5CUBES, %zu surfaces, %u patches; global lines counted as cast or, in solve, as charged\n",
                scene.surfaces().size(), scene.patch_count());
    for (std::vector<Contestant> group : {sequences(), lines(scene), solvers(scene)})
        measure(group);
    return sink == 0.5 ? 1 : 0;
}
