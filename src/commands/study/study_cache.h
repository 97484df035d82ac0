#pragma once

#include "cli/options/command_line.h"
#include "cli/options/option_table.h"
#include "scene/scene.h"
#include "study/convergence.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// The folder in which a study keeps what it has finished: the reference as a table of patches, and the runs.
class StudyCache
{
public:
    /// The folder that --cache names, or one beside the first output that is a file; made if need be. Throws
    /// OutputError for one that cannot be made.
    StudyCache(const CommandLine& line, const std::vector<std::string>& outputs);

    /// For the runs of this study; remembers nothing without a folder. Runs with other settings, another scene or
    /// reference are kept apart; those of a program from other sources are forgotten. Throws OutputError.
    std::unique_ptr<Journal> journal(const CommandTable& table, const CommandLine& line, const Scene& scene,
                                     const Reference& reference) const;

    /// Where a file of this name would be kept; empty without a folder.
    std::optional<std::string> path(const std::string& name) const;

private:
    std::string folder_; ///< empty: none
};

/// The table that --reference names, else the one kept by a program from the same sources, else a solution with 16
/// times the lines of the plan's last point, which is then kept. Throws InputError for a table of another scene.
Reference study_reference(const CommandLine& line, const Scene& scene, const StudyPlan& plan, const StudyCache& cache);

} // namespace multipath
