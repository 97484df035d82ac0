#include "radiosity/counted_reuse.h"

#include "radiosity/distribution.h"
#include "radiosity/exchange_solver.h"
#include "transport/line_counts.h"
#include "transport/sparse_exchange.h"

#include <algorithm>

namespace multipath {

std::size_t count_bytes(std::uint32_t patches, double memory)
{
    // Rounds of fewer lines than patches would cost more to solve than to trace.
    return std::max(static_cast<std::size_t>(memory), std::size_t{256} * patches);
}

std::uint64_t reuse_counted_lines(const Scene& scene, const GlobalLines& lines, const Sequence& sequence,
                                  std::uint64_t first_item, std::uint64_t lines_cast, std::size_t byte_limit,
                                  const RunControl& run, PowerState& state)
{
    const std::vector<Rgb> rho = reflectances(scene);
    std::vector<Rgb> source = unshot_radiosity(scene, state);
    std::uint64_t done = 0;
    const Checkpoint::Part part(run.checkpoint, "counted lines", [&](Archive& archive) {
        archive.list<double>("source", source);
        archive.value<std::uint64_t>("done", done);
        if (done > lines_cast)
            throw ArchiveError("the state is damaged: no such lines");
    });
    while (done < lines_cast && !run.stopped()) {
        const CountedLines counted =
            count_lines(scene, lines, sequence, first_item + done, lines_cast - done, byte_limit, run);
        if (counted.lines_cast == 0 || (run.stopped() && run.is_share()))
            break;
        const std::uint64_t planned = run.stopped() ? lines_cast - done : counted.lines_cast;
        const double crossing_area = 1.0 / lines.expected_crossings(1.0, counted.lines_cast); // (G1)
        const SparseExchange exchange(counted.counts, crossing_area, run.threads);
        const ExchangeSolution solution = solve_exchange(exchange, rho, source, source, run.threads); // (R1)
        const double share = static_cast<double>(planned) / static_cast<double>(lines_cast);
        distribute(scene, exchange, solution.radiosity, share, run.threads, state);
        done += counted.lines_cast;
    }
    return done;
}

} // namespace multipath
