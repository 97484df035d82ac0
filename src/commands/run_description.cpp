#include "commands/run_description.h"

#include "cli/provenance.h"
#include "commands/accuracy.h"
#include "commands/method_options.h"
#include "commands/scene_options.h"
#include "commands/solve_table.h"
#include "scene/input_error.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace multipath {

namespace {

/// Options of which a run may have other values than the one that it goes on from.
constexpr std::array<std::string_view, 3> may_change = {"lines", "tolerance", "time"};

std::vector<Option> options_that_matter()
{
    std::vector<Option> options;
    for (const OptionGroup& group : {solve_method_group(), accuracy_option_group(), scene_option_group()})
        for (const Option& option : group.options)
            if (is_recorded(option.name))
                options.push_back(option);
    return options;
}

bool is_share(const RunDescription& description)
{
    return description.share.of > 1;
}

/// "--sequence halton", "no --two-sided"
std::string said(const Option& option, const CommandLine& line)
{
    const std::string name = "--" + std::string(option.name);
    if (option.argument.empty())
        return line.has(option.name) ? name : "no " + name;
    return line.text(option.name).empty() ? "no " + name : name + " " + line.text(option.name);
}

} // namespace

void RunDescription::visit(Archive& archive)
{
    archive.texts("arguments", arguments);
    archive.value<std::uint64_t>("share", share);
    if (share.of == 0 || share.number >= share.of)
        throw ArchiveError("the state is damaged: no such share");
    const Archive::Inner inner(archive, "scene");
    scene.visit(archive);
}

RunDescription description_of(const CommandLine& line, const Scene& scene, Share share)
{
    RunDescription description;
    for (const Option& option : options_that_matter())
        if (line.has(option.name))
            description.arguments.push_back("--" + std::string(option.name) +
                                            (option.argument.empty() ? "" : "=" + line.text(option.name)));
    description.arguments.emplace_back("--");
    description.arguments.push_back(line.operands()[0]);
    description.scene = archived(scene);
    description.share = share;
    return description;
}

CommandLine command_line_of(const RunDescription& description, const std::vector<std::string>& more_words)
{
    std::vector<std::string> words = more_words;
    words.insert(words.end(), description.arguments.begin(), description.arguments.end());
    return {solve_table(), words};
}

void require_same_run(const RunDescription& saved, const std::string& path, const RunDescription& wanted)
{
    const CommandLine of_saved = command_line_of(saved, {});
    const CommandLine of_wanted = command_line_of(wanted, {});
    const auto refuse = [&](const std::string& difference) {
        throw InputError(path + ": the state of another run: " + difference +
                         "; expected the same options, or another file");
    };
    if (saved.share.number != wanted.share.number || saved.share.of != wanted.share.of)
        refuse("of another share of the work");
    for (const Option& option : options_that_matter()) {
        const bool fixed =
            is_share(saved) || std::find(may_change.begin(), may_change.end(), option.name) == may_change.end();
        const std::string before = said(option, of_saved);
        const std::string now = said(option, of_wanted);
        if (fixed && before != now)
            refuse("made with " + before + ", not with " + now);
    }
    if (saved.scene.hash != wanted.scene.hash)
        refuse("of the scene " + saved.scene.file->path + " as it was then, which is not the one given now");
}

} // namespace multipath
