#include "commands/explain/trace_text.h"

#include "base/text_format.h"
#include "cli/options/help_text.h"
#include "explain/words.h"

namespace multipath {

namespace {

constexpr std::size_t text_width = 110;

std::string patch_number(std::uint32_t patch)
{
    return Segment::is_patch(patch) ? std::to_string(patch) : "-";
}

/// A table of the hits in order, numbered from 1.
std::string crossings_table(const Scene& scene, const std::vector<Crossing>& crossings)
{
    std::string text = "   no       t  side   arrives at  leaves  surface, point\n";
    for (std::size_t k = 0; k < crossings.size(); ++k) {
        const Crossing& crossing = crossings[k];
        text += format("  %3zu  %.4f  %-5s  %10s  %6s  %s, %s\n", k + 1, crossing.hit.t,
                       crossing.hit.front ? "front" : "back", patch_number(crossing.patches.arrives_at).c_str(),
                       patch_number(crossing.patches.leaves).c_str(), surface_name(scene, crossing.hit.surface).c_str(),
                       point_text(crossing.point).c_str());
    }
    return text;
}

/// "ray 3 of 1,000: item 17 = (0.1, 0.2, 0.3, 0.4)"
std::string title(const StageTrace& trace, const LineOrigin& origin)
{
    return trace.kind + " " + grouped(origin.number + 1) + " of " + grouped(trace.count) + ": item " +
           grouped(origin.item) + " = " +
           format("(%.6f, %.6f, %.6f, %.6f)", origin.numbers[0], origin.numbers[1], origin.numbers[2],
                  origin.numbers[3]);
}

} // namespace

std::string wrapped(const std::string& text, std::size_t first, std::size_t others)
{
    return std::string(first, ' ') + wrapped_text(text, first, others, text_width);
}

std::string trace_text(const TracedRun& run, const StageTrace& trace)
{
    std::string text = wrapped(trace.title + " of a run with " + run.settings + ", " + grouped(run.options.lines) +
                                   " lines in total, " + grouped(run.scene.patch_count()) + " patches.",
                               0, 0) +
                       "\n";
    for (const std::string& paragraph : trace.context)
        text += wrapped(paragraph, 0, 0);
    for (const TracedLine& line : trace.lines) {
        text += "\n" + title(trace, line.origin) + "\n";
        if (!line.opening.empty()) {
            text += wrapped(line.opening, 2, 4);
            if (!line.crossings.empty())
                text += crossings_table(run.scene, line.crossings);
        }
        for (const std::string& note : line.notes)
            text += wrapped(note, 2, 4);
    }
    return text;
}

} // namespace multipath
