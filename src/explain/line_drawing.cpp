// A drawing consists of two parallel projections of the same scale, side by side: from above, with the depth of the
// scene down the page, and from the side. Both have the same axis to the right.

#include "explain/line_drawing.h"

#include "base/elementary.h"
#include "base/text_format.h"
#include "export/svg/svg_plot.h"
#include "geometry/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace multipath {

namespace {

constexpr double view_size = 440.0; // [px]
constexpr double page_margin = 30.0;
constexpr double head_height = 84.0;
constexpr double foot_height = 66.0;
constexpr double drawing_width = 3.0 * page_margin + 2.0 * view_size;
constexpr double drawing_height = head_height + view_size + foot_height;
constexpr std::size_t most_numbered_lines = 8;
constexpr std::size_t most_in_legend = 8;

/// [px] with one decimal.
std::string decimal(double value)
{
    return format("%.1f", value + 0.0);
}

/// A path command with a point: "M12.5 7.0".
std::string command_to(char command, SvgPoint p)
{
    return command + decimal(p.x) + " " + decimal(p.y);
}

std::string circle(SvgPoint p, double radius, const std::string& style)
{
    return "<circle cx=\"" + decimal(p.x) + "\" cy=\"" + decimal(p.y) + "\" r=\"" + decimal(radius) + "\"" + style +
           "/>\n";
}

/// A parallel projection of the scene into a square of the page.
struct View
{
    std::string name;
    Vec3 right; ///< unit vector in the scene
    Vec3 down;  ///< unit vector in the scene
    Vec3 centre;
    double scale;    ///< [px / scene unit]
    SvgPoint middle; ///< projection of `centre`

    SvgPoint at(Vec3 p) const
    {
        return {middle.x + scale * dot(p - centre, right), middle.y + scale * dot(p - centre, down)};
    }
};

/// Unit vectors to the right, up and towards the viewer in the view from the side.
std::array<Vec3, 3> axes(Vec3 up_direction)
{
    const Vec3 up = normalized(up_direction);
    const Vec3 across = std::abs(up.x) < 0.9 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    const Vec3 right = normalized(across - dot(across, up) * up);
    return {right, up, cross(right, up)};
}

/// [scene units] Largest distance of anything drawn from the scene's centre, along any of the three axes.
/// `with_sphere`: the lines are chords of the sphere around the scene.
double reach(const Scene& scene, const StageTrace& trace, bool with_sphere, Vec3 up)
{
    const Bounds& box = scene.bounds();
    double farthest = with_sphere ? 0.5 * box.diagonal() : 0.0;
    const auto include = [&](Vec3 p) {
        for (const Vec3 axis : axes(up))
            farthest = std::max(farthest, std::abs(dot(p - box.centre(), axis)));
    };
    for (const Surface& surface : scene.surfaces())
        for (const Vec3 corner : corners_of(surface))
            include(corner);
    for (const TracedLine& line : trace.lines)
        for (const Vec3 point : line.points)
            include(point);
    return farthest;
}

std::array<View, 2> views(const Scene& scene, const StageTrace& trace, bool with_sphere, Vec3 up_direction)
{
    const auto [right, up, to_viewer] = axes(up_direction);
    const double scale = 0.49 * view_size / reach(scene, trace, with_sphere, up_direction);
    const Vec3 centre = scene.bounds().centre();
    const double y = head_height + 0.5 * view_size;
    return {{{"from above", right, to_viewer, centre, scale, {page_margin + 0.5 * view_size, y}},
             {"from the side", right, -up, centre, scale, {2.0 * page_margin + 1.5 * view_size, y}}}};
}

/// Path data of the outline of a surface: "M12.5 7.0L...Z".
std::string closed_path(const Surface& surface, const View& view)
{
    std::string shape;
    for (const Vec3 corner : corners_of(surface))
        shape += command_to(shape.empty() ? 'M' : 'L', view.at(corner));
    return shape + "Z";
}

std::string scene_outlines(const Scene& scene, const View& view)
{
    std::string shape;
    for (const Surface& surface : scene.surfaces())
        shape += closed_path(surface, view);
    return svg_path(shape, svg_stroke("#777777", "0.9"));
}

std::string sources(const Scene& scene, const View& view)
{
    std::string shape;
    for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s)
        if (mean(scene.surface_material(s).emittance) > 0.0)
            shape += closed_path(scene.surfaces()[s], view);
    return svg_path(
        shape,
        " fill=\"#ffdf70\" fill-opacity=\"0.7\" stroke=\"#e3a700\" stroke-width=\"2.5\" stroke-linejoin=\"round\"");
}

/// A head of constant size at the end of a segment; none if the segment is shorter than half a pixel.
std::string arrow_head(SvgPoint from, SvgPoint to, const std::string& colour)
{
    const double length = elementary::hypot(to.x - from.x, to.y - from.y);
    if (!(length > 0.5))
        return "";
    const SvgPoint back = {-9.0 * (to.x - from.x) / length, -9.0 * (to.y - from.y) / length};
    const SvgPoint one = {to.x + back.x - 0.4 * back.y, to.y + back.y + 0.4 * back.x};
    const SvgPoint other = {to.x + back.x + 0.4 * back.y, to.y + back.y - 0.4 * back.x};
    return svg_path(command_to('M', one) + command_to('L', to) + command_to('L', other) + "Z",
                    " fill=\"" + colour + "\"");
}

/// Segments that join two patches are solid and thick, the others dashed and thin.
std::string segments(const TracedLine& line, const View& view, const std::string& colour)
{
    std::string bold;
    std::string thin;
    for (std::size_t k = 0; k < line.joins.size(); ++k)
        (line.joins[k] ? bold : thin) +=
            command_to('M', view.at(line.points[k])) + command_to('L', view.at(line.points[k + 1]));
    std::string text = svg_path(thin, svg_stroke(colour, "1.2") + " stroke-dasharray=\"5 4\"") +
                       svg_path(bold, svg_stroke(colour, "2.6") + " stroke-linecap=\"round\"");
    if (!line.joins.empty()) {
        const std::size_t last = line.joins.size();
        text +=
            circle(view.at(line.points.front()), 4.0, " fill=\"#ffffff\" stroke=\"" + colour + "\" stroke-width=\"2\"");
        text += arrow_head(view.at(line.points[last - 1]), view.at(line.points[last]), colour);
    }
    return text;
}

std::string crossings(const TracedLine& line, const View& view, const std::string& colour, bool numbered)
{
    std::string text;
    for (std::size_t k = 0; k < line.crossings.size(); ++k) {
        const SvgPoint p = view.at(line.crossings[k].point);
        text += circle(p, numbered ? 7.5 : 2.5,
                       " fill=\"" + std::string(numbered ? "#ffffff" : colour) + "\" stroke=\"" + colour +
                           "\" stroke-width=\"1.4\"");
        if (numbered)
            text += svg_text(p.x, p.y + 3.4, std::to_string(k + 1), SvgAnchor::middle, k < 9 ? 10.0 : 8.5);
    }
    return text;
}

std::string picture(const Scene& scene, const StageTrace& trace, bool with_sphere, const View& view)
{
    std::string text = svg_text(view.middle.x, head_height - 8.0, view.name, SvgAnchor::middle, 13.0);
    if (with_sphere)
        text += circle(view.middle, view.scale * 0.5 * scene.bounds().diagonal(),
                       " fill=\"#f7f7f7\" stroke=\"#b5b5b5\" stroke-width=\"1\"");
    text += scene_outlines(scene, view) + sources(scene, view);
    for (std::size_t k = 0; k < trace.lines.size(); ++k)
        text += segments(trace.lines[k], view, svg_series_colour(k));
    for (std::size_t k = 0; k < trace.lines.size(); ++k)
        text += crossings(trace.lines[k], view, svg_series_colour(k), trace.lines.size() <= most_numbered_lines);
    return text;
}

std::string legend(const StageTrace& trace, bool with_sphere)
{
    const std::size_t count = trace.lines.size();
    std::vector<std::string> labels;
    for (std::size_t k = 0; k < std::min(count, most_in_legend); ++k)
        labels.push_back(trace.kind + " " + std::to_string(trace.lines[k].origin.number + 1));
    if (count > most_in_legend)
        labels.back() = "and " + std::to_string(count - labels.size() + 1) + " more";
    const double y = head_height + view_size + 28.0;
    return svg_legend(page_margin, y, labels) +
           svg_text(page_margin, y + 22.0,
                    std::string("ring: start; arrowhead: end; numbers: surfaces in the order met; solid: from patch to "
                                "patch; dashed: no exchange; yellow: sources") +
                        (with_sphere ? "; disc: the sphere" : ""),
                    SvgAnchor::start, 12.0);
}

} // namespace

std::string draw_lines(const TracedRun& run, const StageTrace& trace, Vec3 up, const std::vector<std::string>& comments)
{
    const bool with_sphere = trace.from_outside && chords_of(run.options) == Chords::sphere;
    std::string text = svg_head(drawing_width, drawing_height, trace.title, comments) +
                       svg_text(page_margin, 32.0, trace.title, SvgAnchor::start, 19.0) +
                       svg_text(page_margin, 52.0, run.scene.path() + ", " + run.settings, SvgAnchor::start, 12.0);
    for (const View& view : views(run.scene, trace, with_sphere, up))
        text += picture(run.scene, trace, with_sphere, view);
    return text + legend(trace, with_sphere) + svg_end();
}

} // namespace multipath
