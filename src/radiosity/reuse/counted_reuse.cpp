#include "radiosity/reuse/counted_reuse.h"

#include "radiosity/reuse/exchange_solver.h"
#include "transport/exchange/line_counts.h"
#include "transport/exchange/sparse_exchange.h"

#include <algorithm>

namespace multipath {

std::size_t count_bytes(std::uint32_t patches, double memory)
{
    // Rounds of fewer lines than patches would cost more to solve than to trace.
    return std::max(static_cast<std::size_t>(memory), std::size_t{256} * patches);
}

double fewest_lines_to_count(const Scene& scene, const GlobalLines& lines)
{
    constexpr double lines_per_patch = 10.0; // were all patches black
    const double absorption = 1.0 - mean(scene.average_reflectance());
    constexpr std::uint64_t many = 1u << 20;
    const double crossings_per_line = lines.expected_crossings(scene.total_area(), many) / static_cast<double>(many);
    return lines_per_patch * scene.patch_count() / (absorption * crossings_per_line);
}

bool can_count(const Scene& scene, const GlobalLines& lines, std::uint64_t lines_cast, std::size_t byte_limit)
{
    constexpr double bytes_per_line_end = 8.0;
    const double bytes_per_line =
        bytes_per_line_end * lines.expected_crossings(scene.total_area(), lines_cast) / static_cast<double>(lines_cast);
    const double at_a_time =
        std::min(static_cast<double>(lines_cast), static_cast<double>(byte_limit) / bytes_per_line);
    return at_a_time >= fewest_lines_to_count(scene, lines);
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
        if (counted.lines_cast == 0 || (run.stopped() && run.is_shard()))
            break;
        const std::uint64_t planned = run.stopped() ? lines_cast - done : counted.lines_cast;
        const double crossing_area = 1.0 / lines.expected_crossings(1.0, counted.lines_cast); // (G1)
        const double share = static_cast<double>(planned) / static_cast<double>(lines_cast);
        const auto solved = [&](double unseen_lines) {
            const SparseExchange exchange(counted.counts, scene.areas(), crossing_area, unseen_lines, run.threads);
            const ExchangeSolution solution = solve_exchange(exchange, rho, source, source, run.threads); // (R1)
            if (solution.converged)
                distribute(scene, exchange, solution.radiosity, share, run.threads, state);
            return solution.converged;
        };
        // White patches that the lines join only with each other keep their light for ever: no solution exists.
        if (!solved(0.0) && !solved(1.0))
            throw no_solution(scene);
        done += counted.lines_cast;
    }
    return done;
}

} // namespace multipath
