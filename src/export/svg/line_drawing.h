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
    bool bold = false; ///< drawn solid and thick; other segments are dashed and thin
};

/// A line and the points where it meets surfaces. A ring marks its start, an arrowhead its end.
struct DrawnLine
{
    std::string label; ///< for the legend
    std::vector<DrawnSegment> segments;
    std::vector<Vec3> crossings; ///< points where the line meets surfaces; drawn with the numbers 1, 2, ...
};

struct DrawnSphere
{
    Vec3 centre;
    double radius; ///< [scene units]
};

/// Everything in a drawing besides the scene and the lines.
struct LineDrawing
{
    std::string title;
    std::string subtitle;
    Vec3 up = {0.0, 1.0, 0.0};
    /// The sphere or the box of which the lines are chords; at most one of them is set.
    std::optional<DrawnSphere> sphere;
    std::optional<Bounds> box;
    std::vector<std::string> comments; ///< go into the file, not into the picture
};

/// Draws lines as SVG in two views side by side, from above and from the side, with the outlines of the scene. Sources
/// are yellow. The crossings of each line are numbered if there are at most eight lines.
std::string draw_lines(const Scene& scene, const std::vector<DrawnLine>& lines, const LineDrawing& drawing);

} // namespace multipath
