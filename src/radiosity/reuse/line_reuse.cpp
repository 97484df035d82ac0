// The walk of the multi-path method uses each line once and then forgets it. But the information of a line, which
// patches see each other, remains valid. So here the lines are only counted. The counts give an estimate of the
// exchange between all pairs of patches, and a linear system gives the light. Noise remains for pairs that see each
// other in part; half of the lines, as rays between points of these pairs, reduce it.

#include "radiosity/reuse/line_reuse.h"

#include "base/lists.h"
#include "radiosity/reuse/exchange_solver.h"
#include "transport/exchange/dense_exchange.h"
#include "transport/exchange/exchange_estimate.h"
#include "transport/exchange/symmetric_product.h"

#include <algorithm>

namespace multipath {

namespace {

using Field = std::vector<Rgb>;

/// Lines that left the front of a patch, or of all patches on one side of a surface.
struct LeavingLines
{
    double all = 0.0;
    double lost = 0.0;   ///< those that reached no patch
    double behind = 0.0; ///< those of them that met a side without a patch

    LeavingLines& operator+=(const LeavingLines& other)
    {
        all += other.all;
        lost += other.lost;
        behind += other.behind;
        return *this;
    }
};

std::vector<LeavingLines> leaving_lines(const PairCounts& counts)
{
    std::vector<LeavingLines> result(counts.escaped.size());
    for (std::uint32_t i = 0; i < result.size(); ++i) {
        const auto lost = static_cast<double>(counts.escaped[i] + counts.behind[i]);
        result[i] += {lost, lost, static_cast<double>(counts.behind[i])};
        const PairCount* const row = counts.pairs.row(i);
        for (std::uint32_t j = 0; j < i; ++j) {
            result[i].all += row[j].joined;
            result[j].all += row[j].joined;
        }
    }
    return result;
}

std::vector<LeavingLines> sums_over(const PatchBlocks& blocks, const std::vector<LeavingLines>& lines)
{
    std::vector<LeavingLines> sums(blocks.count);
    for (std::size_t i = 0; i < lines.size(); ++i)
        sums[blocks.block_of[i]] += lines[i];
    return sums;
}

/// The losses of every patch: its area times the fraction of the lines leaving it that reach no patch. With the weight
/// of one line each, the whole scene is the prior of the side of a surface, the side that of a block of patches, and
/// the block that of the patch (empirical Bayes), but no less than the patches in front cannot fill without obstacles.
/// What share of them is lost behind surfaces has the side's as its prior.
/// Sets `variance` [m^4] to that of the losses, which the patches around and the estimated exchange predict: by its own
/// lines, a loss that is too large by chance would look certain. It is 0 if the scene has lost no line. `in_sight` and
/// `joined` [m^2] are the sums of the rows without obstacles and with them.
ExchangeLosses losses(const Scene& scene, const PairCounts& counts, const std::vector<double>& in_sight,
                      const std::vector<double>& joined, std::vector<double>& variance)
{
    constexpr double inexact = 1e-3;          // of sums of exchange areas
    constexpr std::uint32_t cells_around = 4; // along an edge of a block
    const std::vector<LeavingLines> lines = leaving_lines(counts);
    const PatchBlocks sides = surface_blocks(scene);
    const PatchBlocks blocks = patch_blocks(scene, cells_around);
    const std::vector<LeavingLines> of_sides = sums_over(sides, lines);
    const std::vector<LeavingLines> of_blocks = sums_over(blocks, lines);
    const LeavingLines all = sum_over(lines, [](const LeavingLines& patch) { return patch; });
    const auto lost_without = [](const LeavingLines& whole, const LeavingLines& part, double prior) {
        return (whole.lost - part.lost + prior) / (whole.all - part.all + 1.0);
    };
    const double overall = all.all > 0.0 ? all.lost / all.all : 1.0;
    ExchangeLosses result{std::vector<double>(lines.size()), std::vector<double>(lines.size())};
    variance.assign(lines.size(), 0.0);
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
        const LeavingLines& own = lines[i];
        const LeavingLines& side = of_sides[sides.block_of[i]];
        const double area = scene.area(i);
        const double unfilled = 1.0 - in_sight[i] / area;
        const double least = unfilled > inexact ? unfilled : 0.0;
        const double around =
            std::max(least, lost_without(of_blocks[blocks.block_of[i]], own, lost_without(side, own, overall)));
        const double lost = lost_without(own, {}, around);
        const double behind = (own.behind + quotient(side.behind, side.lost)) / (own.lost + 1.0);
        result.behind[i] = area * lost * behind;
        result.escaping[i] = area * lost - result.behind[i];
        const double not_lost = std::max(1.0 - around, std::min(1.0, joined[i] / area));
        variance[i] = area * area * around * not_lost / (own.all + 1.0);
    }
    return result;
}

/// Radiosity accurate enough to distribute rays.
Field rough_radiosity(const PairMatrix<float>& pairs, const ExchangeLosses& losses, const Field& rho,
                      const Field& source, int threads)
{
    std::vector<double> rows = row_sums(pairs, threads);
    for (std::uint32_t i = 0; i < pairs.size(); ++i)
        rows[i] += losses.escaping[i] + losses.behind[i];
    const DenseExchange exchange(pairs, losses, rows, threads);
    Field radiosity = solve_exchange(exchange, rho, source, source, threads, 1e-2, 8).radiosity;
    for (Rgb& b : radiosity)
        b = by_channel([](double x) { return std::max(x, 0.0); }, b);
    return radiosity;
}

/// The exchange estimated so far, first from global lines, then also from rays.
struct CountedExchange
{
    std::uint32_t patches;
    std::uint64_t lines = 0; ///< number of global lines; 0 until all are counted
    ExchangeEstimate estimate = {PairMatrix<float>(patches), PairMatrix<float>(patches)};
    ExchangeLosses losses = {std::vector<double>(patches), std::vector<double>(patches)};
    std::vector<double> variance_of_losses = std::vector<double>(patches); ///< [m^4]
    Field first_guess = Field(patches);                                    ///< [W/m^2] radiosity

    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("lines", lines);
        if (lines == 0)
            return;
        estimate.visit(archive);
        archive.list<double>("escaping", losses.escaping);
        archive.list<double>("behind", losses.behind);
        archive.list<double>("variance of losses", variance_of_losses);
        archive.list<double>("first guess", first_guess);
    }
};

/// Sets the lost exchange of a patch to `lost` [m^2], in proportion to its parts; if nothing was lost before, it
/// escapes.
void set_losses(double lost, double& escaping, double& behind)
{
    const double before = escaping + behind;
    behind = before > 0.0 ? behind * (lost / before) : 0.0;
    escaping = lost - behind;
}

/// Closes the rows. Losses that would become negative are set to zero, and the rest is closed again (the active-set
/// method for least squares with bounds, Lawson and Hanson 1974, chapter 23).
void close_rows(const Scene& scene, const PairMatrix<float>& unoccluded, int threads, CountedExchange& counted)
{
    constexpr int most_passes = 8;
    std::vector<double>& escaping = counted.losses.escaping;
    std::vector<double>& behind = counted.losses.behind;
    std::vector<double> variance = counted.variance_of_losses;
    const std::vector<double> area = scene.areas();
    const std::vector<double> seen = row_sums(unoccluded, threads);
    for (std::uint32_t i = 0; i < area.size(); ++i)
        if (!(seen[i] > 0.0)) {
            set_losses(area[i], escaping[i], behind[i]);
            variance[i] = 0.0;
        }
    bool negative = true;
    for (int pass = 0; pass < most_passes && negative; ++pass) {
        std::vector<double> wanted = area;
        for (std::uint32_t i = 0; i < area.size(); ++i)
            wanted[i] -= escaping[i] + behind[i];
        const std::vector<double> changes = reconcile(counted.estimate, wanted, variance, threads);
        negative = false;
        for (std::uint32_t i = 0; i < area.size(); ++i) {
            const double lost = escaping[i] + behind[i] + changes[i];
            negative = negative || lost < 0.0;
            if (lost < 0.0)
                variance[i] = 0.0;
            if (changes[i] != 0.0)
                set_losses(std::max(0.0, lost), escaping[i], behind[i]);
        }
    }
}

} // namespace

std::uint64_t min_table_lines(const Scene& scene)
{
    return std::uint64_t{4} * scene.patch_count();
}

double reuse_bytes(const Scene& scene)
{
    const auto pairs = static_cast<double>(PairMatrix<float>::pair_count(scene.patch_count()));
    constexpr double counted =
        sizeof(PairCount) +
        sizeof(float); // bytes of a pair while lines are counted; the next line includes its estimate
    constexpr double estimated = counted + 2 * sizeof(float);
    return std::max(estimated * pairs, counted * pairs + estimation_bytes(scene));
}

std::uint64_t reuse_lines(const Scene& scene, const std::shared_future<PairMatrix<float>>& unoccluded,
                          const GlobalLines& lines, const Sequence& sequence, const ReusedLines& plan,
                          const RunControl& run, PowerState& state)
{
    if (plan.cast == 0)
        return 0;
    const Field source = unshot_radiosity(scene, state);
    const Field rho = reflectances(scene);
    CountedExchange counted{scene.patch_count()};
    const Checkpoint::Part part(run.checkpoint, "line reuse", [&](Archive& archive) { counted.visit(archive); });
    const auto crossing_area_of = [&](std::uint64_t cast) { return 1.0 / lines.expected_crossings(1.0, cast); }; // (G1)
    if (counted.lines == 0) {
        const PairCounts counts = count_pairs(scene, lines, sequence, plan.first_line_item, plan.cast, run);
        if (counts.lines == 0 || (run.stopped() && run.is_shard()))
            return counts.lines;
        const double area = crossing_area_of(counts.lines);
        counted.lines = counts.lines;
        counted.estimate = estimate_exchange(scene, unoccluded.get(), counts, area, run.threads);
        counted.losses = losses(scene, counts, row_sums(unoccluded.get(), run.threads),
                                row_sums(counted.estimate.exchange, run.threads), counted.variance_of_losses);
        counted.first_guess = plan.rays.rays > 0
                                  ? rough_radiosity(counted.estimate.exchange, counted.losses, rho, source, run.threads)
                                  : source;
    }
    const std::uint64_t lines_cast = counted.lines;
    const double crossing_area = crossing_area_of(lines_cast);
    if (plan.rays.rays > 0 && !run.stopped())
        refine_by_rays(counted.estimate, scene, unoccluded.get(), crossing_area, counted.first_guess, sequence,
                       plan.rays, run);
    if (run.stopped() && run.is_shard())
        return lines_cast;
    close_rows(scene, unoccluded.get(), run.threads, counted);

    const auto solved = [&](const Field& first_guess) {
        const DenseExchange exchange(counted.estimate.exchange, counted.losses, scene.areas(), run.threads);
        const ExchangeSolution solution = solve_exchange(exchange, rho, source, first_guess, run.threads); // (R1)
        if (solution.converged)
            distribute(scene, exchange, solution.radiosity, 1.0, run.threads, state);
        return solution.converged;
    };
    if (solved(counted.first_guess))
        return lines_cast;
    // Without negative estimates the errors of the row sums become self-exchange, so that the diagonal dominates every
    // row and a solution exists, however large the noise is.
    PairMatrix<float>& pairs = counted.estimate.exchange;
    for (std::uint32_t i = 0; i < pairs.size(); ++i)
        for (std::uint32_t j = 0; j < i; ++j)
            pairs.at(i, j) = std::max(pairs.at(i, j), 0.0f);
    if (!solved(source))
        throw no_solution(scene);
    return lines_cast;
}

} // namespace multipath
