#include "exam/stage_questions.h"

#include "exam/known_scenes.h"
#include "radiosity/first_shot.h"
#include "radiosity/multipath.h"
#include "radiosity/solve_options.h"
#include "scene/scene_builder.h"

#include <memory>

namespace multipath {

namespace {

constexpr double uncut_faces = 1e3;        ///< patch size [m] above any edge
constexpr double finest_stage_miss = 0.05; ///< [1]
constexpr std::uint32_t floor_patch = 0;
constexpr std::uint32_t ceiling_patch = 1;
constexpr std::uint32_t wall_patch = 4;

Scene unit_cube(double reflectance, double floor_emittance, double emittance)
{
    SceneBuilder builder;
    const std::uint32_t floor = builder.grey(reflectance, floor_emittance);
    const std::uint32_t wall = builder.grey(reflectance, emittance);
    return builder.room({0, 0, 0}, {1, 1, 1}, {floor, wall, wall, wall, wall, wall}).scene(uncut_faces);
}

ExamRow stage_row(const std::string& stage, const std::string& sequence, const std::string& quantity, double expected)
{
    ExamRow row = {"stages", stage, sequence, quantity, expected};
    row.resolution = finest_stage_miss * expected;
    return row;
}

/// In a black cube whose floor shines with 1 W, the ceiling receives F of two facing squares, each wall a quarter of
/// the rest.
std::vector<ExamRow> first_shot(const ExamSettings& settings)
{
    const Scene scene = unit_cube(0.0, 1.0, 0.0);
    std::vector<ExamRow> rows;
    for (const std::string& name : exam_sequences) {
        std::vector<double> ceiling;
        std::vector<double> wall;
        for (const ExamRun& run : exam_runs(settings, name)) {
            const std::unique_ptr<Sequence> items = items_of_rays(make_sequence(name, run.seed), settings.broken);
            PowerState state(scene);
            const std::vector<Shot> shots = plan_first_shot(scene, state, 0.0, settings.lines);
            spend(scene, 0.0, shots, state);
            shoot(scene, *items, run.first_item, shots, {1}, state);
            ceiling.push_back(state.incident[ceiling_patch].g);
            wall.push_back(state.incident[wall_patch].g);
        }
        const double f = opposite_squares();
        rows.push_back(measured_by(stage_row("shot", name, "power at the ceiling [W]", f), ceiling));
        rows.push_back(measured_by(stage_row("shot", name, "power at a wall [W]", 0.25 * (1.0 - f)), wall));
    }
    return rows;
}

/// A furnace of emittance 1 and reflectance 1/2: B = 2 after a single global pass.
std::vector<ExamRow> global_pass(const ExamSettings& settings)
{
    constexpr double reflectance = 0.5;
    constexpr double expected = 1.0 / (1.0 - reflectance);
    const Scene scene = unit_cube(reflectance, 1.0, 1.0);
    const GlobalLines lines(scene.bounds());
    std::vector<ExamRow> rows;
    for (const std::string& name : exam_sequences) {
        std::vector<double> floor;
        std::vector<double> wall;
        double unshot = 0.0; // [W]
        for (const ExamRun& run : exam_runs(settings, name)) {
            const std::unique_ptr<Sequence> items = items_of_lines(make_sequence(name, run.seed), settings.broken);
            PowerState state(scene);
            const bool both_ways = settings.broken != BrokenLaw::bidirectional;
            const GlobalPass pass = {run.first_item, settings.lines, both_ways};
            const ShuffledOrder order = walking_order(*items, LineOrder::shuffled, pass.first_item, pass.lines_cast);
            cast_global_lines(scene, lines, order, pass, {1}, state);
            const std::vector<Rgb> found = radiosity(scene, state);
            floor.push_back(found[floor_patch].g);
            wall.push_back(found[wall_patch].g);
            unshot += power_balance(scene, state).unshot.g / settings.replicates;
        }
        ExamRow row = stage_row("global pass", name, "B of the floor [W/m^2]", expected);
        row.allowance = unshot * reflectance / (1.0 - reflectance) / scene.area(floor_patch);
        rows.push_back(measured_by(row, floor));
        row.quantity = "B of a wall [W/m^2]";
        rows.push_back(measured_by(row, wall));
    }
    return rows;
}

} // namespace

std::vector<ExamTask> stage_tasks(const ExamSettings& settings)
{
    return {{"stages", [=] { return first_shot(settings); }}, {"stages", [=] { return global_pass(settings); }}};
}

} // namespace multipath
