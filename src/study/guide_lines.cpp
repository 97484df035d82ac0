#include "study/guide_lines.h"

#include "export/svg_marks.h"

#include <algorithm>
#include <array>

namespace multipath {

namespace {

constexpr double label_size = 11.0;     // [px]
constexpr double character_width = 6.1; // [px] width of one, at most, on average
constexpr double step = 8.0;            // [px] between the points that stand for a line or a label
constexpr double frame_distance = 9.0;  // [px] least
constexpr double enough = 15.0;         // [px] of clearance
constexpr const char* line_grey = "#808080";
constexpr const char* label_grey = "#555555";
constexpr std::array<double, 2> slopes = {1.0, 1.25}; // downwards
constexpr std::array<const char*, 2> labels = {"slope \u22121", "slope \u22121.25"};
constexpr double longest_label = 11.0; // [characters]

/// Relative to the point where both begin [px].
struct Guides
{
    std::array<SvgPoint, 2> ends;
    std::array<SvgPoint, 2> labels; ///< begin of the text
};

Guides guides_of(const Plot& plot, double decades)
{
    const double across = decades * plot.width / (plot.across.high - plot.across.low);
    const double down = decades * plot.height / (plot.up.high - plot.up.low);
    Guides guides{};
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        guides.ends[k] = {across, slopes[k] * down};
        guides.labels[k] = {across + 5.0, slopes[k] * down + 4.0};
    }
    guides.labels[1].y = std::max(guides.labels[1].y, guides.labels[0].y + 1.2 * label_size);
    return guides;
}

std::vector<SvgPoint> points_of(const Guides& guides)
{
    std::vector<SvgPoint> points;
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        const std::vector<SvgPoint> line = points_of_line({0.0, 0.0}, guides.ends[k], step);
        points.insert(points.end(), line.begin(), line.end());
        const auto [x, y] = guides.labels[k];
        const std::vector<SvgPoint> label =
            points_of_box({x, y - 0.8 * label_size, x + longest_label * character_width, y + 0.2 * label_size}, step);
        points.insert(points.end(), label.begin(), label.end());
    }
    return points;
}

} // namespace

std::string guide_lines(const Plot& plot, const std::vector<SvgPoint>& obstacles)
{
    const SvgBox room = {plot.left + frame_distance, plot.top + frame_distance, plot.left + plot.width - frame_distance,
                         plot.top + plot.height - frame_distance};
    Guides guides{};
    ClearPlace place{{0.0, 0.0}, -1.0};
    for (const double part : {0.4, 0.33, 0.27, 0.22, 0.18}) {
        const double decades = part * std::min(plot.across.high - plot.across.low, plot.up.high - plot.up.low);
        const Guides shorter = guides_of(plot, decades);
        const ClearPlace found = clear_place(points_of(shorter), obstacles, room);
        if (place.clearance < enough && found.clearance > place.clearance) {
            guides = shorter;
            place = found;
        }
    }
    std::string text;
    for (std::size_t k = 0; k < slopes.size(); ++k) {
        const auto moved = [&](SvgPoint p) { return SvgPoint{p.x + place.shift.x, p.y + place.shift.y}; };
        const SvgPoint label = moved(guides.labels[k]);
        text += svg_polyline({place.shift, moved(guides.ends[k])}, {line_grey, 1.0}) +
                svg_text(label.x, label.y, labels[k], SvgAnchor::start, label_size, label_grey);
    }
    return text;
}

LabelledLevel labelled_level(const Plot& plot, double level, const std::string& label,
                             const std::vector<SvgPoint>& obstacles)
{
    const double y = plot.at({0.0, level}).y;
    const double right = plot.left + plot.width;
    const double length = character_width * static_cast<double>(label.size());
    LabelledLevel best;
    double best_clearance = -1.0;
    for (const double base : {y - 5.0, y + 13.0})
        for (const SvgAnchor anchor : {SvgAnchor::start, SvgAnchor::end}) {
            if (base > plot.top + plot.height - 3.0 || base < plot.top + label_size)
                continue;
            const double from = anchor == SvgAnchor::start ? plot.left + 6.0 : right - 6.0 - length;
            const std::vector<SvgPoint> box =
                points_of_box({from, base - 0.8 * label_size, from + length, base + 0.2 * label_size}, step);
            if (clearance(box, obstacles) <= best_clearance)
                continue;
            best_clearance = clearance(box, obstacles);
            best = {
                svg_text(anchor == SvgAnchor::start ? from : right - 6.0, base, label, anchor, label_size, label_grey),
                box};
        }
    best.text = svg_polyline({{plot.left, y}, {right, y}}, {line_grey, 1.2, "6 4"}) + best.text;
    const std::vector<SvgPoint> line = points_of_line({plot.left, y}, {right, y}, step);
    best.points.insert(best.points.end(), line.begin(), line.end());
    return best;
}

} // namespace multipath
