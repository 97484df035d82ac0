#pragma once

#include "explain/line_trace.h"

#include <string>
#include <vector>

// Traces of a run (explain/line_trace.h) in words.

namespace multipath {

/// Breaks a text between words into lines of at most 110 columns, each with its line feed; only a longer word exceeds
/// the limit. The first line begins with `first` spaces, the others with `others` spaces.
std::string wrapped(const std::string& text, std::size_t first, std::size_t others);

/// "0.7 W", or "(0.7, 0.6, 0.5) W" where the channels differ. Each space is stored as a control character, at which
/// wrapped() breaks no line and which it replaces by a space.
std::string watts(Rgb power);

/// "table_top (line 12)": the group, or the material if the group has no name, and the line of the scene file.
std::string surface_name(const Scene& scene, std::uint32_t surface);
/// "patch 12 of table_top (line 12)", with ", its back" for a patch on the back of a surface.
std::string patch_name(const Scene& scene, std::uint32_t patch);

/// The run to which the lines of a trace belong. Scene and options must outlive the object.
struct TracedRun
{
    const Scene& scene;
    const SolveOptions& options;
    std::string method;   ///< name for --method
    std::string sequence; ///< full name of the sequence
};

/// The trace as plain text, wrapped to 110 columns, for readers who do not know the paper. Rows of tables are not
/// wrapped and may be longer where coordinates are large.
std::string trace_text(const TracedRun& run, const GlobalTrace& trace);
std::string trace_text(const TracedRun& run, const BundleTrace& trace);
std::string trace_text(const TracedRun& run, const ShotTrace& trace);
std::string trace_text(const TracedRun& run, const ParticleTrace& trace);
std::string trace_text(const TracedRun& run, const WalkTrace& trace);
std::string trace_text(const TracedRun& run, const JacobiTrace& trace);

} // namespace multipath
