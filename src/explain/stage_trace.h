#pragma once

#include "explain/traced_line.h"
#include "radiosity/run/solve_options.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// Traces: step-by-step records of what single lines of a run do, for readers who want to follow the method. Traces are
// made with the functions that the solver itself calls, in the same order and with the same items (points of the
// sequence, see sampling/sequence.h), so they show what really happens. Labels such as (M1) are those of
// docs/equations.md. Unshot power is power that a patch has not yet sent on. The forecast (G3) is the part of the
// unshot power that each global line leaving the patch carries.

namespace multipath {

/// The lines (or rays, particles, walks) to trace in a stage: first ... first + count - 1, numbered from 0.
struct TracedRange
{
    std::uint64_t first = 0;
    std::uint64_t count = 3;
    std::size_t pass = 0; ///< of the first shot, from 0; other stages have none

    bool includes(std::uint64_t number) const { return number >= first && number - first < count; }
};

/// The run to which traced lines belong. Scene and options must outlive the object.
struct TracedRun
{
    const Scene& scene;
    const SolveOptions& options;
    std::string settings; ///< how readers may call it: method and sequence
};

/// The traces of some lines of one stage of a run, and what readers must know about the stage. The text of `explain`,
/// the drawing and the page all show it.
struct StageTrace
{
    std::string title;                  ///< "Lines of the global pass"
    std::vector<std::string> context;   ///< paragraphs that explain the lines
    std::string kind;                   ///< name of one line, such as "walk"
    std::uint64_t count;                ///< number of all lines of the stage
    bool from_outside = false;          ///< the lines start on the sphere or box around the scene
    std::vector<TracedLine> lines = {}; ///< those of the range
};

// Each function traces the lines of the range in one stage. Besides the errors named below, all throw
// std::invalid_argument for an unknown sequence, and SettingsError for lines that the stage does not have and for a
// sequence with too few items. Those that run the first shot also throw SettingsError if the user sets the power of one
// ray (power_by_line) so low that the first pass alone needs more rays than the run has lines.

/// Rays of one pass of the (extended) first shot (S1): runs the whole first shot, then repeats the pass as far as the
/// last ray of the range. Throws SettingsError for a pass that the run does not have.
StageTrace trace_shot_pass(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// Global lines (M1): runs the first shot, and the global pass up to the last line of the range.
StageTrace trace_global_pass(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// Lines along the first direction of the first iteration of transillumination, which casts bundles of parallel lines
/// (P1); all are made from the same item. Throws SettingsError if the run has too few lines for a direction.
StageTrace trace_bundle(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// Particles of local Monte Carlo (L1), each from its source to its end.
StageTrace trace_particles(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// Gathering random walks (W1) of the first round. A walk starts at a patch and gathers the light for this patch.
StageTrace trace_walks(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// Rays of the first stochastic Jacobi iteration (J1) (J2), in the order of the patches that they leave. Throws
/// SettingsError if the run has too few lines for an iteration.
StageTrace trace_iteration(const Scene& scene, const SolveOptions& options, const TracedRange& range);

/// A stage whose lines can be traced.
struct StageTracer
{
    std::string_view stage; ///< see MethodInfo::traced
    StageTrace (*trace)(const Scene&, const SolveOptions&, const TracedRange&);
};

/// The stage whose lines are rays of a pass of the extended first shot (TracedRange::pass).
constexpr std::string_view later_pass = "extended:PASS";

constexpr std::array<StageTracer, 7> stage_tracers = {{{"first-shot", trace_shot_pass},
                                                       {later_pass, trace_shot_pass},
                                                       {"global", trace_global_pass},
                                                       {"bundle", trace_bundle},
                                                       {"local", trace_particles},
                                                       {"gathering", trace_walks},
                                                       {"iteration", trace_iteration}}};

} // namespace multipath
