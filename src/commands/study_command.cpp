// The command `study` reads a plan (curves, numbers of lines, replicates), obtains a reference solution, runs every
// point of every curve, and writes the errors as a table, CSV and plot. The reference and the finished runs are kept in
// a cache folder, so that an interrupted study resumes. A checksum of options and scene is part of the name of a file
// in the cache. The file itself records the sources of the program, and a program from other sources does not use it.

#include "base/checksum.h"
#include "base/errors.h"
#include "base/file_bytes.h"
#include "base/text_format.h"
#include "cli/files/output_file.h"
#include "cli/files/standard_streams.h"
#include "cli/options/number_text.h"
#include "cli/progress.h"
#include "cli/provenance.h"
#include "cli/version.h"
#include "commands/commands.h"
#include "commands/options/memory_limit.h"
#include "commands/options/method_options.h"
#include "commands/options/scene_options.h"
#include "commands/solve/accuracy.h"
#include "commands/solve/saved_run.h"
#include "export/patch_table.h"
#include "radiosity/paper/line_budget.h"
#include "radiosity/run/statistics.h"
#include "study/convergence.h"
#include "study/convergence_plot.h"
#include "study/study_table.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <set>

namespace multipath {

namespace {

/// Splits a list at its commas. An entry that begins with a digit belongs to the previous one if that has a colon:
/// "sobol,halton:2,7,3,5" has two entries.
std::vector<std::string> split_list(const std::string& text)
{
    std::vector<std::string> entries;
    for (const std::string_view part : split(text, ',')) {
        const bool number = !part.empty() && std::isdigit(static_cast<unsigned char>(part[0]));
        if (number && !entries.empty() && entries.back().find(':') != std::string::npos)
            entries.back().append(",").append(part);
        else
            entries.emplace_back(part);
    }
    return entries;
}

/// The entries of the option `name`. Throws UsageError for an empty or repeated entry.
std::vector<std::string> read_list(const CommandLine& line, const std::string& name)
{
    std::vector<std::string> entries = split_list(line.text(name));
    for (const std::string& entry : entries) {
        if (entry.empty())
            throw UsageError("--" + name + ": expected names with a comma between them, got " +
                             quoted_argument(line.text(name)));
        if (std::count(entries.begin(), entries.end(), entry) > 1)
            throw UsageError("--" + name + ": " + quoted_argument(entry) + " is named twice");
    }
    return entries;
}

/// The options for every run of a study.
std::vector<Option> run_options()
{
    return without_options(method_option_group({}, true),
                           {"", "method", "sequence", "pairing", "line-order", "chords", "power-per-line", "important"})
        .options;
}

/// A command `solve` of the scene of the study, with these words, and the values of these options as the user gave
/// them.
CommandLine solve_line(const CommandLine& line, std::vector<std::string> words, const std::vector<Option>& options)
{
    const std::vector<std::string> given = line.words(options);
    words.insert(words.end(), given.begin(), given.end());
    words.insert(words.end(), {"--", line.operands()[0]});
    return {solve_command().table, words};
}

/// `more`: further words of the command for its runs. Throws UsageError for a name that is none.
CurvePlan curve_plan(const CommandLine& line, const CurveKind& wanted, const std::vector<std::string>& more)
{
    std::vector<std::string> words = {"--method=" + wanted.method, "--sequence=" + wanted.sequence,
                                      "--pairing=" + wanted.pairing, "--line-order=" + wanted.line_order};
    if (!wanted.chords.empty())
        words.push_back("--chords=" + wanted.chords);
    words.insert(words.end(), more.begin(), more.end());
    std::vector<Option> options = run_options();
    options.push_back(memory_option());
    CurvePlan plan{wanted, read_solve_options(solve_line(line, words, options), "lines")};
    plan.options.threads = 1; // of each run; several go on at a time
    plan.kind.sequence = checked_sequence_name(plan.options, "--sequences");
    plan.kind.chords =
        has_option(plan.options.method, "chords") ? name_of(chords_choices, chords_of(plan.options)) : "";
    if (!has_option(plan.options.method, "line-order"))
        plan.kind.line_order.clear();
    return plan;
}

/// The options for the curves of a study: lists of methods, sequences, pairings, line orders and chords.
OptionGroup study_curve_options()
{
    return {"Curves, one for each combination",
            {{"methods", 'm', "LIST", "first-shot,extended,reuse",
              "Methods of solve, or all; see 'multipath help methods'."},
             {"sequences", 's', "LIST", "random,sobol",
              "Sequences of solve, also with bases, as in random,sobol,halton:2,7,3,5."},
             {"pairings", 0, "LIST", "4d", "Any of " + join(names_of(pairing_choices)) + "."},
             {"line-orders", 0, "LIST", "shuffled", "Any of " + join(names_of(line_order_choices)) + "."},
             {"chords", 0, "LIST", "",
              "Any of " + join(names_of(chords_choices)) + ". By default those that each method takes in solve."}}};
}

/// The numbers of a list like 0,1/4..2: a range stands for its low end and what doubling makes of it, here 0, 1/4, 1/2,
/// 1 and 2. Throws UsageError for other text.
std::set<double> read_numbers(const CommandLine& line, const std::string& name)
{
    const std::string option = "--" + name;
    const auto read_number = [&](const std::string& text) {
        const std::size_t slash = std::min(text.find('/'), text.size());
        const double number = read_real(option, text.substr(0, slash), 0.0, 1e12);
        return slash < text.size() ? number / read_positive(option, text.substr(slash + 1)) : number;
    };
    std::set<double> numbers;
    for (const std::string& entry : read_list(line, name)) {
        const std::size_t dots = std::min(entry.find(".."), entry.size());
        const double low = read_number(entry.substr(0, dots));
        numbers.insert(low);
        if (dots == entry.size())
            continue;
        const double high = read_number(entry.substr(dots + 2));
        if (!(low > 0.0 && low <= high))
            throw UsageError(option + ": expected LOW..HIGH with 0 < LOW <= HIGH, got " + quoted_argument(entry));
        for (double number = 2.0 * low; number <= high; number *= 2.0)
            numbers.insert(number);
    }
    return numbers;
}

/// What a study varies beside the lines.
struct Variation
{
    Abscissa quantity = Abscissa::lines;
    std::string option;       ///< of solve, which sets it; empty: none
    std::set<double> numbers; ///< its settings; a threshold is over that of (4)
};

/// Throws UsageError.
Variation read_variation(const CommandLine& line)
{
    if (line.has("ratios") + line.has("thresholds") == 0)
        return {};
    if (line.has("ratios") && line.has("thresholds"))
        throw UsageError("--ratios and --thresholds exclude each other; expected one of them");
    const bool ratio = line.has("ratios");
    Variation variation{ratio ? Abscissa::ratio : Abscissa::threshold, ratio ? "ratio" : "threshold", {}};
    for (const std::string& other : {variation.option, std::string("power-per-line"), std::string("from"),
                                     std::string("against"), std::string("with")})
        if (line.knows(other) && line.has(other))
            throw UsageError("--" + variation.option + "s and --" + other +
                             " exclude each other; expected one of them");
    variation.numbers = read_numbers(line, variation.option + "s");
    return variation;
}

/// The curve of this kind, one part for each setting. A ratio is also chosen by (3), and by a pilot where that is
/// known. Throws UsageError for a method without the option.
std::vector<CurvePlan> curve_parts(const CommandLine& line, const CurveKind& wanted, const Variation& variation)
{
    if (variation.quantity == Abscissa::lines)
        return {curve_plan(line, wanted, {})};
    const Method method = method_named(wanted.method);
    if (!has_option(method, variation.option))
        throw UsageError("--" + variation.option + "s: the method " + wanted.method + " has no " + variation.option);
    std::vector<CurvePlan> parts;
    const auto add = [&](const std::string& value, double setting, const std::string& rule) {
        parts.push_back(curve_plan(line, wanted, {"--" + variation.option + "=" + value}));
        parts.back().setting = setting;
        parts.back().rule = rule;
    };
    for (const double number : variation.numbers)
        add(format("%.17g", number), number, "");
    if (variation.quantity == Abscissa::ratio)
        add("auto", 0.0, "auto");
    if (variation.quantity == Abscissa::ratio && has_option(method, "line-order"))
        add("measured", 0.0, "measured");
    return parts;
}

/// One curve for each combination of the lists, without duplicates: for a method without global lines, for example, all
/// chords give the same curve. Throws UsageError for an unknown or repeated name, and for options without effect.
std::vector<CurvePlan> read_curves(const CommandLine& line, const Variation& variation)
{
    const std::vector<std::string_view> known_methods = find_option(solve_command().table, "method")->choices;
    const std::vector<std::string> methods = line.text("methods") == "all"
                                                 ? std::vector<std::string>(known_methods.begin(), known_methods.end())
                                                 : read_list(line, "methods");
    for (const std::string& method : methods)
        require_choice("--methods", method, known_methods);
    require_options_with_effect(line, methods, "--methods " + line.text("methods"));
    const std::vector<std::string> sequences = read_list(line, "sequences");
    const std::vector<std::string> pairings = read_list(line, "pairings");
    const std::vector<std::string> orders = read_list(line, "line-orders");
    const std::vector<std::string> chords =
        line.has("chords") ? read_list(line, "chords") : std::vector<std::string>{""};

    std::vector<CurvePlan> curves;
    for (const std::string& method : methods)
        for (const std::string& sequence : sequences)
            for (const std::string& pairing : pairings)
                for (const std::string& chord : chords)
                    for (const std::string& order : orders) {
                        const std::vector<CurvePlan> parts =
                            curve_parts(line, {method, sequence, pairing, chord, order}, variation);
                        const auto known = [&](const CurvePlan& other) { return other.kind == parts[0].kind; };
                        if (std::none_of(curves.begin(), curves.end(), known))
                            curves.insert(curves.end(), parts.begin(), parts.end());
                    }
    return curves;
}

constexpr std::array<NamedValue<Abscissa>, 2> against_choices = {
    {{"lines", Abscissa::lines}, {"seconds", Abscissa::seconds}}};

StudyPlan read_plan(const CommandLine& line)
{
    constexpr std::uint64_t longest_study = std::uint64_t{1} << 40; // months
    StudyPlan plan;
    const Variation variation = read_variation(line);
    plan.varied = variation.quantity;
    plan.curves = read_curves(line, variation);
    const bool varies_lines = plan.varied == Abscissa::lines;
    const std::uint64_t from = read_count("--from", line.text(varies_lines ? "from" : "to"), 1, longest_study);
    const std::uint64_t to = read_count("--to", line.text("to"), from, longest_study);
    if (!varies_lines)
        for (CurvePlan& curve : plan.curves)
            curve.options.lines = to; // for the pilot
    for (std::uint64_t lines = from; lines <= to; lines *= 2)
        plan.line_counts.push_back(lines);
    plan.executions = static_cast<int>(read_count("--replicates", line.text("replicates"), 1, 10000));
    plan.seed = read_count("--seed", line.text("seed"));
    return plan;
}

constexpr std::uint64_t reference_factor = 16; ///< lines of the reference over those of the longest run

/// The folder in which a study keeps the reference (a table of patches) and the finished runs: the one that --cache
/// names, or one beside the first output that is a file. It is made if it does not exist. Empty: nothing is kept.
/// Throws OutputError if it cannot be made.
std::string cache_folder(const CommandLine& line, const std::vector<std::string>& outputs)
{
    const auto file = std::find_if(outputs.begin(), outputs.end(), [](const std::string& path) { return path != "-"; });
    std::string folder = line.text("cache");
    if (!line.has("cache") && file != outputs.end())
        folder = path_of(*file).replace_extension(".cache").u8string();
    if (!folder.empty())
        make_folder(folder);
    return folder;
}

/// The command `solve` whose result is the reference, as a user would type it. Its table records it, so that it can be
/// reproduced.
CommandLine reference_command(const CommandLine& line, std::uint64_t longest)
{
    const std::string lines = std::to_string(reference_factor * longest);
    std::vector<Option> shared = scene_option_group().options;
    for (const char* name : {"threads", "seed"})
        shared.push_back(*find_option(line.table(), name));
    return solve_line(line, {"--lines", lines, "--sequence", "sobol-owen", "--replicates", "4"}, shared);
}

Reference reference_of(const PatchTable& table, const Scene& scene)
{
    require_same_patches(table, scene.weights(), "the scene");
    Reference reference{table.radiosity, {}};
    if (!table.standard_error.empty())
        reference.relative_square = expected_relative_square(table.areas, table.radiosity, table.standard_error);
    return reference;
}

/// The reference in a file of the cache, if it has exactly these facts as comments.
std::optional<Reference> kept_reference(const std::string& path, const std::vector<std::string>& facts,
                                        const Scene& scene)
{
    std::error_code error;
    if (!std::filesystem::exists(path_of(path), error))
        return std::nullopt;
    const PatchTable table = read_patch_table(path);
    if (table.comments != facts)
        return std::nullopt;
    return reference_of(table, scene);
}

/// The result that --reference names; or the one in the cache, if a program from the same sources has kept it; or a new
/// solution with 16 times the lines of the plan's last point, which is then kept. Throws InputError for a result
/// with other patches.
Reference study_reference(const CommandLine& line, const Scene& scene, const StudyPlan& plan, const std::string& cache)
{
    if (line.has("reference"))
        return reference_of(ResultFile(line.text("reference")).table, scene);
    const CommandLine command = reference_command(line, plan.line_counts.back());
    std::vector<std::string> facts = provenance(command, scene);
    const std::string path = cache + format("/reference-%08x.csv", crc32(join(facts, "; ")));
    facts.push_back("sources: " + sources_checksum()); // a reference by a program from others is not used
    std::optional<OutputFile> file;
    if (!cache.empty()) {
        if (const auto kept = kept_reference(path, facts, scene))
            return *kept;
        file.emplace(path);
    }
    Progress progress("reference", progress_style(line));
    const Solution solution =
        solve_accurately(scene, read_solve_options(command, "lines"), read_accuracy(command), std::ref(progress));
    if (file) {
        file->write(patch_table(scene, solution.radiosity, solution.standard_error, facts));
        file->commit();
    }
    return {solution.radiosity, expected_relative_square(scene.weights(), solution.radiosity, solution.standard_error)};
}

/// The journal of the runs of this study, in a file of the cache; without a file if there is no cache. Runs with other
/// settings, scene or reference have files of their own; those by a program from other sources are overwritten. Throws
/// std::runtime_error.
Journal open_journal(const CommandLine& line, const Scene& scene, const Reference& reference, const std::string& cache)
{
    if (cache.empty())
        return Journal();
    // The identity leaves out what differs between runs (curves, numbers of lines) and what does not change them.
    const std::vector<std::string> not_shared = {"methods",   "sequences", "pairings",   "line-orders", "chords",
                                                 "from",      "ratios",    "thresholds", "to",          "replicates",
                                                 "reference", "against",   "with"};
    const std::vector<Rgb>& radiosity = reference.radiosity;
    const std::string bytes(reinterpret_cast<const char*>(radiosity.data()), radiosity.size() * sizeof(Rgb));
    const std::string shared =
        join(provenance(line, scene, not_shared), "; ") + format("; reference %08x", crc32(bytes));
    return Journal(cache + format("/runs-%08x.txt", crc32(shared)), shared + "; sources: " + sources_checksum());
}

/// The curves of other programs, each called as its file without folder and extension.
std::vector<Curve> other_curves(const std::vector<std::string>& paths)
{
    std::vector<Curve> curves;
    for (const std::string& path : paths) {
        const std::string name = path_of(path).stem().u8string();
        for (const Curve& other : curves)
            if (other.kind.method == name)
                throw UsageError("--with: two files are called " + quoted_argument(name) +
                                 ", as their curves would be");
        curves.push_back(read_curve(path, name));
    }
    return curves;
}

std::string plot_title(const Scene& scene)
{
    return path_of(scene.path()).filename().u8string() + ", " + std::to_string(scene.patch_count()) + " patches";
}

} // namespace

Study study_of(const CommandLine& line)
{
    StudyPlan plan = read_plan(line);
    const int threads = thread_count(line);
    const std::vector<std::string> paths = line.all("output");
    const std::vector<std::string> inputs = concatenated({{scene_path(line)}, line.all("reference"), line.all("with")});
    const std::vector<Curve> with = other_curves(line.all("with"));
    std::vector<PlannedOutput> outputs = open_outputs(paths, inputs, {".csv", ".svg"});

    const Scene scene = read_scene(line, threads);
    require_no_input(outputs, input_files(scene.file()));
    if (plan.varied == Abscissa::threshold)
        for (CurvePlan& curve : plan.curves)
            curve.options.threshold = curve.setting * threshold_radiosity(scene); // (4)
    const std::vector<std::string> comments = provenance(line, scene);
    const std::string cache = cache_folder(line, paths);
    const Reference reference = study_reference(line, scene, plan, cache);
    Study study;
    {
        Journal journal = open_journal(line, scene, reference, cache);
        Progress progress("study", progress_style(line));
        const bool counts = std::any_of(plan.curves.begin(), plan.curves.end(), [](const CurvePlan& c) {
            return c.options.method->shards == Shards::added; // these need memory for pairs of patches
        });
        const int at_a_time = counts ? reuse_runs_at_a_time(line, scene, threads) : threads;
        study = run_study(scene, reference, plan, journal, at_a_time, std::ref(progress));
    }
    study.curves.insert(study.curves.end(), with.begin(), with.end());
    const Abscissa against =
        study.varied == Abscissa::lines ? line.choice("against", against_choices).value : study.varied;
    for (PlannedOutput& output : outputs)
        output.file.write(output.extension == ".csv" ? study_csv(study, comments)
                                                     : convergence_plot(study, against, plot_title(scene), comments));
    commit(outputs);
    if (!line.has("quiet") || paths.empty())
        print(plot_title(scene) + "\n" + study_text(study));
    return study;
}

Command study_command()
{
    return {
        {"study",
         "measure the error against the number of lines, for methods and sequences, and fit slopes",
         {"SCENE.obj", 1, 1},
         {{"Output",
           {{"output", 'o', "FILE", "",
             "Output file besides the table on standard output, .csv (one row per point) or .svg (a plot).", true},
            {"against", 0, "WHAT", "lines", "Horizontal axis of the plot.", false, names_of(against_choices)},
            {"with", 0, "FILE.csv", "",
             "Add the curve of another program, named after the file: columns lines and relative_mse, and perhaps "
             "standard_error and seconds.",
             true},
            {"cache", 0, "FOLDER", "",
             "Folder for finished runs and the reference, from which the same study resumes. By default that of the "
             "first output with the extension .cache; without an output, nothing is kept."},
            {"quiet", 'q', "", "", "Print only errors on stderr, and no table if there is an output."}}},
          study_curve_options(),
          {"Points",
           {{"from", 0, "N", "2^14", "Lines of the first point; every further point has twice as many."},
            {"to", 0, "N", "2^20", "Largest number of lines of a point."},
            {"ratios", 0, "LIST", "",
             "Vary the ratio of local to global lines, at --to lines: 1/16..16 doubles from 1/16 to 16. The paper's "
             "ratio and that of a pilot are points, too."},
            {"thresholds", 0, "LIST", "",
             "Vary the threshold of the extended first shot, at --to lines, in units of the paper's: 0,1/8..8."},
            {"replicates", 0, "R", "4",
             "Runs of which each point is the mean, with different seeds or parts of the sequence."},
            {"reference", 0, "FILE", "",
             "Measure the error against this result of solve with the same patches, a table or a state. By default a "
             "reference with 16 times the lines is computed."}}},
          {"Every run", run_options()},
          scene_option_group()},
         "Seconds are processor time of one thread; --threads runs are executed at the same time.\n"
         "\n"
         "  multipath study scenes/5cubes.obj --methods first-shot,reuse --sequences random,sobol -o study.svg\n"},
        [](const CommandLine& line) {
            study_of(line);
            return exit_done;
        }};
}

} // namespace multipath
