#pragma once

#include "geometry/bounds.h"
#include "geometry/vec3.h"
#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// A straight piece of a line; bold where it carries power.
struct DrawnStretch
{
    Vec3 from;
    Vec3 to;
    bool bold = false;
};

/// A line with the places where it meets surfaces, which are numbered from 1. A ring marks where its first stretch
/// begins, an arrowhead where the last one ends.
struct DrawnLine
{
    std::string label; ///< for the legend
    std::vector<DrawnStretch> stretches;
    std::vector<Vec3> meetings;
};

struct DrawnSphere
{
    Vec3 centre;
    double radius; ///< [scene units]
};

/// Everything in the drawing beside the lines.
struct LineDrawing
{
    std::string title;
    std::string subtitle;
    Vec3 up = {0.0, 1.0, 0.0};
    std::optional<DrawnSphere> sphere; ///< on which the lines begin and end
    std::optional<Bounds> box;         ///< instead of the sphere
    std::vector<std::string> comments; ///< for readers of the file
};

/// The scene's outlines from above and from the side, beside each other, with the lines in both: an SVG. Sources are
/// yellow. Meetings are numbered if there are few lines.
std::string draw_lines(const Scene& scene, const std::vector<DrawnLine>& lines, const LineDrawing& drawing);

} // namespace multipath
