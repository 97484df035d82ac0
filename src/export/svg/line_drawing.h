#pragma once

#include "geometry/bounds.h"
#include "geometry/vec3.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// A segment of a line.
struct DrawnSegment
{
    Vec3 from;
    Vec3 to;
    bool bold = false; ///< the segment carries power
};

/// A line and its hits, which are numbered from 1. A ring marks its start, an arrowhead its end.
struct DrawnLine
{
    std::string label; ///< for the legend
    std::vector<DrawnSegment> segments;
    std::vector<Vec3> crossings; ///< hits of surfaces
};

struct DrawnSphere
{
    Vec3 centre;
    double radius; ///< [scene units]
};

/// Everything in a drawing except the lines.
struct LineDrawing
{
    std::string title;
    std::string subtitle;
    Vec3 up = {0.0, 1.0, 0.0};
    std::optional<DrawnSphere> sphere; ///< the lines are its chords
    std::optional<Bounds> box;         ///< drawn like the sphere: the lines are its chords
    std::vector<std::string> comments; ///< go into the file, not into the picture
};

/// Draws lines as SVG in two views side by side, from above and from the side, with the outlines of the scene. Sources
/// are yellow. Hits are numbered if there are at most eight lines.
std::string draw_lines(const Scene& scene, const std::vector<DrawnLine>& lines, const LineDrawing& drawing);

} // namespace multipath
