#include "radiosity/run/solution.h"

#include "radiosity/run/statistics.h"

#include <cmath>
#include <utility>

namespace multipath {

void Solution::visit(Archive& archive, std::uint32_t patches)
{
    if (archive.reads()) {
        radiosity.resize(patches);
        unshot.resize(patches);
    }
    archive.list<double>("radiosity", radiosity);
    archive.list<double>("unshot", unshot);
    archive.value<double>("balance", balance);
    archive.value<std::uint64_t>("local lines", local_lines);
    archive.value<std::uint64_t>("global lines", global_lines);
    archive.value<std::uint64_t>("global lines cast", global_lines_cast);
    archive.value<std::uint64_t>("all lines", all_lines);
    multipath::visit(archive, shot_passes);
    auto fallen_back = static_cast<std::uint64_t>(by_particles);
    archive.value<std::uint64_t>("by particles", fallen_back);
    by_particles = fallen_back != 0;
    auto count = static_cast<std::uint64_t>(replicates);
    archive.value<std::uint64_t>("replicates", count);
    replicates = static_cast<int>(count);
    archive.growing_list<double>("standard error", standard_error);
    if (!standard_error.empty() && standard_error.size() != patches)
        throw ArchiveError("the state is damaged: no such errors");
    double error = relative_standard_error.value_or(-1.0);
    archive.value<double>("relative standard error", error);
    relative_standard_error = error >= 0.0 ? std::optional<double>(error) : std::nullopt;
}

void add(const Solution& part, double share, Solution& sum)
{
    for (std::size_t i = 0; i < sum.radiosity.size(); ++i) {
        sum.radiosity[i] += share * part.radiosity[i];
        sum.unshot[i] += share * part.unshot[i];
    }
    add(part.balance, share, sum.balance);
    sum.local_lines += part.local_lines;
    sum.global_lines += part.global_lines;
    sum.global_lines_cast += part.global_lines_cast;
    sum.all_lines += part.all_lines;
    sum.by_particles = sum.by_particles || part.by_particles;
}

Solution combined(const Scene& scene, const std::vector<Solution>& parts)
{
    double lines = 0.0;
    bool all_have_errors = true;
    for (const Solution& part : parts) {
        lines += static_cast<double>(part.all_lines);
        all_have_errors = all_have_errors && !part.standard_error.empty();
    }
    Solution sum;
    sum.radiosity.resize(scene.patch_count());
    sum.unshot.resize(scene.patch_count());
    sum.shot_passes = parts[0].shot_passes;
    sum.replicates = parts[0].replicates;
    std::vector<Rgb> variance(all_have_errors ? scene.patch_count() : 0);
    for (const Solution& part : parts) {
        const double share = static_cast<double>(part.all_lines) / lines;
        add(part, share, sum);
        for (std::size_t i = 0; i < variance.size(); ++i)
            variance[i] += (share * share) * (part.standard_error[i] * part.standard_error[i]);
    }
    for (const Rgb& v : variance)
        sum.standard_error.push_back(square_root(v));
    if (all_have_errors)
        sum.relative_standard_error =
            std::sqrt(expected_relative_square(scene.weights(), sum.radiosity, sum.standard_error));
    return sum;
}

void RunRecord::finish_piece(Solution found)
{
    solution = std::move(found);
    lines = goal;
    goal = 0;
    ++pieces;
}

void RunRecord::visit(Archive& archive, std::uint32_t patches)
{
    archive.value<std::uint64_t>("pieces", pieces);
    archive.value<std::uint64_t>("lines", lines);
    archive.value<std::uint64_t>("goal", goal);
    if (pieces > 0)
        solution.visit(archive, patches);
}

} // namespace multipath
