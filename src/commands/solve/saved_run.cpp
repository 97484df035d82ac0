// A state file begins with the description of its run: the settings that change the result, by the names of the
// options, the scene, and the shard. The names of the parts of the run that are in progress follow, and then the arrays
// of these parts (parallel/run_control.h). A resumed run must have the same description, except that lines, tolerance
// and time may differ. To resume, the program starts the run again, and every part restores the arrays that are stored
// under its name.

#include "commands/solve/saved_run.h"

#include "base/errors.h"
#include "base/file_bytes.h"
#include "base/text_format.h"
#include "cli/files/interrupt.h"
#include "cli/files/output_file.h"
#include "cli/options/number_text.h"
#include "cli/provenance.h"
#include "commands/commands.h"
#include "commands/options/method_options.h"
#include "commands/options/scene_options.h"
#include "commands/solve/accuracy.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

namespace multipath {

namespace {

constexpr std::string_view scene_key = "scene="; ///< no option has this name

/// The options of `solve` that change its result.
std::vector<Option> options_with_effect()
{
    std::vector<Option> options = all_options({solve_method_group(), accuracy_option_group(), scene_option_group()});
    const auto has_none = [](const Option& option) { return !is_recorded(option.name); };
    options.erase(std::remove_if(options.begin(), options.end(), has_none), options.end());
    return options;
}

/// Reads "3/16", the third of sixteen shards.
Shard read_shard(const std::string& text)
{
    const std::size_t slash = text.find('/');
    if (slash == std::string::npos)
        throw UsageError("--shard: expected I/N, such as 3/16, got '" + text + "'");
    const std::uint64_t of = read_count("--shard", text.substr(slash + 1), 1, 1000000);
    return {read_count("--shard", text.substr(0, slash), 1, of) - 1, of};
}

/// The option as a message quotes it, after a space: " --sequence halton", " no --two-sided".
std::string quoted_option(const Option& option, const CommandLine& line)
{
    std::string text;
    for (const std::string& value : line.all(option.name))
        text += option_text(option.name, value);
    if (!text.empty())
        return text;
    const std::string value = line.text(option.name);
    return value.empty() ? " no --" + std::string(option.name) : option_text(option.name, value);
}

} // namespace

OptionGroup state_option_group()
{
    return {"State",
            {{"state", 0, "FILE", "",
              "Save the state of the run in this file, regularly and at the end; see 'help states'."},
             {"save-every", 0, "TIME", "60s", "Interval between saves of the state."},
             {"resume", 0, "", "", "Resume from the --state file if it exists, perhaps with more --lines."},
             {"from-state", 0, "FILE", "", "Resume from the state in this file, which remains unchanged."},
             {"shard", 0, "I/N", "", "Do shard I of N of the work, 1/N ... N/N; 'multipath merge' adds them up."}}};
}

StateOptions read_state_options(const CommandLine& line)
{
    StateOptions options;
    options.path = line.text("state");
    // At most thirty years, so that the clock does not overflow.
    options.save_every = std::min(read_seconds("--save-every", line.text("save-every")), 1e9);
    if (line.has("shard"))
        options.shard = read_shard(line.text("shard"));
    if (line.has("state") && options.path.empty())
        throw UsageError("--state: the name is empty; expected a file");
    if (options.path.empty() && (line.has("resume") || line.has("save-every")))
        throw UsageError(std::string(line.has("resume") ? "--resume" : "--save-every") +
                         " has no effect without --state; expected --state FILE with it");
    std::error_code error;
    const bool left = !options.path.empty() && std::filesystem::exists(path_of(options.path), error);
    if (left && !line.has("resume"))
        throw InputError(options.path +
                         " exists; expected --resume with it to continue from there, or the name of a new file");
    options.from = left ? options.path : line.text("from-state");
    return options;
}

void RunDescription::visit(Archive& archive)
{
    archive.texts("settings", settings);
    archive.value<std::uint64_t>("share", shard);
    if (shard.of == 0 || shard.number >= shard.of)
        throw ArchiveError("the state is damaged: no such shard");
    const Archive::Inner inner(archive, "scene");
    scene.visit(archive);
}

RunDescription description_of(const CommandLine& line, const Scene& scene, Shard shard)
{
    std::vector<std::string> settings;
    for (const std::string& word : line.words(options_with_effect()))
        settings.push_back(word.substr(2)); // without the dashes
    settings.push_back(std::string(scene_key) + line.operands()[0]);
    return {settings, archived(scene), shard};
}

CommandLine command_line_of(const RunDescription& description, const std::vector<std::string>& more_words)
{
    std::vector<std::string> words = more_words;
    std::string file;
    for (const std::string& setting : description.settings)
        if (setting.compare(0, scene_key.size(), scene_key) == 0)
            file = setting.substr(scene_key.size());
        else
            words.push_back("--" + setting);
    words.insert(words.end(), {"--", file});
    return {solve_command().table, words};
}

void require_same_run(const RunDescription& saved, const std::string& path, const RunDescription& wanted)
{
    const CommandLine of_saved = command_line_of(saved, {});
    const CommandLine of_wanted = command_line_of(wanted, {});
    const auto refuse = [&](const std::string& difference) {
        throw InputError(path + ": the state of another run: " + difference +
                         "; expected the same options, or another file");
    };
    if (saved.shard.number != wanted.shard.number || saved.shard.of != wanted.shard.of)
        refuse("of another shard of the work");
    for (const Option& option : options_with_effect()) {
        const bool fixed = saved.shard.of > 1 || !option.may_change;
        const std::string before = quoted_option(option, of_saved);
        const std::string now = quoted_option(option, of_wanted);
        if (fixed && before != now)
            refuse("made with" + before + ", not with" + now);
    }
    if (saved.scene.hash == wanted.scene.hash)
        return;
    if (saved.scene.patches != wanted.scene.patches && saved.scene.file->surfaces == wanted.scene.file->surfaces)
        refuse("of " + grouped(saved.scene.patches) + " patches, not " + grouped(wanted.scene.patches));
    refuse("made with the scene " + saved.scene.file->path + " as it was then, not with the one given now");
}

SavedRun read_saved_run(std::unique_ptr<StateReader> arrays)
{
    SavedRun saved;
    saved.description.visit(*arrays);
    arrays->texts("parts", saved.parts);
    saved.arrays = std::move(arrays);
    return saved;
}

SavedRun read_saved_run(const std::string& path)
{
    return read_saved_run(std::make_unique<StateReader>(path));
}

Solution finished_solution(const SavedRun& saved, const Scene& scene)
{
    RunRecord record;
    const Archive::Inner inner(*saved.arrays, RunRecord::part);
    record.visit(*saved.arrays, scene.patch_count());
    if (record.pieces == 0)
        throw InputError(saved.name() + ": the run is not finished; expected 'multipath solve --state " + saved.name() +
                         " --resume' first");
    return std::move(record.solution);
}

StateKeeper::StateKeeper(StateOptions options, bool keep_last, RunDescription description)
    : options_(std::move(options)),
      keep_last_(keep_last),
      description_(std::move(description)),
      interval_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(options_.save_every))),
      next_save_(Clock::now() + interval_)
{
}

void StateKeeper::resume(SavedRun saved)
{
    resumed_ = std::move(saved);
    resume_from(*resumed_->arrays, resumed_->parts);
}

bool StateKeeper::wants_pause() const
{
    return interrupted() || (!options_.path.empty() && Clock::now() >= next_save_);
}

void StateKeeper::keep()
{
    if (path().empty() && !keep_last_)
        return;
    std::optional<OutputFile> file;
    if (!path().empty())
        file.emplace(path());
    last_bytes_.clear();
    StateWriter writer([&](std::string_view bytes) {
        if (file)
            file->write(bytes);
        if (keep_last_)
            last_bytes_ += bytes;
    });
    description_.visit(writer);
    std::vector<std::string> names = parts();
    writer.texts("parts", names);
    save(writer);
    writer.finish();
    if (file)
        file->commit();
}

bool StateKeeper::pause_now()
{
    const Clock::time_point start = Clock::now();
    keep();
    // A large state is saved less often, so that saving takes at most about a tenth of the time.
    next_save_ = Clock::now() + std::max(interval_, 10 * (Clock::now() - start));
    return interrupted();
}

void StateKeeper::publish_shard_now()
{
    keep();
    published_ = true;
}

ResultFile::ResultFile(const std::string& path, const PatchTable* beside)
{
    if (!is_state_file(path)) {
        table = read_patch_table(path, beside);
        return;
    }
    const SavedRun saved = read_saved_run(path);
    scene = std::make_unique<const Scene>(restored(saved.description.scene));
    Solution solution = finished_solution(saved, *scene);
    table.path = path;
    table.comments = provenance(command_line_of(saved.description, {}), *scene);
    table.areas = scene->weights();
    table.radiosity = std::move(solution.radiosity);
    table.standard_error = std::move(solution.standard_error);
}

void require_same_patches(const PatchTable& table, const std::vector<double>& areas, const std::string& owner)
{
    if (table.areas.size() != areas.size())
        throw InputError(table.path + ": " + grouped(table.areas.size()) + " patches, expected " +
                         grouped(areas.size()) + " as in " + owner);
    for (std::size_t i = 0; i < areas.size(); ++i)
        if (!(std::abs(table.areas[i] - areas[i]) <= 1e-9 * areas[i]))
            throw InputError(
                table.path +
                format(": patch %zu has %.12g m^2, expected %.12g m^2 as in ", i, table.areas[i], areas[i]) + owner);
}

} // namespace multipath
