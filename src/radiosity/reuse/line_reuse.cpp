// The walk of the multi-path method uses each line once and then forgets it. But the information of a line, which
// patches see each other, remains valid. So here the lines are only counted. The counts give an estimate of the
// exchange between all pairs of patches, and a linear system gives the light. Noise remains for pairs that see each
// other in part; half of the lines, as rays between points of these pairs, reduce it.

#include "radiosity/reuse/line_reuse.h"

#include "radiosity/reuse/exchange_solver.h"
#include "transport/exchange/dense_exchange.h"
#include "transport/exchange/exchange_estimate.h"
#include "transport/exchange/pair_rays.h"
#include "transport/exchange/symmetric_product.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace multipath {

namespace {

using Field = std::vector<Rgb>;

ExchangeLosses losses(const PairCounts& counts, double crossing_area)
{
    ExchangeLosses result;
    for (std::size_t i = 0; i < counts.escaped.size(); ++i) {
        result.escaping.push_back(crossing_area * static_cast<double>(counts.escaped[i]));
        result.behind.push_back(crossing_area * static_cast<double>(counts.behind[i]));
    }
    return result;
}

/// Radiosity accurate enough to distribute rays.
Field rough_radiosity(const PairMatrix<float>& pairs, const ExchangeLosses& losses, const Field& rho,
                      const Field& source, int threads)
{
    const std::vector<double> ones(pairs.size(), 1.0);
    std::vector<double> rows = symmetric_product(pairs, {ones}, threads)[0];
    for (std::uint32_t i = 0; i < pairs.size(); ++i)
        rows[i] += losses.escaping[i] + losses.behind[i];
    const DenseExchange exchange(pairs, losses, rows, threads);
    Field radiosity = solve_exchange(exchange, rho, source, source, 1e-2, 8, threads).radiosity;
    for (Rgb& b : radiosity)
        b = {std::max(b.r, 0.0), std::max(b.g, 0.0), std::max(b.b, 0.0)};
    return radiosity;
}

/// The exchange estimated so far, first from global lines, then also from rays.
struct CountedExchange
{
    std::uint64_t lines = 0; ///< number of global lines; 0 until all are counted
    ExchangeEstimate estimate;
    ExchangeLosses losses;
    Field first_guess; ///< [W/m^2] radiosity

    explicit CountedExchange(std::uint32_t patches)
        : estimate{PairMatrix<float>(patches), PairMatrix<float>(patches)},
          losses{std::vector<double>(patches), std::vector<double>(patches)},
          first_guess(patches)
    {
    }

    void visit(Archive& archive)
    {
        archive.value<std::uint64_t>("lines", lines);
        if (lines == 0)
            return;
        estimate.exchange.visit<float>(archive, "exchange");
        estimate.variance.visit<float>(archive, "variance");
        archive.list<double>("escaping", losses.escaping);
        archive.list<double>("behind", losses.behind);
        archive.list<double>("first guess", first_guess);
    }
};

/// The exchange after the closure: its rows add up to the areas of the patches.
struct ClosedExchange
{
    PairMatrix<float> pairs;
    ExchangeLosses losses;
};

/// Adds `change` [m^2] to the lost exchange of a patch, in proportion to its parts. If nothing is lost yet, the change
/// escapes if the patch faces no other patch, and is ignored otherwise.
void change_losses(double change, bool meets_nothing, double& escaping, double& behind)
{
    const double lost = escaping + behind;
    if (lost > 0.0) {
        escaping += change * (escaping / lost);
        behind += change * (behind / lost);
    } else if (meets_nothing) {
        escaping = change;
    }
}

ClosedExchange closed(const Scene& scene, const PairMatrix<float>& unoccluded, CountedExchange counted,
                      double crossing_area, int threads)
{
    ExchangeLosses losses = std::move(counted.losses);
    std::vector<double> row_sums = scene.areas();
    std::vector<double> sum_variance(row_sums.size());
    for (std::uint32_t i = 0; i < row_sums.size(); ++i) {
        const double lost = losses.escaping[i] + losses.behind[i];
        row_sums[i] -= lost;
        sum_variance[i] = crossing_area * lost;
    }
    ClosedEstimate result = reconciled(std::move(counted.estimate), row_sums, sum_variance, threads);
    const std::vector<double> ones(row_sums.size(), 1.0);
    const std::vector<double> in_sight = symmetric_product(unoccluded, {ones}, threads)[0];
    for (std::uint32_t i = 0; i < row_sums.size(); ++i) {
        const bool meets_nothing = !(in_sight[i] > 0.0);
        change_losses(meets_nothing ? row_sums[i] : result.sum_residual[i], meets_nothing, losses.escaping[i],
                      losses.behind[i]);
    }
    return {std::move(result.exchange), std::move(losses)};
}

/// Sets negative estimates to zero. The resulting errors of the row sums become self-exchange, so that the diagonal
/// dominates every row and a solution exists, however large the noise is.
void clamp_to_positive(PairMatrix<float>& pairs)
{
    for (std::uint32_t i = 0; i < pairs.size(); ++i)
        for (std::uint32_t j = 0; j < i; ++j)
            pairs.at(i, j) = std::max(pairs.at(i, j), 0.0f);
}

} // namespace

double reuse_bytes(const Scene& scene)
{
    const auto pairs = static_cast<double>(PairMatrix<float>::pair_count(scene.patch_count()));
    constexpr double counted =
        sizeof(PairCount) +
        sizeof(float); // bytes of a pair while lines are counted; the next line includes its estimate
    constexpr double estimated = counted + 2 * sizeof(float);
    return std::max(estimated * pairs, counted * pairs + estimation_bytes(scene));
}

std::uint64_t reuse_lines(const Scene& scene, const UnoccludedExchange& unoccluded, const GlobalLines& lines,
                          const Sequence& sequence, const ReusedLines& plan, const RunControl& run, PowerState& state)
{
    if (plan.cast == 0)
        return 0;
    const Field source = unshot_radiosity(scene, state);
    const Field rho = reflectances(scene);
    CountedExchange counted(scene.patch_count());
    const Checkpoint::Part part(run.checkpoint, "line reuse", [&](Archive& archive) { counted.visit(archive); });
    const auto crossing_area_of = [&](std::uint64_t cast) { return 1.0 / lines.expected_crossings(1.0, cast); }; // (G1)
    if (counted.lines == 0) {
        const PairCounts counts = count_pairs(scene, lines, sequence, plan.first_line_item, plan.cast, run);
        if (counts.lines == 0 || (run.stopped() && run.is_shard()))
            return counts.lines;
        const double area = crossing_area_of(counts.lines);
        counted.lines = counts.lines;
        counted.estimate = estimate_exchange(scene, unoccluded.table(), counts, area, run.threads);
        counted.losses = losses(counts, area);
        counted.first_guess = plan.rays > 0
                                  ? rough_radiosity(counted.estimate.exchange, counted.losses, rho, source, run.threads)
                                  : source;
    }
    const std::uint64_t lines_cast = counted.lines;
    const double crossing_area = crossing_area_of(lines_cast);
    if (plan.rays > 0 && !run.stopped())
        refine_by_rays(counted.estimate, scene, unoccluded.table(), crossing_area, counted.first_guess, sequence,
                       {plan.first_ray_item, plan.rays, plan.seed}, run);
    if (run.stopped() && run.is_shard())
        return lines_cast;
    const Field first_guess = counted.first_guess;
    ClosedExchange closed_exchange = closed(scene, unoccluded.table(), std::move(counted), crossing_area, run.threads);

    const auto exchange_of_pairs = [&] {
        return std::make_unique<DenseExchange>(closed_exchange.pairs, closed_exchange.losses, scene.areas(),
                                               run.threads);
    };
    std::unique_ptr<DenseExchange> exchange = exchange_of_pairs();
    ExchangeSolution solution = solve_exchange(*exchange, rho, source, first_guess, run.threads); // (R1)
    if (!solution.converged) {
        clamp_to_positive(closed_exchange.pairs);
        exchange = exchange_of_pairs();
        solution = solve_exchange(*exchange, rho, source, source, run.threads);
        if (!solution.converged)
            throw no_solution(scene);
    }
    distribute(scene, *exchange, solution.radiosity, 1.0, run.threads, state);
    return lines_cast;
}

} // namespace multipath
