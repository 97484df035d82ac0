#include "commands/options/method_options.h"

#include "base/errors.h"
#include "cli/options/number_text.h"
#include "commands/options/scene_options.h"
#include "sampling/sequence.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace multipath {

namespace {

Option method_option(bool with_reuse)
{
    Option option = {"method", 'm', "NAME", with_reuse ? "reuse" : "first-shot",
                     "Method to compute the light; 'multipath help methods' describes them."};
    for (const Method method : all_methods())
        if (with_reuse || !method->traced.empty())
            option.choices.push_back(method->name);
    return option;
}

constexpr std::array<NamedValue<Estimator>, 2> estimator_choices = {
    {{"collision", Estimator::collision}, {"absorption", Estimator::absorption}}};
constexpr std::array<NamedValue<bool>, 2> yes_or_no = {{{"yes", true}, {"no", false}}};
constexpr std::array<NamedValue<Direct>, 2> direct_choices = {{{"shoot", Direct::shoot}, {"gather", Direct::gather}}};

constexpr std::uint64_t most_lines = std::uint64_t{1} << 48; // take months; the sequences have more items

} // namespace

OptionGroup method_option_group(const Option& line_count, bool with_reuse)
{
    OptionGroup group = {
        "Method",
        {method_option(with_reuse),
         line_count,
         {"ratio", 0, "R", "auto",
          "Local lines for each global line; auto takes the paper's optimum for the scene, and 1 for reuse; measured, "
          "for first-shot and extended, the best by a pilot of some rays."},
         {"power-per-line", 0, "W", "", "Power of one ray of the (extended) first shot in watts, instead of --ratio."},
         {"threshold", 0, "B", "auto",
          "Unshot radiosity in W/m^2 that the extended first shot leaves on every patch; auto takes the paper's."},
         {"steps", 0, "K", "1000", "Largest number of passes of the extended first shot."},
         {"estimator", 0, "WHICH", "collision",
          "For local and gathering: score a particle wherever it arrives, or only where it is absorbed.", false,
          names_of(estimator_choices)},
         {"bidirectional", 0, "WHETHER", "yes",
          "Whether a global line, or a ray of jacobi, carries power in both directions at once.", false,
          names_of(yes_or_no)},
         {"bundle", 0, "N", "auto",
          "For transillumination: parallel lines for each direction; auto takes the square root of all lines."},
         {"chords", 0, "FROM", "",
          "Draw global lines through the sphere around the scene, as in the paper and its methods by default, or from "
          "points of its bounding box, so that none misses it.",
          false, names_of(chords_choices)},
         {"sequence", 's', "NAME", "sobol", "Sequence that generates the lines; 'help sequences' lists them."},
         {"line-order", 0, "HOW", "shuffled",
          "Order in which the walk takes its global lines: shuffled in blocks, or that of the sequence, as in the "
          "paper, which makes results of quasi-random sequences slightly wrong.",
          false, names_of(line_order_choices)},
         {"pairing", 0, "HOW", "4d",
          "Take one 4-D item for each line, or two successive 2-D items, which fails with quasi-random sequences.",
          false, names_of(pairing_choices)},
         {"skip", 0, "K", "0", "Leave out the first K items of the sequence."},
         {"seed", 0, "N", "1", "Seed of random and randomised sequences."},
         threads_option()}};
    const std::vector<Option> for_reuse = {
        {"direct", 0, "HOW", "gather",
         "For reuse: gather the direct light between pairs of patches, or shoot it as extended does.", false,
         names_of(direct_choices)},
        {"denoise", 0, "WHETHER", "yes",
         "For reuse without a table of pairs: smooth the light of neighbouring patches within its noise.", false,
         names_of(yes_or_no)},
        {"important", 0, "WHAT", "",
         "For reuse: more rays for an object or material of this name, or for what the cameras see (view)."}};
    if (with_reuse)
        group.options.insert(group.options.end(), for_reuse.begin(), for_reuse.end());
    return group;
}

OptionGroup solve_method_group()
{
    return method_option_group(
        {"lines", 'n', "N", "auto",
         "Total number of lines, local and global; auto takes 2^20, or a power of two that gives each patch 24.", false,
         any_text, true},
        true);
}

SolveOptions read_solve_options(const CommandLine& line, std::string_view line_count)
{
    SolveOptions options;
    if (line.has("power-per-line") && line.has("ratio"))
        throw UsageError("--power-per-line and --ratio exclude each other; expected one of them");
    if (line.has("power-per-line"))
        options.power_by_line = read_positive("--power-per-line", line.text("power-per-line"));
    if (line.text("threshold") != "auto")
        options.threshold = read_real("--threshold", line.text("threshold"));
    options.most_steps = static_cast<int>(read_count("--steps", line.text("steps"), 1, 1000000));
    options.estimator = line.choice("estimator", estimator_choices).value;
    if (line.text("bundle") != "auto")
        options.bundle = read_count("--bundle", line.text("bundle"), 1, 1u << 20);
    options.skip = read_count("--skip", line.text("skip"), 0, most_lines);
    options.seed = read_count("--seed", line.text("seed"));
    options.measured_ratio = line.text("ratio") == "measured";
    if (!options.measured_ratio && line.text("ratio") != "auto")
        options.ratio = read_real("--ratio", line.text("ratio"), 0.0, 1e12);
    options.bidirectional = line.choice("bidirectional", yes_or_no).value;
    if (line.knows("direct"))
        options.direct = line.choice("direct", direct_choices).value;
    if (line.knows("denoise"))
        options.denoise = line.choice("denoise", yes_or_no).value;
    if (line.has("memory"))
        options.memory = static_cast<double>(read_bytes("--memory", line.text("memory")));
    options.threads = thread_count(line);
    options.method = method_named(line.text("method"));
    if (options.measured_ratio && !has_option(options.method, "line-order"))
        throw UsageError("--ratio measured is for the methods first-shot and extended; expected a number or auto");
    options.sequence = line.text("sequence");
    options.line_order = line.choice("line-order", line_order_choices).value;
    options.pairing = line.choice("pairing", pairing_choices).value;
    if (line_count != "lines" || line.text("lines") != "auto") // "auto" depends on the scene: see settle_lines()
        options.lines = read_count("--" + std::string(line_count), line.text(line_count), 1, most_lines);
    if (line.has("chords"))
        options.chords = line.choice("chords", chords_choices).value;
    return options;
}

std::string usual_lines(const Scene& scene)
{
    constexpr std::uint64_t lines_per_patch = 24;
    int power = 20;
    while ((std::uint64_t{1} << power) < lines_per_patch * scene.patch_count())
        ++power;
    return "2^" + std::to_string(power);
}

void settle_lines(const Scene& scene, const CommandLine& line, SolveOptions& options)
{
    if (line.text("lines") == "auto")
        options.lines = read_count("--lines", usual_lines(scene), 1, most_lines);
}

void require_options_with_effect(const CommandLine& line)
{
    require_options_with_effect(line, {line.text("method")}, "--method " + line.text("method"));
}

void require_options_with_effect(const CommandLine& line, const std::vector<std::string>& methods,
                                 const std::string& given)
{
    const auto is_met = [&](std::string_view condition) { // "direct=shoot"
        const std::string name(condition.substr(0, condition.find('=')));
        return name.empty() || (line.knows(name) && line.text(name) == condition.substr(name.size() + 1));
    };
    const auto has_effect = [&](const std::string& method, std::string_view name) {
        const std::vector<MethodOption> options = options_of(method_named(method));
        return std::any_of(options.begin(), options.end(),
                           [&](const MethodOption& option) { return option.name == name && is_met(option.with); });
    };
    std::set<std::string> special;
    for (const Method method : all_methods())
        for (const MethodOption& option : options_of(method))
            special.emplace(option.name);
    for (const std::string& name : special)
        if (line.knows(name) && line.has(name) && line.text(name) != line.default_text(name) &&
            std::none_of(methods.begin(), methods.end(),
                         [&](const std::string& method) { return has_effect(method, name); }))
            throw UsageError("--" + name + " has no effect with " + given);
}

std::string checked_sequence_name(const SolveOptions& options, const std::string& option, bool randomised)
{
    try {
        const std::string name = make_line_sequence(options.sequence, options.seed, options.pairing)->name();
        return randomised ? randomised_name(name) : name;
    } catch (const std::invalid_argument& error) {
        throw UsageError(option + ": " + error.what());
    }
}

} // namespace multipath
