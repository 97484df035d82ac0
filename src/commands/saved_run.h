#pragma once

#include "commands/run_description.h"
#include "export/state_file.h"
#include "radiosity/solution.h"

#include <memory>
#include <string>
#include <vector>

namespace multipath {

/// A state file that has been read: the run that it is of, and where that was left.
struct SavedRun
{
    std::unique_ptr<StateReader> arrays;
    RunDescription description;
    std::vector<std::string> parts; ///< under way, the outermost first

    const std::string& name() const { return arrays->name(); }
};

/// Throws ArchiveError.
SavedRun read_saved_run(const std::string& path);
SavedRun read_saved_run(std::unique_ptr<StateReader> arrays);

/// Has the run reached the number of lines that it was asked for?
bool is_finished(const SavedRun& saved);

/// Of the pieces of the run that are finished. Throws InputError without any.
Solution finished_solution(const SavedRun& saved, const Scene& scene);

/// Writes, or reads, what a state file says besides what the parts of the run say.
void visit_head(Archive& archive, RunDescription& description, std::vector<std::string>& parts);

} // namespace multipath
