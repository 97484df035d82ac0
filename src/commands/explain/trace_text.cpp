// A text consists of a heading about the run, a paragraph that explains the stage, and one entry per traced line: the
// item of the sequence that makes the line, a table of its hits, and the power that it carries. Some spaces, such as
// those between numbers and units, are stored as the character `tied`, at which wrapped() breaks no line.

#include "commands/explain/trace_text.h"

#include "base/text_format.h"
#include "cli/options/help_text.h"
#include "explain/line_trace.h"

#include <algorithm>
#include <cmath>

namespace multipath {

namespace {

/// Stands for a space at which wrapped() breaks no line.
constexpr char tied = '\x1f';

/// "0.7", or "(0.7, 0.6, 0.5)" with tied spaces where the channels differ.
std::string colour_text(Rgb c)
{
    const std::string r = format("%.4g", c.r);
    const std::string g = format("%.4g", c.g);
    const std::string b = format("%.4g", c.b);
    return r == g && g == b ? r : "(" + r + "," + tied + g + "," + tied + b + ")";
}

/// "(1.234, 0.500, -2.000)"
std::string point_text(Vec3 p)
{
    const auto tidy = [](double x) { return std::abs(x) < 5e-4 ? 0.0 : x; }; // no "-0.000"
    return format("(%.3f, %.3f, %.3f)", tidy(p.x), tidy(p.y), tidy(p.z));
}

/// "item 17 = (0.1, 0.2, 0.3, 0.4)"
std::string origin_text(const LineOrigin& origin)
{
    return "item " + grouped(origin.item) + " = " +
           format("(%.6f, %.6f, %.6f, %.6f)", origin.numbers[0], origin.numbers[1], origin.numbers[2],
                  origin.numbers[3]);
}

constexpr std::size_t text_width = 110;
constexpr std::size_t widest_name = 41;

/// The text cut or padded to a number of columns.
std::string fitted(const std::string& text, std::size_t width)
{
    std::string cut = text;
    if (column_count(text) > width) {
        while (column_count(cut) > width - 2)
            cut.pop_back();
        cut += "..";
    }
    return cut + std::string(width - std::min(width, column_count(cut)), ' ');
}

std::string patch_number(std::uint32_t patch)
{
    return Segment::is_patch(patch) ? std::to_string(patch) : "-";
}

/// A table of the hits in order, numbered from 1.
std::string crossings_table(const Scene& scene, const std::vector<Crossing>& crossings)
{
    std::size_t name_width = 7;
    for (const Crossing& crossing : crossings)
        name_width = std::max(name_width, column_count(surface_name(scene, crossing.hit.surface)));
    name_width = std::min(name_width, widest_name);
    std::string text = "   no       t  " + fitted("surface", name_width) + "  side   arrives at  leaves  point\n";
    for (std::size_t k = 0; k < crossings.size(); ++k) {
        const Crossing& crossing = crossings[k];
        text += format("  %3zu  %.4f  %s  %-5s  %10s  %6s  %s\n", k + 1, crossing.hit.t,
                       fitted(surface_name(scene, crossing.hit.surface), name_width).c_str(),
                       crossing.hit.front ? "front" : "back", patch_number(crossing.patches.arrives_at).c_str(),
                       patch_number(crossing.patches.leaves).c_str(), point_text(crossing.point).c_str());
    }
    return text;
}

constexpr std::size_t name_column = 13; // where the patches of a segment are named
constexpr std::size_t indent = 15;      // of the lines below, about the power that they send

std::string heading(const TracedRun& run, const std::string& stage)
{
    return wrapped(stage + " of a run with --method " + run.method + ", sequence " + run.sequence + ", " +
                       grouped(run.options.lines) + " lines in total, " + grouped(run.scene.patch_count()) +
                       " patches.",
                   0, 0) +
           "\n";
}

std::string counted(std::uint64_t count, const char* one, const char* many)
{
    return grouped(count) + " " + (count == 1 ? one : many);
}

std::string title(const char* kind, const LineOrigin& origin, std::uint64_t of)
{
    return "\n" + std::string(kind) + " " + grouped(origin.number + 1) + " of " + grouped(of) + ": " +
           origin_text(origin) + "\n";
}

/// Fate of power that no patch receives.
std::string loss(std::uint32_t where)
{
    return where == Segment::behind ? "which is lost: it meets the back of a surface, where no patch is"
                                    : "which is lost: it leaves the scene";
}

std::string before_the_pass(const GlobalTrace& trace)
{
    const std::string unshot = watts(trace.unshot) + " on " + counted(trace.unshot_patches, "patch", "patches") + ". ";
    if (trace.shot_passes.empty())
        return "No rays are shot first: all power of the sources is unshot when the global lines begin, " + unshot;
    return "Before it, " + counted(trace.shot_passes.size(), "pass", "passes") + " of shots took " +
           grouped(trace.local_lines) +
           " of the lines. The power that patches reflected from them and that the sources kept is unshot: " + unshot;
}

/// Explains how the lines are generated, and how many are cast (N1).
std::string lines_drawn(const TracedRun& run, const GlobalTrace& trace)
{
    if (chords_of(run.options) == Chords::box)
        return " from random points of the scene's bounding box, in directions that favour its inward normal by the "
               "cosine: all of them meet the box (N1).";
    return "; " + grouped(trace.lines_cast) +
           " chords between random points of a sphere around the scene are cast, so that this many meet the scene's "
           "box (N1).";
}

std::string global_context(const TracedRun& run, const GlobalTrace& trace)
{
    const double area = run.scene.total_area() / run.scene.patch_count();
    const double crossings = trace.crossings_per_area * area;
    const bool both = run.options.bidirectional;
    const std::string per_patch = format("%.4g", both ? crossings : 0.5 * crossings);
    return wrapped(before_the_pass(trace) + "The pass distributes it with " +
                       counted(trace.lines_charged, "global line", "global lines") + lines_drawn(run, trace),
                   0, 0) +
           wrapped("Such chords cross a patch in proportion to its area, " +
                       format("%.4g times per square metre (G1). A patch of %.3g%cm^2, the mean, is crossed ",
                              trace.crossings_per_area, area, tied) +
                       format("%.4g times, and ", crossings) +
                       (both ? "each crossing leaves its front in one of the line's two directions (M2)"
                             : "half of the lines leave its front") +
                       ": so it can send " + per_patch + " times in total. That is known before any line is cast, so " +
                       "each time it sends its unshot power divided by " + per_patch + ", the forecast (G3), " +
                       "and with it all power that it holds: what it has received and reflected since it last sent "
                       "(M1).",
                   0, 0) +
           wrapped("Power flows where a line leaves one patch and arrives at another, which the columns 'leaves' and "
                   "'arrives at' of two successive rows show.",
                   0, 0);
}

/// The power that a patch sends, and its fate.
std::string transfer_text(const Scene& scene, const Transfer& transfer, const TracedSegment& traced)
{
    const bool received = Segment::is_patch(transfer.to);
    const std::string to = received ? patch_name(scene, transfer.to) : "nowhere";
    std::string text = wrapped(patch_name(scene, transfer.from) + " -> " + to, name_column, indent).substr(name_column);
    if (transfer.sent() == Rgb{})
        text += wrapped("sends nothing: it has no forecast and holds nothing", indent, indent);
    else
        text += wrapped("sends forecast " + colour_text(transfer.forecast) + " + held " + colour_text(transfer.held) +
                            " = " + watts(transfer.sent()) + (received ? "" : ", " + loss(transfer.to)),
                        indent, indent + 2);
    if (!received)
        return text + wrapped("then holds nothing", indent, indent);
    const bool forwards = transfer.to == traced.segment.to;
    return text +
           wrapped("patch " + std::to_string(transfer.to) + " reflects " + colour_text(scene.reflectance(transfer.to)) +
                       " of what arrives and then holds " + watts(forwards ? traced.to_holds : traced.from_holds),
                   indent, indent + 2);
}

std::string segment_text(const TracedRun& run, const GlobalLine& line, const TracedSegment& traced)
{
    const Scene& scene = run.scene;
    const std::size_t after = traced.after;
    const std::string begin = after == 0 ? "start" : std::to_string(after);
    const std::string end = after == line.crossings.size() ? "end" : std::to_string(after + 1);
    std::string text = "  " + begin + " - " + end;
    text.resize(std::max<std::size_t>(text.size() + 1, name_column), ' ');
    if (traced.transfers.empty())
        return text + "begins on a side without patches: nothing is sent along it\n";
    for (std::size_t k = 0; k < traced.transfers.size(); ++k)
        text += (k == 0 ? "" : std::string(name_column, ' ')) + transfer_text(scene, traced.transfers[k], traced);
    if (!run.options.bidirectional && traced.segment.joins_patches())
        text += wrapped("patch " + std::to_string(traced.segment.from) + " then holds " + watts(traced.from_holds),
                        indent, indent + 2);
    return text;
}

std::string line_text(const TracedRun& run, const GlobalLine& line, std::uint64_t of)
{
    const bool box = chords_of(run.options) == Chords::box;
    std::string text = title("line", line.origin, of) + "  from " + point_text(line.from) + " to " +
                       point_text(line.to) + (box ? ", both just outside the box\n" : " on the sphere\n");
    if (line.from == line.to)
        return text + "  the two points are equal: a chord of length 0, which is counted as cast and meets nothing\n";
    if (line.crossings.empty())
        return text + "  meets nothing: it is cast, as (G1) counts it, but carries no power\n";
    text += crossings_table(run.scene, line.crossings);
    if (line.segments.empty())
        return text + "  the line meets only sides without patches: it carries no power\n";
    for (const TracedSegment& traced : line.segments)
        text += segment_text(run, line, traced);
    return text;
}

std::string parallel_line_text(const TracedRun& run, const GlobalLine& line, std::uint64_t of)
{
    std::string text =
        title("line", line.origin, of) + "  from " + point_text(line.from) + " to " + point_text(line.to) + "\n";
    if (line.crossings.empty())
        return text + "  meets nothing\n";
    text += crossings_table(run.scene, line.crossings);
    for (const TracedSegment& traced : line.segments)
        for (const Transfer& transfer : traced.transfers)
            text += wrapped(patch_name(run.scene, transfer.from) + " sends " + watts(transfer.sent()) +
                                (Segment::is_patch(transfer.to) ? " to " + patch_name(run.scene, transfer.to)
                                                                : ", " + loss(transfer.to)),
                            2, 4);
    return text;
}

std::string ray_text(const Scene& scene, const ShotRay& ray, std::uint64_t of)
{
    std::string text = title("ray", ray.origin, of) +
                       wrapped("leaves " + patch_name(scene, ray.shooter) + " at " + point_text(ray.ray.origin) +
                                   " in direction " + point_text(ray.ray.direction) + " with " + watts(ray.power),
                               2, 4);
    if (ray.crossing)
        text += crossings_table(scene, {*ray.crossing});
    if (!Segment::is_patch(ray.where))
        return text + wrapped("carries " + watts(ray.power) + ", " + loss(ray.where), 2, 4);
    const Rgb rho = scene.reflectance(ray.where);
    return text + wrapped(patch_name(scene, ray.where) + " receives " + watts(ray.power) + " and reflects " +
                              colour_text(rho) + " of it: " + watts(rho * ray.power) + " more is unshot; it then has " +
                              watts(ray.unshot) + " unshot",
                          2, 4);
}

/// The two ends of a step, up to the patch where it arrives.
std::string step_ends(const Scene& scene, const TracedStep& traced, std::size_t number)
{
    return std::to_string(number) + "  " + point_text(traced.ray.origin) + " of " +
           patch_name(scene, traced.step.from) + " -> " +
           (traced.crossing ? point_text(traced.crossing->point) + " of " : "");
}

/// The decision at the end of a step: `survivor` is what goes on if the path does not end.
std::string survival_text(const Scene& scene, const ParticleStep& step, const std::string& survivor)
{
    const double survival = mean(scene.reflectance(step.where));
    return step.ends()
               ? format("; the number drawn, %.3f, is not below the reflectance, %.3g: it ends", step.drawn, survival)
               : format("; the number drawn, %.3f, is below the reflectance, %.3g: it goes on", step.drawn, survival) +
                     survivor;
}

std::string step_text(const Scene& scene, const TracedStep& traced, std::size_t number)
{
    const ParticleStep& step = traced.step;
    std::string text = step_ends(scene, traced, number);
    if (!Segment::is_patch(step.where))
        text += "nothing: " + watts(step.power) + ", " + loss(step.where);
    else
        text += patch_name(scene, step.where) + ": brings " + watts(step.power) + ", scored " + watts(traced.counted) +
                survival_text(scene, step, " with " + watts(step.goes_on));
    return wrapped(text, 2, 5);
}

/// A step of a gathering walk from the patch `receiver`.
std::string walk_step_text(const Scene& scene, const TracedStep& traced, std::size_t number, std::uint32_t receiver)
{
    const ParticleStep& step = traced.step;
    std::string text = step_ends(scene, traced, number);
    if (!Segment::is_patch(step.where))
        text += std::string("nothing: the walk ends ") +
                (step.where == Segment::behind ? "at the back of a surface, where no patch is" : "outside the scene");
    else
        text += patch_name(scene, step.where) +
                (traced.counted == Rgb{} ? ": adds nothing"
                                         : ": adds " + colour_text(traced.counted) + tied +
                                               "W/m^2 to the irradiance of " + "patch " + std::to_string(receiver)) +
                survival_text(scene, step, "");
    return wrapped(text, 2, 5);
}

std::string iteration_ray_text(const Scene& scene, const JacobiRay& ray, std::uint64_t of)
{
    const IterationRay& carried = ray.carried;
    std::string text = title("ray", ray.origin, of) +
                       wrapped("leaves " + patch_name(scene, carried.from) + " at " + point_text(ray.ray.origin) +
                                   " in direction " + point_text(ray.ray.direction),
                               2, 4);
    if (ray.crossing)
        text += crossings_table(scene, {*ray.crossing});
    const bool received = Segment::is_patch(carried.to);
    text += wrapped(patch_name(scene, carried.from) + ", which " + format("%.4g", carried.from_density) +
                        " rays per m^2 leave, sends " + watts(carried.sent) +
                        (received ? " to " + patch_name(scene, carried.to) : ", " + loss(carried.to)),
                    2, 4);
    if (carried.to_density > 0.0)
        text += wrapped(patch_name(scene, carried.to) + ", which " + format("%.4g", carried.to_density) +
                            " rays per m^2 leave, sends " + watts(carried.returned) + " back",
                        2, 4);
    return text;
}

} // namespace

std::string wrapped(const std::string& text, std::size_t first, std::size_t others)
{
    std::string result = std::string(first, ' ') + wrapped_text(text, first, others, text_width);
    std::replace(result.begin(), result.end(), tied, ' ');
    return result;
}

std::string watts(Rgb power)
{
    return colour_text(power) + tied + "W";
}

std::string surface_name(const Scene& scene, std::uint32_t surface)
{
    const SceneFile& file = scene.file();
    const std::string& group = file.groups[file.group[surface]];
    return (group.empty() ? file.materials[file.material[surface]].name : group) + " (line " +
           std::to_string(file.line[surface]) + ")";
}

std::string patch_name(const Scene& scene, std::uint32_t patch)
{
    return "patch " + std::to_string(patch) + " of " + surface_name(scene, scene.surface_of(patch)) +
           (scene.is_front(patch) ? "" : ", its back");
}

std::string trace_text(const TracedRun& run, const GlobalTrace& trace)
{
    std::string text = heading(run, "Global pass") + global_context(run, trace);
    for (const GlobalLine& line : trace.lines)
        text += line_text(run, line, trace.lines_cast);
    return text;
}

std::string trace_text(const TracedRun& run, const BundleTrace& trace)
{
    std::string text = heading(run, "First direction");
    text +=
        wrapped("Before it the first shot took " + counted(trace.shot_lines, "ray", "rays") +
                    ". The power that patches reflected from them is unshot, and " +
                    counted(trace.rays, "ray", "rays") +
                    " from patch to patch gave a first estimate of all light that it brings. The iterations improve "
                    "it: in the first one " +
                    counted(trace.lines_to_meet, "parallel line meets", "parallel lines meet") +
                    " the scene's box along each of " + counted(trace.directions, "direction", "directions") + ".",
                0, 0) +
        wrapped("This direction is " + point_text(trace.direction) +
                    ". Through the smallest rectangle that hides the box " +
                    counted(trace.lines_cast, "line is", "lines are") + " cast; each stands for" +
                    format(" %.4g%cm^2 of it. ", trace.section, tied) +
                    "Along a line that joins two patches, each sends the other its radiosity times twice that, over "
                    "the number of directions (P1).",
                0, 0);
    for (const GlobalLine& line : trace.lines)
        text += parallel_line_text(run, line, trace.lines_cast);
    return text;
}

std::string trace_text(const TracedRun& run, const ShotTrace& trace)
{
    const ShotPass& pass = trace.shot_passes[trace.pass];
    const std::string stage =
        trace.pass == 0 ? "First shot, pass 1" : "Extended first shot, pass " + std::to_string(trace.pass + 1);
    std::string text = heading(run, stage + " of " + std::to_string(trace.shot_passes.size()) + ",");
    text += wrapped("A patch whose unshot radiosity exceeds the threshold" +
                        format(", %.4g W/m^2 (4), shoots the excess. ", trace.threshold) + "In this pass " +
                        counted(trace.shooters, "patch shoots", "patches shoot") + format(" %.4g W with ", pass.power) +
                        counted(pass.lines, "ray", "rays") +
                        ", one after the other. A ray takes one item of four numbers: two for a uniform point of the "
                        "patch, two for a direction that favours the normal by the cosine, as diffuse light does. "
                        "Where it arrives its power is added to what has arrived, and the reflected part is unshot "
                        "until a later pass or the global lines send it on (S1).",
                    0, 0);
    for (const ShotRay& ray : trace.rays)
        text += ray_text(run.scene, ray, pass.lines);
    return text;
}

std::string trace_text(const TracedRun& run, const ParticleTrace& trace)
{
    const bool collision = run.options.estimator == Estimator::collision;
    std::string text = heading(run, "Local Monte Carlo");
    text += wrapped(
        "The sources, " + counted(trace.sources, "patch", "patches") + ", send " +
            counted(trace.particle_count, "particle", "particles") +
            " of equal power, as many as use up the lines of the run in expectation: every segment of a path counts as "
            "a line. At every patch that it meets a particle draws a number. If it is below the patch's reflectance, "
            "the particle is reflected and goes on from a uniform point of the patch, otherwise it is absorbed. " +
            (collision ? "Wherever it arrives, its power is scored as arrived (L1)."
                       : "Only where it is absorbed it is scored, with its power over 1 - reflectance (L1)."),
        0, 0);
    for (const TracedParticle& particle : trace.particles) {
        text += title("particle", particle.origin, trace.particle_count);
        for (std::size_t k = 0; k < particle.steps.size(); ++k)
            text += step_text(run.scene, particle.steps[k], k + 1);
    }
    return text;
}

std::string trace_text(const TracedRun& run, const WalkTrace& trace)
{
    const bool collision = run.options.estimator == Estimator::collision;
    std::string text = heading(run, "Gathering random walks");
    text += wrapped(
        "The walks start at the patches whose light is wanted, in proportion to the square root of their area, " +
            counted(trace.walk_count, "walk", "walks") +
            " in the first round; the result is the mean of all rounds. At every patch that it meets a walk draws a "
            "number. If it is below the patch's reflectance, the walk goes on from a uniform point of the patch, "
            "otherwise it ends. " +
            (collision ? "Wherever it arrives, the emittance there, over the number of walks of the first patch, is "
                         "added to the irradiance of the first patch (W1)."
                       : "Where it ends, the emittance there over 1 - reflectance, and over the number of walks of the "
                         "first patch, is added to the irradiance of the first patch (W1)."),
        0, 0);
    for (const TracedParticle& walk : trace.walks) {
        text += title("walk", walk.origin, trace.walk_count);
        for (std::size_t k = 0; k < walk.steps.size(); ++k)
            text += walk_step_text(run.scene, walk.steps[k], k + 1, walk.steps.front().step.from);
    }
    return text;
}

std::string trace_text(const TracedRun& run, const JacobiTrace& trace)
{
    std::string text = heading(run, "First iteration");
    text += wrapped("Before it, a Neumann series of " + counted(trace.series_rays, "ray", "rays") +
                        " gave a first estimate of all light. Each iteration improves it: every patch sends all its "
                        "power, emitted and reflected, by rays in proportion to it, in the first one " +
                        counted(trace.ray_count, "ray", "rays") + ", numbered in the order of the patches. ",
                    0, 0) +
            (run.options.bidirectional
                 ? wrapped("A ray between two patches carries power both ways. If d rays per m^2 leave the one and e "
                           "the other, each patch sends its radiosity over d + e along every ray between them, "
                           "whichever patch the ray leaves (J2).",
                           0, 0)
                 : wrapped("If d rays per m^2 leave a patch, it sends its radiosity over d along each of them (J1).", 0,
                           0));
    for (const JacobiRay& ray : trace.rays)
        text += iteration_ray_text(run.scene, ray, trace.ray_count);
    return text;
}

} // namespace multipath
