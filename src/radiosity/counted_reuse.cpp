#include "radiosity/counted_reuse.h"

#include "radiosity/distribution.h"
#include "radiosity/exchange_solver.h"
#include "transport/line_counts.h"
#include "transport/sparse_exchange.h"

#include <algorithm>

namespace multipath {

void reuse_counted_lines(const Scene& scene, const GlobalLines& lines, const Sequence& sequence,
                         std::uint64_t first_item, std::uint64_t lines_cast, std::size_t byte_limit, int threads,
                         PowerState& state, const LineCounter& count_lines_done)
{
    // Rounds of fewer lines than patches would cost more to solve than to trace.
    const std::size_t least_bytes = std::size_t{256} * scene.patch_count();
    const std::vector<Rgb> source = unshot_radiosity(scene, state);
    const std::vector<Rgb> rho = reflectances(scene);
    for (std::uint64_t done = 0; done < lines_cast;) {
        const CountedLines counted = count_lines(scene, lines, sequence, first_item + done, lines_cast - done,
                                                 std::max(byte_limit, least_bytes), threads, count_lines_done);
        done += counted.lines_cast;
        const double crossing_area = 1.0 / lines.expected_crossings(1.0, counted.lines_cast); // (G1)
        const SparseExchange exchange(counted.counts, crossing_area, threads);
        constexpr double tolerance = 1e-6; // far below the noise of counts
        const ExchangeSolution solution =
            solve_exchange(exchange, rho, source, source, tolerance, 500, threads); // (R1)
        const double share = static_cast<double>(counted.lines_cast) / static_cast<double>(lines_cast);
        distribute(scene, exchange, solution.radiosity, share, threads, state);
    }
}

} // namespace multipath
