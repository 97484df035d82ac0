#pragma once

#include "explain/line_trace.h"

#include <string>

namespace multipath {

/// What every story says of the run that its lines belong to.
struct ToldRun
{
    const Scene& scene;
    const SolveOptions& options;
    std::string method;   ///< as the user names it
    std::string sequence; ///< full name
};

/// The stories in plain text for readers without the paper, at most 110 columns wide.
std::string story_text(const ToldRun& run, const GlobalStory& story);
std::string story_text(const ToldRun& run, const ShotStory& story);
std::string story_text(const ToldRun& run, const ParticleStory& story);

} // namespace multipath
