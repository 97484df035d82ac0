// Each method is a row of the table at the end of this file: a name, its options, its stages, and a function that
// prepares them. The stages, at the beginning, adapt the algorithms of the other files to a Run: they pass the options
// on, divide the lines and the items of the sequence, and record how many lines were cast.

#include "radiosity/run/methods.h"

#include "base/errors.h"
#include "base/lists.h"
#include "geometry/intersector/intersector.h"
#include "radiosity/family/gathering_walk.h"
#include "radiosity/family/stochastic_jacobi.h"
#include "radiosity/family/transillumination.h"
#include "radiosity/paper/first_shot.h"
#include "radiosity/paper/local_monte_carlo.h"
#include "radiosity/paper/multipath.h"
#include "radiosity/reuse/balanced_reuse.h"
#include "radiosity/reuse/gathered_light.h"
#include "radiosity/reuse/line_reuse.h"
#include "radiosity/run/memory_estimate.h"
#include "radiosity/run/run.h"
#include "scene/text/text_words.h"
#include "transport/exchange/unoccluded_exchange.h"
#include "transport/lines/depth_complexity.h"

#include <algorithm>
#include <functional>
#include <future>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

namespace multipath {

namespace {

// Stages

void shots(Run& run)
{
    shoot_first(run);
}

void global_pass(Run& run)
{
    run.plan_global_lines();
    const GlobalPass pass{run.next_item(), run.solution.global_lines_cast, run.options.bidirectional};
    const ShuffledOrder items = walking_order(*run.sequence, run.options.line_order, pass.first_item, pass.lines_cast);
    run.note_cast(cast_global_lines(run.scene, run.lines, items, pass,
                                    run.control(pass.lines_cast, run.solution.global_lines), run.state)); // (M1) (M2)
}

bool gathers(const Run& run)
{
    return run.options.direct == Direct::gather;
}

bool are_few(const Run& run)
{
    return run.lines_left() <
           (run.preparation.unoccluded.valid() ? min_table_lines(run.scene) : min_balanced_rays(run.scene));
}

/// Line reuse with a table of all pairs. With Direct::gather, a part of the lines become rays between pairs.
void reuse_pairs(Run& run)
{
    const std::uint64_t rays = gathers(run) ? std::min(run.local_share(1.0), run.options.lines - 1) : 0;
    const std::uint64_t first_ray = run.next_item();
    run.solution.local_lines += rays;
    run.plan_global_lines();
    const ReusedLines plan{run.next_item(), run.solution.global_lines_cast, {first_ray, rays, run.options.seed}};
    run.note_cast(reuse_lines(run.scene, run.preparation.unoccluded, run.lines, *run.sequence, plan,
                              run.control(plan.cast + rays, run.solution.global_lines + rays, run.shard),
                              run.state)); // (R1)
}

/// Lets the sky light the patches along rays of theirs, half of all, if the particles are to carry its light further:
/// of those that leave the sky themselves, most would meet nothing else. After shots the light has left the sky.
void rays_to_sky(Run& run)
{
    if (run.scene.file().sky_surfaces == 0 || !gathers(run) || !are_few(run))
        return;
    const std::uint64_t rays = run.lines_left() / 2;
    const SceneLights lights(run.scene, run.options.threads);
    const GatheredSkylight found =
        gathered_skylight(run.scene, lights.patches.get(), *run.sequence, run.next_item(), rays, run.control(1, 1));
    if (run.stopped())
        return;
    run.solution.local_lines += rays;
    PowerState& state = run.state;
    for (std::uint32_t i = 0; i < run.scene.patch_count(); ++i) {
        if (run.scene.is_sky_patch(i)) { // the rest of its light reaches the sky again
            state.escaped += state.unshot[i];
            state.unshot[i] = {};
            continue;
        }
        const Rgb sent_on = run.scene.reflectance(i) * found.by_own_rays[i];
        const Rgb absorbed = found.incident[i] - run.scene.reflectance(i) * found.incident[i];
        state.incident[i] += found.incident[i];
        state.unshot[i] += sent_on;
        state.escaped = state.escaped - absorbed - sent_on;
    }
}

/// Line reuse without a table of all pairs.
void reuse_rays(Run& run)
{
    const BalancedRays rays{run.next_item(), run.lines_left(), gathers(run), true, run.options.importance.get()};
    BalancedResult result = reuse_balanced(run.scene, *run.preparation.lights, *run.sequence, rays, run.options.memory,
                                           run.control(1, 1, run.shard),
                                           run.state); // (R1) (R4) (R5)
    run.solution.local_lines += result.rays;
    run.solved = result.solved;
    run.variance = std::move(result.variance);
}

/// Line reuse, or particles if there are too few lines per patch for it.
void reuse(Run& run)
{
    const bool few = are_few(run);
    if (few && run.shard.of > 1)
        throw SettingsError(run.scene.path() + ": so few lines per patch are not reused, and cannot be shared; "
                                               "expected more lines, or no shards");
    (few ? cast_particles : run.preparation.unoccluded.valid() ? reuse_pairs : reuse_rays)(run);
}

// Preparation

void prepare_ratio(const Scene& scene, const SolveOptions& options, Preparation& preparation)
{
    if (!options.power_by_line)
        preparation.ratio = ratio_for(scene, options);
}

/// True if a table of all pairs is worth its time. Its error is much smaller than that of rays alone, even when these
/// are denoised. Its time grows with its bytes; error times time is equal at about 180 bytes per line, nine pairs of
/// patches of large surfaces or 1.7 pairs of surfaces. It also needs several lines for each pair of a patch and an
/// emitter, unless there are few such pairs. Measured on rooms of several kinds, and on a floor in the penumbra of one
/// large lamp (docs/line_reuse.md).
bool table_pays(const Scene& scene, std::uint64_t lines)
{
    constexpr double bytes_per_line = 180.0;
    constexpr double lines_per_light_pair = 4.0;
    constexpr double few_light_pairs = 1e5;
    const auto n = static_cast<double>(scene.patch_count());
    double emitters = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        emitters += mean(scene.first_light(i)) > 0.0 ? 1.0 : 0.0;
    const auto budget = static_cast<double>(lines);
    // The table requires equal patches on each surface, and is less exact for a sky than rays of the patches.
    if (!scene.levels().empty() || scene.file().sky_surfaces > 0)
        return false;
    return reuse_bytes(scene) <= bytes_per_line * budget &&
           emitters * n <= std::max(few_light_pairs, budget / lines_per_light_pair);
}

/// True if 16 other faces or more lie on the average of up to 64 patches.
bool faces_are_piled_up(const Scene& scene)
{
    constexpr std::uint32_t trials = 64;
    std::size_t faces = 0;
    for (std::uint64_t k = 0; k < trials; ++k) {
        const auto i = static_cast<std::uint32_t>(k * scene.patch_count() / trials);
        faces += scene.intersector().coincident_surfaces(scene.surface_of(i), scene.patch(i).shape.centre()).size();
    }
    return faces >= std::uint64_t{16} * trials;
}

/// Makes a table of all pairs where it pays and fits into memory; otherwise prepares the lights. There is no table
/// either if counting all pairs along the lines, or testing the pairs of many coincident faces for contact, would
/// dominate the time.
void prepare_pairs(const Scene& scene, const SolveOptions& options, Preparation& preparation)
{
    if (options.all_pairs && !options.importance && table_pays(scene, options.lines) &&
        reuse_bytes(scene) <= bytes_for_pairs(options.memory, scene) && !faces_are_piled_up(scene) &&
        pairs_along_line(scene, GlobalLines(scene.bounds(), chords_of(options))) <= many_pairs_along_line)
        preparation.unoccluded =
            std::async(std::launch::deferred, unoccluded_exchange, std::cref(scene), options.threads);
    else
        preparation.lights = std::make_shared<const SceneLights>(scene, options.threads);
}

/// Pairs of the table that no line has met are taken as free or hidden like those around them, so replicates with few
/// lines all have the same error.
std::uint64_t lines_to_trust_reuse(const Scene& scene)
{
    constexpr std::uint64_t with_table = 64;
    constexpr std::uint64_t without = 32;
    return table_pays(scene, with_table * scene.patch_count()) ? with_table : without;
}

// The table

constexpr Stages shots_and_walk = {shots, global_pass};

constexpr MethodInfo method_table[] = {
    {"local",
     "Particles from patch to patch, absorbed or reflected where they arrive; no global lines. To compare with.",
     "estimator", Stages{cast_particles}, "local"},
    {"global",
     "Multi-path alone: the sources, too, send their power along global lines. Every pair of patches that a "
     "line joins exchanges power.",
     "bidirectional line-order line-orders chords", shots_and_walk, "global"},
    {"first-shot", "Rays from the sources distribute the direct light; global lines the rest.",
     "ratio power-per-line threshold steps bidirectional line-order line-orders chords", shots_and_walk,
     "first-shot global", prepare_ratio, FirstShot::plain},
    {"extended",
     "Rays also from what the sources light, pass by pass, until the unshot power is spread evenly; then global "
     "lines. For lamps that light little of the room directly.",
     "ratio power-per-line threshold steps bidirectional line-order line-orders chords", shots_and_walk,
     "first-shot extended:PASS global", prepare_ratio, FirstShot::extended},
    {"reuse",
     "Lines are only counted: which patches they join, and what is in their way. A linear system then gives the light. "
     "Goes beyond the paper; the most accurate, and what solve does by default.",
     "ratio chords direct denoise important power-per-line:direct=shoot threshold:direct=shoot steps:direct=shoot",
     Stages{shots, rays_to_sky, reuse}, "", prepare_pairs, FirstShot::extended, Chords::box, Shards::added,
     lines_to_trust_reuse, "extended"},
    {"jacobi",
     "Stochastic Jacobi iterations: rays from all patches in proportion to the power that they send, the mean of the "
     "iterations. To compare with.",
     "bidirectional", Stages{ray_series, ray_iterations}, "iteration"},
    {"transillumination",
     "Rays from the sources distribute the direct light; parallel lines through the whole scene the rest, all patches "
     "exchanging power along each direction. To compare with.",
     "ratio power-per-line threshold bundle", Stages{shots, bundle_iterations}, "first-shot bundle", prepare_ratio,
     FirstShot::plain},
    {"gathering", "Random walks from the patches back to the sources. To compare with.", "estimator",
     Stages{gather_by_walks}, "gathering"}};

std::vector<std::string_view> words_of(std::string_view text)
{
    std::vector<std::string_view> words;
    for (std::string_view word = next_word(text); !word.empty(); word = next_word(text))
        words.push_back(word);
    return words;
}

} // namespace

const Method Method::local(&method_table[0]);
const Method Method::global(&method_table[1]);
const Method Method::first_shot(&method_table[2]);
const Method Method::extended(&method_table[3]);
const Method Method::reuse(&method_table[4]);
const Method Method::jacobi(&method_table[5]);
const Method Method::transillumination(&method_table[6]);
const Method Method::gathering(&method_table[7]);

std::vector<Method> all_methods()
{
    return mapped(method_table, [](const MethodInfo& info) { return Method(&info); });
}

Method method_named(std::string_view name)
{
    const MethodInfo* const found = std::find_if(std::begin(method_table), std::end(method_table),
                                                 [&](const MethodInfo& info) { return info.name == name; });
    if (found == std::end(method_table))
        throw std::invalid_argument("no method is called '" + std::string(name) + "'");
    return Method(found);
}

std::vector<MethodOption> options_of(Method method)
{
    return mapped(words_of(method->options), [](std::string_view word) {
        const std::size_t end = std::min(word.find(':'), word.size());
        return MethodOption{word.substr(0, end), word.substr(std::min(end + 1, word.size()))};
    });
}

bool has_option(Method method, std::string_view name)
{
    const std::vector<MethodOption> options = options_of(method);
    return std::any_of(options.begin(), options.end(),
                       [&](const MethodOption& option) { return option.name == name && option.with.empty(); });
}

std::vector<std::string_view> traced_stages(Method method)
{
    return words_of(method->traced);
}

} // namespace multipath
