#include "exam/line_questions.h"

#include "exam/rectangle_exchange.h"
#include "scene/scene_builder.h"
#include "transport/exchange/pair_counts.h"
#include "transport/lines/line_segments.h"
#include "transport/lines/local_rays.h"

#include <array>
#include <memory>

namespace multipath {

namespace {

constexpr double pi = 0.5 * two_pi;
constexpr double uncut = 1e3;             ///< patch size [m] above any edge
constexpr double finest_line_miss = 0.05; ///< [1]

/// [m^2] A_0 of (G1): of the sphere around the scene's box, or of that box.
double area_of_starts(const Scene& scene, Chords chords)
{
    const double diameter = scene.bounds().diagonal();
    return chords == Chords::sphere ? pi * diameter * diameter : scene.bounds().area();
}

const char* method_name(Chords chords)
{
    return chords == Chords::sphere ? "chords" : "box lines";
}

std::unique_ptr<Sequence> line_items(const std::string& sequence, const ExamRun& run, const ExamSettings& settings)
{
    const Pairing pairing =
        settings.broken == BrokenLaw::pairing ? Pairing::two_dimensional : Pairing::four_dimensional;
    return items_of_lines(make_line_sequence(sequence, run.seed, pairing), settings.broken);
}

/// A closed room of 1 x 2 x 3 m with a box of 0.5 x 0.8 x 1 m in the air.
Scene room_with_box()
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.5, 1.0);
    builder.room({0, 0, 0}, {1, 2, 3}, wall).box({0.2, 0.6, 0.5}, {0.7, 1.4, 1.5}, wall);
    return builder.scene(uncut);
}
constexpr double room_area = 22.0;
constexpr double room_volume = 6.0;
constexpr double box_area = 3.4;
constexpr std::uint32_t first_surface_of_box = 6;

/// What global lines met in the room with the box.
struct Tally
{
    double lines = 0.0;
    double into_room = 0.0;
    double into_box = 0.0;
    double crossings = 0.0;
    double of_floor = 0.0;
    double within_room = 0.0; ///< [m] length
};

void count(const HitLists::List& hits, const Line& line, Tally& tally)
{
    ++tally.lines;
    if (hits.empty())
        return;
    ++tally.into_room;
    tally.crossings += static_cast<double>(hits.size());
    tally.within_room += (hits[hits.size() - 1].t - hits[0].t) * length(line.direction);
    bool meets_box = false;
    for (const Hit& hit : hits) {
        tally.of_floor += hit.surface == 0 ? 1.0 : 0.0;
        meets_box = meets_box || hit.surface >= first_surface_of_box;
    }
    tally.into_box += meets_box ? 1.0 : 0.0;
}

Tally cast(const Scene& scene, const GlobalLines& global_lines, const Sequence& sequence, std::uint64_t first_item,
           std::uint64_t lines)
{
    Tally tally;
    std::vector<Item> items(static_cast<std::size_t>(lines));
    sequence.generate(first_item, items);
    std::vector<Hit> hits;
    for (const Item& item : items) {
        const Line line = global_lines.line(item);
        scene.intersector().all_hits(line, hits);
        count(hits, line, tally);
    }
    return tally;
}

/// Crossings (G1); n_int = 2 A_T / A_hull (G2), the room being its own hull; of the lines that meet a convex body,
/// those that meet another one in it are as their areas (Santalo); the mean chord of a convex body is 4 V / A (Cauchy).
struct Law
{
    const char* quantity;
    double expected;
    double (*measure)(const Tally& tally);
};

std::vector<ExamRow> crossings(Chords chords, const ExamSettings& settings)
{
    const Scene scene = room_with_box();
    const GlobalLines global_lines(scene.bounds(), chords);
    const std::array<Law, 4> laws = {{{"crossings of the floor per line", 2.0 * 3.0 / area_of_starts(scene, chords),
                                       [](const Tally& t) { return t.of_floor / t.lines; }},
                                      {"n_int, crossings per line that meets", 2.0 * (room_area + box_area) / room_area,
                                       [](const Tally& t) { return t.crossings / t.into_room; }},
                                      {"share that also meets the box", box_area / room_area,
                                       [](const Tally& t) { return t.into_box / t.into_room; }},
                                      {"mean chord of the room [m]", 4.0 * room_volume / room_area,
                                       [](const Tally& t) { return t.within_room / t.into_room; }}}};
    std::vector<ExamRow> rows;
    for (const std::string& sequence : exam_sequences) {
        std::array<std::vector<double>, 4> samples;
        for (const ExamRun& run : exam_runs(settings, sequence)) {
            const Tally tally =
                cast(scene, global_lines, *line_items(sequence, run, settings), run.first_item, settings.lines);
            for (std::size_t k = 0; k < laws.size(); ++k)
                samples[k].push_back(laws[k].measure(tally));
        }
        for (std::size_t k = 0; k < laws.size(); ++k) {
            ExamRow row = {"lines", method_name(chords), sequence, laws[k].quantity, laws[k].expected};
            row.resolution = finest_line_miss * row.expected;
            rows.push_back(measured_by(row, samples[k]));
        }
    }
    return rows;
}

/// Two rectangles of unlike size in parallel planes, beside each other.
struct Pair
{
    Scene scene;
    double exchange; ///< [m^2] A F (Howell C-13)
};

Pair unlike_rectangles()
{
    SceneBuilder builder;
    const std::uint32_t black = builder.grey(0.0, 1.0);
    builder.rectangle({0.5, 0, 0}, {0, 0, 0.5}, {0.5, 0, 0}, black).rectangle({0, 0.4, 0}, {2, 0, 0}, {0, 0, 1}, black);
    return {builder.scene(uncut), parallel_rectangles({0.5, 1.0}, {0.0, 0.5}, {0.0, 2.0}, {0.0, 1.0}, 0.4)};
}

ExamRow exchange_row(const std::string& method, const std::string& sequence, const Pair& pair,
                     const std::vector<double>& samples)
{
    ExamRow row = {"pair", method, sequence, "A F [m^2]", pair.exchange};
    row.resolution = finest_line_miss * pair.exchange;
    return measured_by(row, samples);
}

/// A_i F_ij by global lines: those that join the two, each worth A_0 / 2 N (G1).
ExamRow exchange_by_lines(const Pair& pair, Chords chords, const std::string& sequence, const ExamSettings& settings)
{
    const GlobalLines global_lines(pair.scene.bounds(), chords);
    const double worth = 0.5 * area_of_starts(pair.scene, chords) / static_cast<double>(settings.lines);
    std::vector<double> samples;
    for (const ExamRun& run : exam_runs(settings, sequence)) {
        const PairCounts counts = count_pairs(pair.scene, global_lines, *line_items(sequence, run, settings),
                                              run.first_item, settings.lines, {1});
        samples.push_back(worth * counts.pairs.at(0, 1).joined);
    }
    return exchange_row(method_name(chords), sequence, pair, samples);
}

/// The rays of a run from one patch.
RayBlock rays_from(std::uint32_t patch, const std::string& sequence, const ExamRun& run, const ExamSettings& settings)
{
    const auto count = static_cast<std::size_t>(settings.lines);
    RayBlock block;
    block.patches.assign(count, patch);
    block.items.resize(count);
    items_of_rays(make_sequence(sequence, run.seed), settings.broken)->generate(run.first_item, block.items);
    return block;
}

/// A_i F_ij by rays from patch i: reciprocity says that both patches find the same.
ExamRow exchange_by_rays(const Pair& pair, std::uint32_t from, const std::string& sequence,
                         const ExamSettings& settings)
{
    std::vector<double> samples;
    for (const ExamRun& run : exam_runs(settings, sequence)) {
        RayBlock rays = rays_from(from, sequence, run, settings);
        rays.trace(pair.scene);
        double arrived = 0.0;
        for (const std::uint32_t receiver : rays.receivers)
            arrived += receiver == 1 - from ? 1.0 : 0.0;
        samples.push_back(pair.scene.area(from) * arrived / static_cast<double>(rays.receivers.size()));
    }
    return exchange_row(from == 0 ? "rays up" : "rays down", sequence, pair, samples);
}

/// Lambert: of rays with density cos / pi the mean cosine is 2 / 3.
ExamRow mean_cosine(const Pair& pair, const std::string& sequence, const ExamSettings& settings)
{
    const Vec3 normal = pair.scene.patch(0).shape.normal();
    std::vector<double> samples;
    for (const ExamRun& run : exam_runs(settings, sequence)) {
        const RayBlock rays = rays_from(0, sequence, run, settings);
        std::vector<Line> lines(rays.items.size());
        local_lines(pair.scene, rays.patches.data(), rays.items.data(), lines.size(), lines.data());
        double sum = 0.0;
        for (const Line& line : lines)
            sum += dot(line.direction, normal) / length(line.direction);
        samples.push_back(sum / static_cast<double>(lines.size()));
    }
    ExamRow row = {"pair", "rays", sequence, "mean cosine [1]", 2.0 / 3.0};
    row.resolution = finest_line_miss * row.expected;
    return measured_by(row, samples);
}

std::vector<ExamRow> exchanges(const ExamSettings& settings)
{
    const Pair pair = unlike_rectangles();
    std::vector<ExamRow> rows;
    for (const std::string& sequence : exam_sequences) {
        rows.push_back(exchange_by_rays(pair, 0, sequence, settings));
        rows.push_back(exchange_by_rays(pair, 1, sequence, settings));
        rows.push_back(exchange_by_lines(pair, Chords::sphere, sequence, settings));
        rows.push_back(exchange_by_lines(pair, Chords::box, sequence, settings));
        rows.push_back(mean_cosine(pair, sequence, settings));
    }
    return rows;
}

} // namespace

std::vector<ExamTask> line_tasks(const ExamSettings& settings)
{
    return {{"lines", [=] { return crossings(Chords::sphere, settings); }},
            {"lines", [=] { return crossings(Chords::box, settings); }},
            {"pair", [=] { return exchanges(settings); }}};
}

} // namespace multipath
