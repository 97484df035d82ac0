#include "commands/study_curves.h"

#include "cli/choice.h"
#include "cli/usage_error.h"
#include "commands/method_options.h"

#include <algorithm>
#include <cctype>

namespace multipath {

namespace {

/// The entries of the option `name`. Without choices anything goes.
std::vector<std::string> read_list(const CommandLine& line, const std::string& name,
                                   const std::vector<std::string_view>& choices)
{
    std::vector<std::string> entries = split_list(line.text(name));
    for (std::size_t k = 0; k < entries.size(); ++k) {
        if (entries[k].empty())
            throw UsageError("--" + name + ": expected names with a comma between them, got " +
                             quoted_argument(line.text(name)));
        if (!choices.empty())
            require_choice("--" + name, entries[k], choices);
        if (std::find(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(k), entries[k]) !=
            entries.begin() + static_cast<std::ptrdiff_t>(k))
            throw UsageError("--" + name + ": " + quoted_argument(entries[k]) + " is named twice");
    }
    return entries;
}

CurvePlan curve_plan(const SolveOptions& settings, const CurveKind& wanted)
{
    CurvePlan plan{wanted, settings};
    plan.options.threads = 1; // of each run; several go on at a time
    plan.options.method = method_named(wanted.method);
    plan.options.sequence = wanted.sequence;
    plan.options.pairing = pairing_named(wanted.pairing);
    if (!wanted.chords.empty())
        plan.options.chords = chords_named(wanted.chords);
    plan.options.line_order = line_order_named(wanted.line_order);
    plan.kind.sequence = checked_sequence_name(plan.options, "--sequences");
    plan.kind.chords = has_option(plan.options.method, "chords") ? chords_name(chords_of(plan.options)) : "";
    if (!has_option(plan.options.method, "line-order"))
        plan.kind.line_order.clear();
    return plan;
}

} // namespace

OptionGroup study_curve_options()
{
    return {
        "Curves, one for each combination",
        {{"methods", 'm', "LIST", "first-shot,extended,reuse", "Any that solve knows; see 'multipath help methods'."},
         {"sequences", 's', "LIST", "random,sobol",
          "Any that solve knows; those with bases too, as in random,sobol,halton:2,7,3,5."},
         {"pairings", 0, "LIST", "4d", "Of 4d, 2d."},
         {"line-orders", 0, "LIST", "shuffled", "Of shuffled, sequence."},
         {"chords", 0, "LIST", "", "Of sphere, box. Without it, each method's own."}}};
}

std::vector<std::string> split_list(const std::string& text)
{
    std::vector<std::string> entries;
    std::size_t from = 0;
    while (from <= text.size()) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        const std::string piece = text.substr(from, comma - from);
        const bool number = !piece.empty() && std::isdigit(static_cast<unsigned char>(piece[0]));
        if (number && !entries.empty() && entries.back().find(':') != std::string::npos)
            entries.back() += "," + piece;
        else
            entries.push_back(piece);
        from = comma + 1;
    }
    return entries;
}

std::vector<CurvePlan> read_curves(const CommandLine& line)
{
    std::vector<std::string_view> method_names;
    for (const Method method : all_methods())
        method_names.push_back(method->name);
    const std::vector<std::string> methods = read_list(line, "methods", method_names);
    require_options_with_effect(line, methods, "--methods " + line.text("methods"));
    const SolveOptions settings = read_settings(line);
    const std::vector<std::string> sequences = read_list(line, "sequences", {});
    const std::vector<std::string> pairings = read_list(line, "pairings", {"4d", "2d"});
    const std::vector<std::string> orders = read_list(line, "line-orders", {"shuffled", "sequence"});
    const std::vector<std::string> chords =
        line.has("chords") ? read_list(line, "chords", {sphere_chords, box_chords}) : std::vector<std::string>{""};

    std::vector<CurvePlan> curves;
    for (const std::string& method : methods)
        for (const std::string& sequence : sequences)
            for (const std::string& pairing : pairings)
                for (const std::string& chord : chords)
                    for (const std::string& order : orders) {
                        const CurvePlan plan = curve_plan(settings, {method, sequence, pairing, chord, order});
                        const auto known = [&](const CurvePlan& other) { return other.kind == plan.kind; };
                        if (std::none_of(curves.begin(), curves.end(), known))
                            curves.push_back(plan);
                    }
    return curves;
}

} // namespace multipath
