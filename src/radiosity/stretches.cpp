#include "radiosity/stretches.h"

#include "radiosity/replicates.h"
#include "radiosity/run_record.h"
#include "sampling/random.h"
#include "scene/input_error.h"
#include "transport/line_sampling.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace multipath {

namespace {

/// The options for lines begin ... end - 1 of the run, which nothing of the others' chance touches.
SolveOptions stretch_options(const Scene& scene, const SolveOptions& options, std::uint64_t number, std::uint64_t begin,
                             std::uint64_t end)
{
    SolveOptions stretch = options;
    stretch.lines = end - begin;
    stretch.skip += begin == 0 ? 0 : GlobalLines(scene.bounds(), chords_of(options)).lines_to_cast(begin);
    if (number > 0)
        stretch.seed = random_bits(mix_bits(options.seed ^ 0xbe5466cf34e90c6cu), number);
    return stretch;
}

} // namespace

Solution solve_in_stretches(const Scene& scene, const SolveOptions& options, int replicates,
                            const ProgressCallback& progress, Checkpoint* checkpoint, Share share)
{
    if (share.of > 1 && replicates > 1)
        throw std::invalid_argument("replicates have no shares");
    const bool walks = options.method != Method::reuse;
    const Preparation preparation = prepare(scene, options);
    RunRecord record;
    const Checkpoint::Part part(checkpoint, RunRecord::part,
                                [&](Archive& archive) { record.visit(archive, scene.patch_count()); });
    if (record.lines > options.lines || record.goal > options.lines)
        throw InputError("the run has " + std::to_string(std::max(record.lines, record.goal)) +
                         " lines already; expected --lines to be no fewer");
    while (record.lines < options.lines) {
        if (record.goal == 0)
            record.goal = options.lines;
        const SolveOptions stretch =
            share.of > 1 && walks
                ? stretch_options(scene, options, share.number, share.begin(record.goal), share.end(record.goal))
                : stretch_options(scene, options, record.pieces, record.lines, record.goal);
        Solution found = replicates > 1
                             ? solve_replicates(scene, preparation, stretch, replicates, progress, checkpoint)
                             : solve(scene, preparation, stretch, progress, checkpoint, walks ? Share{} : share);
        if (checkpoint && checkpoint->stopped())
            return record.pieces > 0 ? record.solution : found;
        record.finish_piece(record.pieces > 0 ? combined(scene, {record.solution, found}) : std::move(found));
    }
    if (checkpoint)
        checkpoint->finish();
    return record.solution;
}

} // namespace multipath
