#include "exam/surface_questions.h"

#include "parallel/ordered_blocks.h"
#include "radiosity/line_budget.h"
#include "scene/text_format.h"
#include "transport/lines/global_lines.h"
#include "transport/lines/line_segments.h"
#include "transport/lines/local_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace multipath {

namespace {

constexpr std::size_t most_surfaces = 4;
constexpr const char* plain_sequence = "random";

/// The largest surfaces of a scene, and what a run found about the light between their fronts.
struct Largest
{
    std::vector<std::uint32_t> surfaces;

    explicit Largest(const Scene& scene) : surfaces(scene.surfaces().size())
    {
        std::iota(surfaces.begin(), surfaces.end(), 0u);
        const auto larger = [&](std::uint32_t a, std::uint32_t b) {
            return scene.surfaces()[a].area() > scene.surfaces()[b].area();
        };
        std::stable_sort(surfaces.begin(), surfaces.end(), larger);
        surfaces.resize(std::min(surfaces.size(), most_surfaces));
    }
    /// Place of the surface whose front this end of a segment is; most_surfaces if of none of them.
    std::size_t place(const Scene& scene, std::uint32_t end) const
    {
        if (!Segment::is_patch(end) || !scene.is_front(end))
            return most_surfaces;
        const auto found = std::find(surfaces.begin(), surfaces.end(), scene.surface_of(end));
        return found == surfaces.end() ? most_surfaces : static_cast<std::size_t>(found - surfaces.begin());
    }
};

using Samples = std::vector<double>;

/// One sample per run. A F [m^2] is known from one surface to another by place; the last place is that of all others.
struct Measured
{
    std::array<std::array<Samples, most_surfaces + 1>, most_surfaces> exchange;
    std::array<Samples, most_surfaces> leaving; ///< [m^2] area, from the lines that leave the front
    std::array<Samples, most_surfaces> caught;  ///< [1] share of them that meets patches
    Samples per_hull_line;                      ///< crossings
};

/// Lines, each worth so much area, seen from the surfaces.
struct Counts
{
    std::array<std::array<double, most_surfaces + 1>, most_surfaces> joined{};
    std::array<double, most_surfaces> leaving{};
    std::array<double, most_surfaces> caught{};
    double crossings = 0.0;
    double into_hull = 0.0;

    void add(std::size_t from, std::size_t to, bool to_patch)
    {
        leaving[from] += 1.0;
        caught[from] += to_patch ? 1.0 : 0.0;
        joined[from][to] += 1.0;
    }
};

void note(const Counts& counts, std::size_t from, double worth, Measured& measured)
{
    for (std::size_t to = 0; to <= most_surfaces; ++to)
        measured.exchange[from][to].push_back(worth * counts.joined[from][to]);
    measured.leaving[from].push_back(worth * counts.leaving[from]);
    measured.caught[from].push_back(counts.caught[from] / std::max(1.0, counts.leaving[from]));
}

/// What a run with this number finds, for all runs.
template <class Result, class Find>
std::vector<Result> for_all_runs(const ExamSettings& settings, const Find& find)
{
    const std::vector<ExamRun> runs = exam_runs(settings, plain_sequence);
    std::vector<Result> results(runs.size());
    parallel_blocks(runs.size(), settings.threads, [&](std::uint64_t number) {
        const auto place = static_cast<std::size_t>(number);
        results[place] = find(runs[place]);
    });
    return results;
}

Measured by_rays(const Scene& scene, const Largest& largest, const ExamSettings& settings)
{
    Measured measured;
    for (std::size_t from = 0; from < largest.surfaces.size(); ++from) {
        const std::uint32_t surface = largest.surfaces[from];
        const Surface& shape = scene.surfaces()[surface];
        const LocalRays rays({surface, shape});
        const auto cast = [&](const ExamRun& run) {
            const auto items = items_of_rays(make_sequence(plain_sequence, run.seed + from), settings.broken);
            Counts counts;
            for (std::uint64_t n = 0; n < settings.lines; ++n) {
                const std::uint32_t end = receiver(scene, surface, rays.line(items->item(n)));
                counts.add(from, largest.place(scene, end), Segment::is_patch(end));
            }
            return counts;
        };
        for (const Counts& counts : for_all_runs<Counts>(settings, cast))
            note(counts, from, shape.area() / static_cast<double>(settings.lines), measured);
    }
    return measured;
}

void count_segment(const Scene& scene, const Largest& largest, std::uint32_t from, std::uint32_t to, Counts& counts)
{
    const std::size_t place = largest.place(scene, from);
    if (place < most_surfaces)
        counts.add(place, largest.place(scene, to), Segment::is_patch(to));
}

Counts cast_lines(const Scene& scene, const Largest& largest, const GlobalLines& global_lines, const ConvexHull& hull,
                  const Sequence& items, std::uint64_t lines)
{
    Counts counts;
    std::vector<Hit> hits;
    std::vector<Segment> segments;
    for (std::uint64_t n = 0; n < lines; ++n) {
        const Line line = global_lines.line(items.item(n));
        scene.intersector().all_hits(line, hits);
        counts.crossings += static_cast<double>(hits.size());
        counts.into_hull += hull.meets(line) ? 1.0 : 0.0;
        segments.clear();
        append_segments(scene, hits, segments);
        for (const Segment& segment : segments) {
            count_segment(scene, largest, segment.from, segment.to, counts);
            count_segment(scene, largest, segment.to, segment.from, counts);
        }
    }
    return counts;
}

Measured by_lines(const Scene& scene, const Largest& largest, const ExamSettings& settings)
{
    const GlobalLines global_lines(scene.bounds());
    const ConvexHull hull = scene_hull(scene);
    const std::uint64_t lines = global_lines.lines_to_cast(settings.lines);
    const double worth = 0.5 * global_lines.sphere_area() / static_cast<double>(lines); // (G1)
    Measured measured;
    for (const Counts& counts : for_all_runs<Counts>(settings, [&](const ExamRun& run) {
             const auto items = items_of_lines(make_sequence(plain_sequence, run.seed), settings.broken);
             return cast_lines(scene, largest, global_lines, hull, *items, lines);
         })) {
        for (std::size_t from = 0; from < largest.surfaces.size(); ++from)
            note(counts, from, worth, measured);
        measured.per_hull_line.push_back(counts.into_hull > 0.0 ? counts.crossings / counts.into_hull : 0.0);
    }
    return measured;
}

std::string name_of(const Scene& scene, std::uint32_t surface)
{
    return format("%u", static_cast<unsigned>(scene.file().line[surface]));
}

/// [m^2] What must not go unnoticed: a twentieth of the surface, but not less than the lines can tell.
double resolution_of(const Scene& scene, std::uint32_t surface)
{
    return std::max(0.05 * scene.surfaces()[surface].area(), 1e-3 * scene.total_area());
}

/// `unit`: what the quantity cannot exceed.
ExamRow surface_row(const std::string& topic, const std::string& method, const std::string& quantity, double unit,
                    double resolution)
{
    ExamRow row = {topic, method, plain_sequence, quantity};
    row.allowance = 1e-6 * unit;
    row.resolution = resolution;
    return row;
}

/// The exchange of two surfaces by rays from either (reciprocity) and by lines; nothing if they see nothing of each
/// other.
std::vector<ExamRow> compare_exchange(const Scene& scene, const Largest& largest, std::size_t a, std::size_t b,
                                      const Measured& rays, const Measured& lines)
{
    const std::uint32_t smaller = largest.surfaces[std::max(a, b)];
    const std::string quantity =
        "A F of lines " + name_of(scene, largest.surfaces[a]) + ", " + name_of(scene, largest.surfaces[b]) + " [m^2]";
    const auto row = [&](const std::string& topic, const std::string& method, const Samples& samples) {
        const double area = scene.surfaces()[smaller].area();
        return measured_by(surface_row(topic, method, quantity, area, resolution_of(scene, smaller)), samples);
    };
    const ExamRow there = row("reciprocity", "rays", rays.exchange[a][b]);
    const ExamRow back = row("reciprocity", "rays", rays.exchange[b][a]);
    const ExamRow along = row("rays, lines", "lines", lines.exchange[a][b]);
    if (there.measured == 0.0 && back.measured == 0.0 && along.measured == 0.0)
        return {};
    return {compared_with(back, there), compared_with(along, back)};
}

/// n_int of the convex hull (G2), which of a flat scene no line meets.
std::vector<ExamRow> hull_crossings(const Scene& scene, const Measured& lines)
{
    if (lines.per_hull_line.front() == 0.0)
        return {};
    const double expected = intersections_of_hull_line(scene);
    ExamRow row = surface_row("crossings", "lines", "n_int = 2 A_T / A_hull [1]", expected, 0.05 * expected);
    row.expected = expected;
    return {measured_by(row, lines.per_hull_line)};
}

/// The area that the lines see (G1), and how much of the light finds a patch.
std::vector<ExamRow> one_surface(const Scene& scene, const Largest& largest, std::size_t k, const Measured& rays,
                                 const Measured& lines)
{
    const std::uint32_t surface = largest.surfaces[k];
    const double area = scene.surfaces()[surface].area();
    const double resolution = resolution_of(scene, surface);
    const std::string name = name_of(scene, surface);
    ExamRow seen = surface_row("crossings", "lines", "area of line " + name + " [m^2]", area, resolution);
    seen.expected = area;
    const ExamRow caught = surface_row("row sum", "lines", "sum F of line " + name + " [1]", 1.0, resolution / area);
    return {measured_by(seen, lines.leaving[k]),
            compared_with(measured_by(caught, lines.caught[k]), measured_by(caught, rays.caught[k]))};
}

std::vector<ExamRow> examine_surfaces(const Scene& scene, const ExamSettings& settings)
{
    const Largest largest(scene);
    const Measured rays = by_rays(scene, largest, settings);
    const Measured lines = by_lines(scene, largest, settings);
    std::vector<ExamRow> rows = hull_crossings(scene, lines);
    const auto append = [&](const std::vector<ExamRow>& more) { rows.insert(rows.end(), more.begin(), more.end()); };
    for (std::size_t a = 0; a < largest.surfaces.size(); ++a)
        append(one_surface(scene, largest, a, rays, lines));
    for (std::size_t a = 0; a < largest.surfaces.size(); ++a)
        for (std::size_t b = a + 1; b < largest.surfaces.size(); ++b)
            append(compare_exchange(scene, largest, a, b, rays, lines));
    return rows;
}

} // namespace

std::vector<ExamTask> surface_tasks(const Scene& scene, const ExamSettings& settings)
{
    return {{"surfaces", [&scene, settings] { return examine_surfaces(scene, settings); }}};
}

} // namespace multipath
