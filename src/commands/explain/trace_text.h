#pragma once

#include "explain/line_trace.h"

#include <string>
#include <vector>

// The lines of a run, told in words.

namespace multipath {

/// Breaks a text between words into lines of at most 110 columns; its first line begins with `first` spaces, the others
/// with `others`.
std::string wrapped(const std::string& text, std::size_t first, std::size_t others);

/// "0.7 W", or "(0.7, 0.6, 0.5) W" where the channels differ, within which no line ends.
std::string watts(Rgb power);

/// "table_top (line 12)", as `check` names it; the material stands in for a missing name.
std::string surface_name(const Scene& scene, std::uint32_t surface);
/// "patch 12 of table_top (line 12)"; "its back" is said where both sides have patches.
std::string patch_name(const Scene& scene, std::uint32_t patch);

/// The run that the lines of a trace belong to.
struct TracedRun
{
    const Scene& scene;
    const SolveOptions& options;
    std::string method;   ///< as the user names it
    std::string sequence; ///< full name
};

/// The traces in plain text for readers without the paper, at most 110 columns wide.
std::string trace_text(const TracedRun& run, const GlobalTrace& trace);
std::string trace_text(const TracedRun& run, const BundleTrace& trace);
std::string trace_text(const TracedRun& run, const ShotTrace& trace);
std::string trace_text(const TracedRun& run, const ParticleTrace& trace);

} // namespace multipath
