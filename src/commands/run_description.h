#pragma once

#include "cli/command_line.h"
#include "export/scene_archive.h"
#include "parallel/run_control.h"

#include <string>
#include <vector>

namespace multipath {

/// What a run computes, as its state file tells it.
struct RunDescription
{
    std::vector<std::string> arguments; ///< of `solve`, as words: those that its result depends on, and the scene
    ArchivedScene scene;
    Share share;

    void visit(Archive& archive);
};

/// Of the run that the user asks for; its options are those of `solve`.
RunDescription description_of(const CommandLine& line, const Scene& scene, Share share);

/// The command line of the run that a state is of, with more words of the user, such as where to write pictures.
CommandLine command_line_of(const RunDescription& description, const std::vector<std::string>& more_words);

/// Throws InputError "run.state: made with --sequence sobol, not halton; ..." where the user asks for another run than
/// the state is of. Of a longer run of the same kind it may be the beginning, unless it is a share.
void require_same_run(const RunDescription& saved, const std::string& path, const RunDescription& wanted);

} // namespace multipath
