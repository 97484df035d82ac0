// The command `solve` up to the run itself: reads the options, opens the outputs, reads the scene, refines its patches,
// and prepares the state from which the run may resume. As much as possible is refused before the long work begins.
// solve_job.cpp solves and writes the outputs.

#include "base/errors.h"
#include "base/lists.h"
#include "base/text_format.h"
#include "cli/files/interrupt.h"
#include "cli/files/standard_streams.h"
#include "cli/progress.h"
#include "commands/commands.h"
#include "commands/options/memory_limit.h"
#include "commands/options/method_options.h"
#include "commands/options/scene_options.h"
#include "commands/solve/formats.h"
#include "commands/solve/solve_job.h"
#include "image/camera.h"
#include "radiosity/family/importance.h"
#include "refinement/adaptive_patches.h"
#include "refinement/patch_tolerance.h"
#include "refinement/shown_error.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace multipath {

namespace {

void print_what_was_read(const SceneFile& file)
{
    for (const std::string& warning : file.warnings)
        print_note(warning + "\n");
    print_note(format("%s: %s\n", file.path.c_str(), file.counts.c_str()));
}

void require_one_on_standard_output(const CommandLine& line)
{
    if (line.has("json") && is_among("-", line.all("output")))
        throw UsageError("--json and --output - would both write to standard output; expected a file for one of them");
}

/// Throws UsageError for a shard with replicates, with more shards than lines, or without a state to merge. A shard of
/// `reuse` holds counts that mean nothing by themselves, so its only outputs are states; a shard of another method is
/// an independent run.
void require_valid_shard(const CommandLine& line, const SolveJob& job, const StateOptions& state)
{
    if (state.shard.of == 1)
        return;
    if (job.accuracy.replicates > 1)
        throw UsageError("--shard: shards of replicates cannot be added up; expected no --replicates, --tolerance or "
                         "--time with it");
    if (job.options.lines < state.shard.of)
        throw UsageError("--shard: more shards than lines; expected at most " + std::to_string(job.options.lines));
    const std::vector<std::string> outputs = line.all("output");
    const auto is_state = [](const std::string& path) { return kind_of(path) == FormatKind::state; };
    if (state.path.empty() && std::none_of(outputs.begin(), outputs.end(), is_state))
        throw UsageError("--shard: nothing would be left to merge; expected --state FILE with it");
    if (job.options.method->shards == Shards::added && !std::all_of(outputs.begin(), outputs.end(), is_state))
        throw UsageError("--shard: a shard of 'reuse' has no result of its own; expected no outputs but states");
}

std::vector<std::string> output_paths(const CommandLine& line, const StateOptions& state)
{
    if (line.has("output"))
        return line.all("output");
    return state.shard.of > 1 ? std::vector<std::string>{} : default_outputs(line.operands()[0]);
}

/// Lets the run resume from a saved state. Throws InputError for the state of another run.
void resume(const StateOptions& state, const RunDescription& wanted, const SolveJob& job, StateKeeper& keeper)
{
    SavedRun saved = read_saved_run(state.from);
    const bool whole = state.from != state.path && saved.description.shard.of == 1; // merged, to be split again
    if (whole)
        saved.description.shard = wanted.shard;
    require_same_run(saved.description, state.from, wanted);
    if (!job.quiet)
        print_note("resuming from " + state.from + "\n");
    keeper.resume(std::move(saved));
}

/// The scene with the adaptive patches that the options ask for, if any.
Scene with_adaptive_patches(SolveJob& job, Scene coarse)
{
    const std::uint64_t most = adaptive_patches(job.line, coarse.surfaces());
    if (most == 0)
        return coarse;
    if (job.line.has("adaptive") && coarse.patch_count() >= most)
        throw InputError(coarse.path() + ": --adaptive: has " + grouped(coarse.patch_count()) +
                         " patches before any is cut; expected more than that");
    require_memory_for_reuse(job.line, job.options, coarse);
    require_memory_for_patches(job.line, coarse.file(), static_cast<double>(most));
    Progress progress("choosing patches", progress_style(job.line));
    return adaptively_refined(coarse, most, job.options.memory, job.options.threads, std::ref(progress));
}

/// With replicates, estimates the error that the patches cause, which is reported beside the noise. With a tolerance,
/// cuts the patches until they cause no more than their part of it, unless options fix the patches.
Scene with_patches_for_tolerance(SolveJob& job, const Scene& scene)
{
    if (job.accuracy.replicates < 2)
        return scene;
    const CommandLine& line = job.line;
    const double wanted = job.accuracy.patch_tolerance();
    const double memory = job.options.memory;
    const int threads = job.options.threads;
    std::optional<Progress> progress(std::in_place, "measuring patches", progress_style(line));
    const auto show = [&](double done) { (*progress)(done); };
    if (!job.accuracy.tolerance || line.has("adaptive") || line.has("patches") || line.has("patch-size")) {
        job.accuracy.patch_error = patch_error(scene, wanted, memory, threads, show).root_upper_bound();
        return scene;
    }
    bool cutting = false;
    const auto before_cut = [&](double patches) {
        require_memory_for_patches(line, scene.file(), patches);
        progress.emplace("choosing " + grouped(static_cast<std::uint64_t>(patches)) + " patches", progress_style(line));
        cutting = true;
        watch_interrupts();
    };
    const auto show_until_enough = [&](double done) {
        constexpr double share_of_patches = 0.5; // of the time
        const bool is_late =
            job.accuracy.seconds && job.seconds_since_start() > share_of_patches * *job.accuracy.seconds;
        if (cutting && (is_late || interrupted()))
            throw EnoughPatches{};
        show(done);
    };
    RefinedScene refined = refined_to_error(scene, wanted, before_cut, memory, threads, show_until_enough);
    progress.reset();
    if (interrupted() && !job.quiet)
        print_note("interrupted; goes on with " + grouped(refined.scene.patch_count()) + " patches\n");
    end_at_interrupts();
    job.accuracy.patch_error = refined.error;
    return std::move(refined.scene);
}

/// Adds the weights of the patches that one camera sees: the number of their pixels over their area.
void add_view(const Scene& scene, const Camera& camera, double aspect, std::vector<double>& weight)
{
    constexpr int rows = 256;
    const int columns = std::clamp(static_cast<int>(aspect * rows), 1, 4096);
    for (const std::optional<Hit>& hit : visible_hits(scene, PixelRays(camera, columns, rows), 1)) {
        if (!hit)
            continue;
        const std::uint32_t patch = scene.patch_at(hit->surface, hit->u, hit->v, hit->front);
        if (patch != Scene::no_patch)
            weight[patch] += 1.0 / scene.area(patch);
    }
}

std::vector<double> weight_of_views(const Scene& scene, const PictureOptions& pictures)
{
    if (!pictures.views.front().eye || !pictures.views.front().target)
        throw UsageError("--important view: the view must be known before the run; expected --eye and --target, or "
                         "--camera");
    std::vector<double> weight(scene.patch_count());
    const double aspect = static_cast<double>(pictures.render.width) / pictures.render.height;
    for (const View& view : pictures.views)
        add_view(scene, camera_for(scene, pictures, view), aspect, weight);
    return weight;
}

std::vector<double> weight_of_named(const Scene& scene, const std::string& name)
{
    const SceneFile& file = scene.file();
    std::vector<double> weight(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const std::uint32_t surface = scene.surface_of(i);
        if (!scene.is_sky(surface) && (file.is_named(surface, name) || scene.material_of(i).name == name))
            weight[i] = 1.0;
    }
    if (!is_among(1.0, weight))
        throw InputError(scene.path() + ": --important: no object or material is called '" + name +
                         "'; 'multipath check' lists them");
    return weight;
}

/// The importance that --important asks for. Patches of an object or material of this name have the weight 1; for
/// "view" the user's cameras determine it: pixels over area, relative to the largest. Throws UsageError for "view"
/// without a camera of the user, and InputError for a name that the scene does not have or whose patches reflect
/// nothing.
std::shared_ptr<const Importance> important_patches(const Scene& scene, const std::string& what,
                                                    const PictureOptions& pictures)
{
    if (what.empty())
        throw UsageError("--important: expected the name of an object or a material, or view");
    Importance importance;
    importance.weight = what == "view" ? weight_of_views(scene, pictures) : weight_of_named(scene, what);
    double largest = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        largest = std::max(largest, mean(scene.reflectance(i)) > 0.0 ? importance.weight[i] : 0.0);
    if (!(largest > 0.0))
        throw InputError(scene.path() + ": --important " + what + ": nothing there reflects light");
    for (double& weight : importance.weight)
        weight /= largest;
    return std::make_shared<const Importance>(std::move(importance));
}

int run_solve(const CommandLine& line)
{
    require_one_on_standard_output(line);
    SolveJob job = read_solve_job(line);
    const StateOptions state = read_state_options(line);
    require_valid_shard(line, job, state);
    const std::vector<std::string> inputs =
        concatenated({{scene_path(line)}, line.all("state"), line.all("from-state"), line.all("camera")});
    std::vector<PlannedOutput> outputs = open_solution_outputs(line, output_paths(line, state), inputs, job.pictures);

    Scene coarse = read_scene(line, thread_count(line));
    require_no_input(outputs, input_files(coarse.file()));
    const Scene scene = with_patches_for_tolerance(job, with_adaptive_patches(job, std::move(coarse)));
    if (job.accuracy.seconds)
        *job.accuracy.seconds -= job.seconds_since_start();
    settle_lines(scene, job.line, job.options);
    if (line.has("important"))
        job.options.importance = important_patches(scene, line.text("important"), job.pictures);
    require_results_possible(job, scene, outputs);
    require_memory_for_reuse(job.line, job.options, scene);
    if (!job.quiet)
        print_what_was_read(scene.file());
    const RunDescription description = description_of(job.line, scene, state.shard);
    StateKeeper keeper(state, has_kind(outputs, FormatKind::state), description);
    if (!state.from.empty())
        resume(state, description, job, keeper);
    return carry_out(job, scene, outputs, keeper, state.shard);
}

} // namespace

Command solve_command()
{
    return {{"solve",
             "compute the radiosity of a scene, and write pictures, meshes and tables",
             {"SCENE.obj", 1, 1},
             {solution_output_group(), solve_method_group(), accuracy_option_group(), state_option_group(),
              scene_option_group(), picture_option_group()},
             "  multipath solve room.obj --lines 2^22 -o room.png -o room.csv -o room.html\n"},
            run_solve};
}

} // namespace multipath
