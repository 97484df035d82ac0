// Packets of power arrive at a patch like events of a Poisson process. If each carries s, and the expected sum is I,
// the variance of the sum is the expected number times E[s^2].
//
// Local lines: all rays carry Phi_s / N_l, where Phi_s is the power of all passes, so patch j gets the variance
// I_j Phi_s / N_l. Its radiosity gets that times (rho_j / A_j)^2, and the sum over the area is (V1).
//
// Global lines: let each square metre send d packets per line, and let patch i have the unshot radiosity b_i after the
// shots. A packet carries the forecast b_i / (d N_g), and rho_i times the packet that patch i received last. With
// probability q it arrives at a patch: 1 in a closed room. In units of 1 / (d N_g), and with means <> over the area,
// from which packets come in equal density, the mean and the mean square of a packet are therefore
//     M_1 = <b> + q <rho> M_1
//     M_2 = <b^2> + 2 q <rho b> M_1 + q <rho^2> M_2,
// and patch j gets the variance q A_j M_2 / (d N_g) (V2). One way, the packets received since patch i last sent are 0,
// 1, 2, ... with the probabilities 1/2, 1/4, 1/8, ..., which adds 2 q^2 <rho^2> M_1^2 to M_2.
//
// What is left out: quasi-random lines leave less of both variances, and the error of the shots is carried on by the
// walk, spread over so many patches that each of them gets little.

#include "radiosity/paper/measured_ratio.h"

#include "base/lists.h"
#include "transport/lines/depth_complexity.h"
#include "transport/lines/line_segments.h"

#include <algorithm>
#include <cmath>

namespace multipath {

WalkDensity walk_density(const Scene& scene, const GlobalLines& global_lines, const Sequence& sequence,
                         std::uint64_t first_item, bool bidirectional)
{
    constexpr std::uint64_t tried = 1u << 10;
    constexpr std::uint64_t many = 1u << 30;
    const LineBlocks plan{
        scene, global_lines, sequence, first_item, {tried, lines_per_block(crossings_per_line(scene, global_lines))}};
    SegmentBlock block;
    std::uint64_t sent = 0;
    std::uint64_t arrived = 0;
    for (std::uint64_t number = 0; number < plan.lines.count(); ++number) {
        block.trace(plan, number);
        for (const Segment& segment : block.segments) {
            sent += (Segment::is_patch(segment.from) ? 1 : 0) + (Segment::is_patch(segment.to) ? 1 : 0);
            arrived += segment.joins_patches() ? 2 : 0;
        }
    }
    const double crossings =
        global_lines.expected_crossings(1.0, global_lines.lines_to_cast(many)) / static_cast<double>(many); // (G1)
    return {(bidirectional ? 1.0 : 0.5) * crossings,
            sent > 0 ? static_cast<double>(arrived) / static_cast<double>(sent) : 1.0, bidirectional};
}

LineVariances line_variances(const Scene& scene, const PilotShot& pilot, const WalkDensity& walk)
{
    const double shot = sum_over(pilot.passes, &ShotPass::power); // Phi_s [W]
    // After a single pass, b contains the noise of what the patch received: the variance of I, which came in rays of
    // equal power, is I times this power. It is subtracted from <b^2>, which is meant without noise. After several
    // passes b is at most the threshold: nothing is subtracted.
    const double ray_power = pilot.passes.size() == 1 ? shot / static_cast<double>(pilot.passes[0].lines) : 0.0; // [W]
    const PowerState before(scene);
    double rho_squared = 0.0;      // [1] of rho^2, one per patch
    double received = 0.0;         // [W/m^2] of rho^2 I / A, with I the power that arrived by rays
    double unshot = 0.0;           // [W/m^2] <b>
    double unshot_squared = 0.0;   // [W^2/m^4] <b^2>
    double unshot_reflected = 0.0; // [W/m^2] <rho b>
    double mean_rho = 0.0;         // [1] <rho>
    double mean_rho_squared = 0.0; // [1] <rho^2>
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double area = scene.area(i);
        const double share = area / scene.total_area();
        const double rho = mean(scene.reflectance(i));
        const double b = mean(pilot.after.unshot[i]) / area;
        const double irradiance = mean(pilot.after.incident[i] - before.incident[i]) / area;
        const double noise = rho * rho * irradiance * ray_power / area;
        rho_squared += rho * rho;
        received += rho * rho * irradiance;
        unshot += share * b;
        unshot_squared += share * (b * b - noise);
        unshot_reflected += share * rho * b;
        mean_rho += share * rho;
        mean_rho_squared += share * rho * rho;
    }
    const double q = walk.arriving_share;
    const double first = unshot / (1.0 - q * mean_rho); // M_1
    double second = std::max(0.0, unshot_squared) + 2.0 * q * unshot_reflected * first;
    if (!walk.bidirectional)
        second += 2.0 * q * q * mean_rho_squared * first * first;
    second /= 1.0 - q * mean_rho_squared;                         // M_2
    return {shot * received,                                      // (V1)
            q * second * rho_squared / walk.departures_per_area}; // (V2)
}

std::optional<double> best_ratio(const LineVariances& variances)
{
    constexpr double most = 1e12;
    if (!(variances.local > 0.0))
        return std::nullopt;
    return variances.local < most * most * variances.global ? std::sqrt(variances.local / variances.global) : most;
}

} // namespace multipath
