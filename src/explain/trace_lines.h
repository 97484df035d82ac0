#pragma once

#include "explain/stage_trace.h"
#include "geometry/line.h"

// What the tracers of all stages share.

namespace multipath {

/// Throws SettingsError unless all lines of the range exist in a stage of `lines` lines. `what` is the word for the
/// lines in the message, such as "global lines".
void require_in_stage(const TracedRange& range, std::uint64_t lines, const char* what);

/// Appends a ray from a patch to the next surface, where it arrives at `to`. A ray that leaves the scene ends after a
/// fifth of the diagonal of the scene.
void append_ray(const Scene& scene, std::uint32_t from, const Line& ray, std::uint32_t to, TracedLine& line);

/// The trace of a ray from patch `from` to `to`, with its opening, which ends with `more`; still without what the ray
/// carries.
TracedLine traced_ray(const Scene& scene, const LineOrigin& origin, std::uint32_t from, std::uint32_t to,
                      const std::string& more);

/// The trace of a line through the whole scene that ends at `to`, given its hits in order; still without what it
/// carries.
TracedLine through_scene(const Scene& scene, const LineOrigin& origin, const Line& line, Vec3 to,
                         const std::vector<Hit>& hits);

/// Segment `after` of such a line, which follows as many hits.
Segment segment_after(const TracedLine& line, std::size_t after);

} // namespace multipath
