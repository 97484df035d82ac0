#include "commands/study/study_cache.h"

#include "cli/files/output_file.h"
#include "cli/progress.h"
#include "cli/provenance.h"
#include "cli/version.h"
#include "commands/commands.h"
#include "commands/options/method_options.h"
#include "commands/solve/accuracy.h"
#include "export/patch_table.h"
#include "image/checksum.h"
#include "radiosity/error_measure.h"
#include "scene/input_error.h"
#include "scene/text/text_format.h"

#include <cmath>
#include <stdexcept>
#include <unistd.h>

namespace multipath {

namespace {

constexpr std::uint64_t lines_beyond = 16; ///< lines of the reference for each of the longest run

std::string beside(const std::string& output)
{
    const std::size_t slash = output.rfind('/');
    const std::size_t dot = output.rfind('.');
    const bool extension = dot != std::string::npos && (slash == std::string::npos || dot > slash);
    return (extension ? output.substr(0, dot) : output) + ".cache";
}

std::string cache_folder(const CommandLine& line, const std::vector<std::string>& outputs)
{
    if (line.has("cache"))
        return line.text("cache");
    for (const std::string& output : outputs)
        if (output != "-")
            return beside(output);
    return "";
}

std::string checksum_of(const std::string& bytes)
{
    return format("%08x", crc32(bytes));
}

std::string bytes_of(const std::vector<Rgb>& values)
{
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Rgb)};
}

/// The `solve` whose result is the reference: as a user would type it, so that its table tells how to make it again.
CommandLine reference_command(const CommandLine& line, std::uint64_t longest)
{
    std::vector<std::string> words = {
        line.operands()[0], "--method",   "reuse",        "--lines", std::to_string(lines_beyond * longest),
        "--sequence",       "sobol-owen", "--replicates", "4"};
    for (const char* name : {"patch-size", "patches", "emission-from", "memory", "threads", "seed"})
        if (line.has(name))
            words.insert(words.end(), {"--" + std::string(name), line.text(name)});
    for (const char* name : {"two-sided", "flip"})
        if (line.has(name))
            words.push_back("--" + std::string(name));
    return {solve_command().table, words};
}

void require_same_scene(const PatchTable& table, const Scene& scene)
{
    const auto refuse = [&](const std::string& difference) {
        throw InputError(table.path + ": " + difference + "; expected a table of the same scene and patch size");
    };
    if (table.areas.size() != scene.patch_count())
        refuse(std::to_string(table.areas.size()) + " patches, but the scene has " +
               std::to_string(scene.patch_count()));
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (!(std::abs(table.areas[i] - scene.area(i)) <= 1e-9 * scene.area(i)))
            refuse("patch " + std::to_string(i) + " has another area than in the scene");
}

/// The last of the facts that kept results have in common.
std::string program_fact()
{
    return "sources: " + sources_checksum();
}

std::string joined(const std::vector<std::string>& facts)
{
    std::string text;
    for (const std::string& fact : facts)
        text += fact + "; ";
    return text;
}

Reference reference_of(const PatchTable& table, const Scene& scene)
{
    require_same_scene(table, scene);
    Reference reference{table.radiosity, {}};
    if (!table.standard_error.empty())
        reference.relative_square = expected_relative_square(table.areas, table.radiosity, table.standard_error);
    return reference;
}

/// The reference that the cache holds in the file, if it is what the facts say.
std::optional<Reference> kept_reference(const std::string& path, const std::vector<std::string>& facts,
                                        const Scene& scene)
{
    if (access(path.c_str(), R_OK) != 0)
        return std::nullopt;
    const PatchTable table = read_patch_table(path);
    if (table.comments != facts)
        return std::nullopt;
    return reference_of(table, scene);
}

Solution solve_as_typed(const CommandLine& command, const Scene& scene, const CommandLine& line)
{
    const SolveOptions options = read_solve_options(command, "lines");
    Progress progress("reference", progress_style(line));
    return solve_accurately(scene, options, read_accuracy(command), [&](double done) { progress.show(done); });
}

} // namespace

StudyCache::StudyCache(const CommandLine& line, const std::vector<std::string>& outputs)
    : folder_(cache_folder(line, outputs))
{
    if (!folder_.empty())
        make_folder(folder_);
}

std::optional<std::string> StudyCache::path(const std::string& name) const
{
    return folder_.empty() ? std::nullopt : std::optional(folder_ + "/" + name);
}

std::unique_ptr<Journal> StudyCache::journal(const CommandTable& table, const CommandLine& line, const Scene& scene,
                                             const Reference& reference) const
{
    if (folder_.empty())
        return std::make_unique<Journal>();
    // Facts that all runs of this study share; the curves and the numbers of lines are each run's own.
    const std::vector<std::string> not_shared = {"methods", "sequences", "pairings",   "line-orders", "chords",
                                                 "from",    "to",        "replicates", "reference",   "against"};
    const std::string shared = joined(provenance(without_options(table, not_shared), line, scene)) + "reference " +
                               checksum_of(bytes_of(reference.radiosity));
    try {
        return std::make_unique<Journal>(*path("runs-" + checksum_of(shared) + ".txt"), shared + "; " + program_fact());
    } catch (const std::runtime_error& error) {
        throw OutputError(error.what());
    }
}

Reference study_reference(const CommandLine& line, const Scene& scene, const StudyPlan& plan, const StudyCache& cache)
{
    if (line.has("reference"))
        return reference_of(read_patch_table(line.text("reference")), scene);
    const CommandLine command = reference_command(line, plan.line_counts.back());
    std::vector<std::string> facts = provenance(solve_command().table, command, scene);
    const std::optional<std::string> path = cache.path("reference-" + checksum_of(joined(facts)) + ".csv");
    facts.push_back(program_fact());
    if (path)
        if (const auto kept = kept_reference(*path, facts, scene))
            return *kept;
    std::optional<OutputFile> file;
    if (path)
        file.emplace(*path);
    const Solution solution = solve_as_typed(command, scene, line);
    if (file) {
        file->write(patch_table(scene, solution.radiosity, solution.standard_error, facts));
        file->commit();
    }
    return {solution.radiosity, expected_relative_square(scene.areas(), solution.radiosity, solution.standard_error)};
}

} // namespace multipath
