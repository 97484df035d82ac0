#include "refinement/adaptive_patches.h"

#include "base/elementary.h"
#include "image/shading/smooth_shading.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace multipath {

namespace {

/// Estimated error [m^2 (W/m^2)^2] of every cell of all surfaces, the sum over its sides; 0 if it is negligible. The
/// error of a patch is its area times its interpolation error: how far its linear function is from the values
/// shown at its corners, plus a term for the curvature. If the patch is the only cell of its surface, that error is a
/// fixed fraction of its squared reflected radiosity.
std::vector<double> errors(const Scene& scene, const std::vector<Rgb>& radiosity, int threads)
{
    // The slope of a patch without neighbours is unknown; its mean square variation is taken as this fraction of its
    // square.
    constexpr double unknown = 0.03;
    const std::vector<Rgb> plain = without_texture(scene, radiosity); // pictures show textures at full resolution
    const std::vector<double> shown_errors = interpolation_errors(scene, plain, threads);
    std::vector<double> result(scene.two_sided() ? scene.patch_count() / 2 : scene.patch_count());
    double all = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const bool alone = scene.tessellation(scene.surface_of(i)).cell_count() == 1;
        const Rgb reflected = plain[i] - scene.emittance(i);
        const double square = alone ? unknown * mean(reflected * reflected) : shown_errors[i];
        result[i % result.size()] += scene.area(i) * square;
        all += scene.area(i) * mean(radiosity[i] * radiosity[i]);
    }
    constexpr double negligible =
        1e-12; // fraction of the squared radiosity of all patches; larger than rounding errors
    for (double& error : result)
        error = error > negligible * all ? error : 0.0;
    return result;
}

/// Splits the cells with the largest errors into four, up to about `wanted` patches, and adds none beyond that.
Scene cut(const Scene& scene, const std::vector<double>& error, std::uint64_t wanted, int threads)
{
    const auto cells = static_cast<std::uint32_t>(error.size());
    std::vector<std::uint8_t> level = scene.levels();
    level.resize(cells); // none are given if no cell is divided
    std::vector<std::uint32_t> order(cells);
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return error[a] != error[b] ? error[a] > error[b] : a < b; });
    std::vector<std::uint8_t> parts(cells, 1);
    const std::uint64_t more = (scene.two_sided() ? 6 : 3);
    std::uint64_t count = scene.patch_count();
    for (const std::uint32_t i : order) {
        if (count + more > wanted || !(error[i] > 0.0))
            break;
        const std::uint32_t surface = scene.surface_of(i);
        const Tessellation whole = scene.tessellation(surface).uniform(0);
        if (level[i] == CellTrees::deepest || !CellTrees::fit(whole, static_cast<std::uint8_t>(level[i] + 1)))
            continue;
        parts[i] = 4;
        count += more;
    }
    std::vector<std::uint8_t> levels;
    for (std::uint32_t i = 0; i < cells; ++i)
        levels.insert(levels.end(), parts[i], static_cast<std::uint8_t>(level[i] + (parts[i] == 4 ? 1 : 0)));
    return scene.refined(levels, threads);
}

} // namespace

Scene adaptively_refined(const Scene& coarse, std::uint64_t most, double memory, int threads,
                         const ProgressCallback& progress)
{
    // A round splits a patch at most once. If few patches are added, fewer rounds suffice.
    constexpr int most_rounds = 4;
    constexpr std::uint64_t usual_lines = 32; // per patch
    constexpr std::uint64_t fewest_lines = 8; // for very many patches: as good if each is split only once
    constexpr std::uint64_t many_lines = 1u << 20;
    const double growth = static_cast<double>(most) / coarse.patch_count();
    const int rounds =
        std::clamp(static_cast<int>(std::ceil(2.5 * elementary::log(growth) / elementary::log(2.0))), 0, most_rounds);
    Scene scene = coarse;
    for (int round = 0; round < rounds; ++round) {
        SolveOptions quick;
        quick.method = Method::reuse;
        const std::uint64_t patches = scene.patch_count();
        quick.lines = std::min(usual_lines * patches, std::max(fewest_lines * patches, many_lines));
        quick.all_pairs = false; // the table would take longer than everything else
        quick.memory = memory;
        quick.threads = threads;
        const Solution solution = solve(scene, quick, [&](double done) { progress((round + done) / rounds); });
        const double wanted = coarse.patch_count() * elementary::pow(growth, (round + 1.0) / rounds);
        scene = cut(scene, errors(scene, solution.radiosity, threads),
                    std::min(most, static_cast<std::uint64_t>(std::lround(wanted))), threads);
    }
    return scene;
}

} // namespace multipath
