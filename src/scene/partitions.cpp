// A floor that runs on below a wall is cut where the wall stands. Contacts are the segments in which the plane of the
// floor meets other surfaces. Contacts on a common line are joined, since a wall may consist of many triangles. The
// pieces of a surface form a binary space partition (Fuchs, Kedem and Naylor 1980), whose longest lines come first.

#include "scene/partitions.h"

#include "base/elementary.h"
#include "geometry/intersector/surface_sizes.h"
#include "geometry/polygon.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>

namespace multipath {

namespace {

/// The limits that cut_at_partitions() states [scene units].
struct PartitionLimits
{
    double diagonal;
    bool both_sides; ///< what rises from the back counts, too

    double touching() const { return 1e-4 * diagonal; }
    double rise() const { return 1e-3 * diagonal; }
    double contact() const { return diagonal / 20.0; }
    double width() const { return diagonal / 500.0; }
    double surface() const { return diagonal / 64.0; }
};
constexpr double slim_width = 0.25; ///< [1] largest width of a solid partition over its length
constexpr double most_box_tests = 1u << 26;
constexpr std::size_t most_contacts = 1024; ///< per surface
constexpr double nearly_parallel = 1e-3;    ///< [radian]
constexpr std::size_t most_parts = 256;     ///< of a surface

/// A point or vector in the plane of a surface, along two perpendicular unit vectors [scene units]; z is 0.
using FlatPoint = Vec3;

struct Span
{
    double low;
    double high;
    double size() const { return high - low; }
};

/// A directed line in the plane of a surface with the contacts along it.
struct ContactLine
{
    FlatPoint origin;
    FlatPoint along; ///< unit vector
    bool faces_left = false;
    bool faces_right = false;   ///< some partition has its front on this side
    std::vector<Span> contacts; ///< along the line; disjoint once joined
    Span longest = {0.0, 0.0};

    double height(FlatPoint p) const { return cross(along, p - origin).z; } ///< distance, positive to the left
    double place(FlatPoint p) const { return dot(along, p - origin); }
};

/// The plane of a surface.
struct SurfacePlane
{
    explicit SurfacePlane(const Surface& surface)
        : origin(surface.origin), normal(surface.normal()), x(normalized(surface.edge_u)), y(cross(normal, x))
    {
    }
    FlatPoint flat(Vec3 p) const { return {dot(p - origin, x), dot(p - origin, y), 0.0}; }

    Vec3 origin, normal, x, y;
};

/// The segment in which a surface meets the plane; the front of that surface is on the right.
struct Contact
{
    FlatPoint from;
    FlatPoint to;
    double size() const { return elementary::hypot(to.x - from.x, to.y - from.y); }
};

/// The contact of the plane with another surface, if that rises from it.
std::optional<Contact> contact_with(const SurfacePlane& plane, const Surface& other, const PartitionLimits& limits)
{
    const FlatPolygon polygon = polygon_of(other);
    const HeightRange range = heights(polygon, plane.origin, plane.normal);
    if (range.low > limits.touching() || range.high < -limits.touching() ||
        !(range.high > limits.rise() || (limits.both_sides && range.low < -limits.rise())))
        return std::nullopt;
    const Vec3 direction = cross(plane.normal, other.normal());
    if (!(length(direction) > nearly_parallel))
        return std::nullopt;
    const FlatPoint along = plane.flat(plane.origin + normalized(direction));
    std::vector<FlatPoint> met;
    for (std::size_t k = 0; k < polygon.size; ++k) {
        const Vec3 from = polygon.corners[k];
        const Vec3 to = polygon.next(k);
        const double here = dot(from - plane.origin, plane.normal);
        const double there = dot(to - plane.origin, plane.normal);
        if (std::abs(here) <= limits.touching())
            met.push_back(plane.flat(from));
        else if (std::abs(there) > limits.touching() && (here > 0.0) != (there > 0.0))
            met.push_back(plane.flat(from + (here / (here - there)) * (to - from)));
    }
    if (met.empty())
        return std::nullopt;
    const auto [first, last] = std::minmax_element(
        met.begin(), met.end(), [&](FlatPoint a, FlatPoint b) { return dot(along, a) < dot(along, b); });
    const Contact found = {*first, *last}; // its left is normal x direction, away from the front of the other
    if (!(found.size() > limits.touching()))
        return std::nullopt;
    return found;
}

/// Sorts intervals and joins those with gaps of at most `gap`.
void join_spans(std::vector<Span>& intervals, double gap)
{
    std::sort(intervals.begin(), intervals.end(), [](Span a, Span b) { return a.low < b.low; });
    std::vector<Span> joined;
    for (const Span& next : intervals)
        if (!joined.empty() && next.low <= joined.back().high + gap)
            joined.back().high = std::max(joined.back().high, next.high);
        else
            joined.push_back(next);
    intervals = std::move(joined);
}

/// Contacts on common lines, the line of the longest contact first.
std::vector<ContactLine> contact_lines(const std::vector<Contact>& contacts, const PartitionLimits& limits)
{
    std::vector<ContactLine> lines;
    for (const Contact& contact : contacts) {
        const double near = 2.0 * limits.touching();
        auto line = std::find_if(lines.begin(), lines.end(), [&](const ContactLine& other) {
            return std::abs(other.height(contact.from)) <= near && std::abs(other.height(contact.to)) <= near;
        });
        if (line == lines.end()) {
            const FlatPoint way = contact.to - contact.from;
            lines.push_back(
                {contact.from, {way.x / contact.size(), way.y / contact.size(), 0.0}, false, false, {}, {}});
            line = lines.end() - 1;
        }
        const auto [low, high] = std::minmax({line->place(contact.from), line->place(contact.to)});
        const bool same_way = dot(line->along, contact.to - contact.from) > 0.0;
        (same_way ? line->faces_right : line->faces_left) = true;
        line->contacts.push_back({low, high});
    }
    for (ContactLine& line : lines) {
        join_spans(line.contacts, 2.0 * limits.touching());
        line.longest = *std::max_element(line.contacts.begin(), line.contacts.end(),
                                         [](Span a, Span b) { return a.size() < b.size(); });
    }
    return lines;
}

/// The other side of the solid of which the line is one side: the nearest parallel contact behind that faces away from
/// it. Null for a sheet.
const ContactLine* other_side(const ContactLine& line, const std::vector<ContactLine>& lines,
                              const PartitionLimits& limits)
{
    if (line.faces_left == line.faces_right)
        return nullptr;
    const ContactLine* found = nullptr;
    double nearest = Bounds::infinity;
    for (const ContactLine& other : lines) {
        const double turn = dot(line.along, other.along);
        if (!(std::abs(cross(line.along, other.along).z) <= nearly_parallel))
            continue;
        const double left = line.height(other.origin);
        const double depth = line.faces_left ? -left : left;
        const bool faces_away = (turn > 0.0) == line.faces_left ? other.faces_right : other.faces_left;
        if (!(depth > limits.touching() && depth < nearest) || !faces_away)
            continue;
        for (const Span& part : other.contacts) {
            const double start = line.place(other.origin) + turn * part.low;
            const double end = line.place(other.origin) + turn * part.high;
            const double common =
                std::min(std::max(start, end), line.longest.high) - std::max(std::min(start, end), line.longest.low);
            if (common >= 0.5 * std::min(part.size(), line.longest.size())) {
                nearest = depth;
                found = &other;
            }
        }
    }
    return found;
}

/// A point (u, v) of a surface.
struct SurfacePoint
{
    double u;
    double v;
};
/// A convex part of a surface, counter-clockwise.
using Part = std::vector<SurfacePoint>;

Part whole(Shape shape)
{
    return shape == Shape::triangle ? Part{{0, 0}, {1, 0}, {0, 1}} : Part{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
}

/// The parts of a surface on the two sides of a line; nothing if the line does not divide it.
std::optional<std::pair<Part, Part>> divided(const Part& part, const SurfacePlane& plane, const Surface& surface,
                                             const ContactLine& line, const PartitionLimits& limits)
{
    std::vector<double> heights;
    for (const SurfacePoint& p : part)
        heights.push_back(line.height(plane.flat(surface.at(p.u, p.v))));
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    if (!(*low < -limits.width() && *high > limits.width()))
        return std::nullopt;
    std::pair<Part, Part> sides;
    Span chord = {Bounds::infinity, -Bounds::infinity};
    const auto on_line = [&](SurfacePoint p) {
        const double place = line.place(plane.flat(surface.at(p.u, p.v)));
        chord = {std::min(chord.low, place), std::max(chord.high, place)};
        sides.first.push_back(p);
        sides.second.push_back(p);
    };
    const double rounding = 1e-3 * limits.touching();
    for (std::size_t k = 0; k < part.size(); ++k) {
        const std::size_t next = k + 1 < part.size() ? k + 1 : 0;
        const double here = heights[k];
        const double there = heights[next];
        if (std::abs(here) <= rounding)
            on_line(part[k]);
        else
            (here > 0.0 ? sides.first : sides.second).push_back(part[k]);
        if (std::abs(here) > rounding && std::abs(there) > rounding && (here > 0.0) != (there > 0.0)) {
            const double t = here / (here - there);
            on_line({part[k].u + t * (part[next].u - part[k].u), part[k].v + t * (part[next].v - part[k].v)});
        }
    }
    const bool reached = std::any_of(line.contacts.begin(), line.contacts.end(), [&](Span contact) {
        return std::min(contact.high, chord.high) - std::max(contact.low, chord.low) > limits.width();
    });
    return reached ? std::optional(sides) : std::nullopt;
}

/// A parallelogram or triangle of a surface.
struct SurfacePiece
{
    Shape shape;
    SurfacePoint origin, end_u, end_v;

    Surface of(const Surface& surface) const
    {
        const Vec3 corner = surface.at(origin.u, origin.v);
        return {shape, corner, surface.at(end_u.u, end_u.v) - corner, surface.at(end_v.u, end_v.v) - corner};
    }
    TextureFrame of(const TextureFrame& frame) const
    {
        const auto edge = [&](SurfacePoint to) {
            return TexturePoint{(to.u - origin.u) * frame.along_u.s + (to.v - origin.v) * frame.along_v.s,
                                (to.u - origin.u) * frame.along_u.t + (to.v - origin.v) * frame.along_v.t};
        };
        return {frame.at(origin.u, origin.v), edge(end_u), edge(end_v), frame.known};
    }
};

/// Cuts a convex part into a parallelogram or into triangles, each along the shortest diagonal that is left.
void add_pieces(Part part, const Surface& surface, std::vector<SurfacePiece>& pieces)
{
    const auto apart = [&](SurfacePoint a, SurfacePoint b) {
        return length((b.u - a.u) * surface.edge_u + (b.v - a.v) * surface.edge_v);
    };
    const auto lowest = std::min_element(part.begin(), part.end(),
                                         [](SurfacePoint a, SurfacePoint b) { return a.u + a.v < b.u + b.v; });
    std::rotate(part.begin(), lowest, part.end());
    if (part.size() == 4) {
        const SurfacePoint fourth = {part[1].u + part[3].u - part[0].u, part[1].v + part[3].v - part[0].v};
        if (apart(fourth, part[2]) <= 1e-9 * apart(part[0], part[2])) {
            pieces.push_back({Shape::parallelogram, part[0], part[1], part[3]});
            return;
        }
    }
    while (part.size() > 3) {
        std::size_t ear = 0;
        double shortest = Bounds::infinity;
        for (std::size_t k = 0; k < part.size(); ++k) {
            const double size = apart(part[k], part[(k + 2) % part.size()]);
            if (size < shortest) {
                shortest = size;
                ear = (k + 1) % part.size();
            }
        }
        const std::size_t before = (ear + part.size() - 1) % part.size();
        pieces.push_back({Shape::triangle, part[before], part[ear], part[(ear + 1) % part.size()]});
        part.erase(part.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    pieces.push_back({Shape::triangle, part[0], part[1], part[2]});
}

/// Contacts of a surface with all others, longest first. `boxes`: the bounds of all surfaces.
std::vector<Contact> contacts_of(std::uint32_t s, const SurfaceList& surfaces, const LargeVector<Bounds>& boxes,
                                 const PartitionLimits& limits)
{
    const SurfacePlane plane(surfaces[s]);
    Bounds around = boxes[s];
    const Vec3 margin = {limits.touching(), limits.touching(), limits.touching()};
    around.include(around.low - margin);
    around.include(around.high + margin);
    std::vector<Contact> contacts;
    for (std::uint32_t other = 0; other < surfaces.size(); ++other)
        if (other != s && overlap(around, boxes[other]))
            if (const auto found = contact_with(plane, surfaces[other], limits))
                contacts.push_back(*found);
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const Contact& a, const Contact& b) { return a.size() > b.size(); });
    return contacts;
}

/// The lines that divide a surface with these contacts, longest first.
std::vector<ContactLine> partition_lines(const Surface& surface, const std::vector<Contact>& contacts,
                                         const PartitionLimits& limits)
{
    const SurfacePlane plane(surface);
    const std::vector<ContactLine> all = contact_lines(contacts, limits);
    const auto divides = [&](const ContactLine& line) {
        return line.longest.size() >= limits.contact() &&
               divided(whole(surface.shape), plane, surface, line, limits).has_value();
    };
    // One cut is enough for a slim solid, and none if the solid covers the surface up to its border.
    std::vector<ContactLine> lines;
    for (const ContactLine& line : all) {
        const ContactLine* other = divides(line) ? other_side(line, all, limits) : nullptr;
        const bool is_slim = other && std::abs(line.height(other->origin)) <= slim_width * line.longest.size();
        if (other ? is_slim && divides(*other) && &line < other : divides(line))
            lines.push_back(line);
    }
    std::stable_sort(lines.begin(), lines.end(),
                     [](const ContactLine& a, const ContactLine& b) { return a.longest.size() > b.longest.size(); });
    return lines;
}

/// The surfaces that partition lines divide, the largest first, each with its lines, the longest first.
struct DividedSurfaces
{
    std::vector<std::pair<std::uint32_t, std::vector<ContactLine>>> list;
    bool complete = true; ///< false if the search was cut short
};

DividedSurfaces divided_surfaces(const SurfaceList& surfaces, const PartitionLimits& limits)
{
    LargeVector<Bounds> boxes;
    for (const Surface& surface : surfaces)
        boxes.push_back(surface.bounds());
    DividedSurfaces found;
    double box_tests = 0.0;
    for (const std::uint32_t s : order_by_descending_area(surfaces)) {
        if (boxes[s].diagonal() < limits.surface())
            continue;
        if (box_tests > most_box_tests) {
            found.complete = false;
            break;
        }
        box_tests += static_cast<double>(surfaces.size());
        std::vector<Contact> contacts = contacts_of(s, surfaces, boxes, limits);
        if (contacts.size() > most_contacts) {
            found.complete = false;
            contacts.resize(most_contacts);
        }
        // A pair of contacts takes some four times as long as a pair of boxes.
        box_tests += 4.0 * static_cast<double>(contacts.size()) * static_cast<double>(contacts.size());
        std::vector<ContactLine> lines = partition_lines(surfaces[s], contacts, limits);
        if (!lines.empty())
            found.list.emplace_back(s, std::move(lines));
    }
    return found;
}

std::vector<SurfacePiece> pieces_of(const Surface& surface, const std::vector<ContactLine>& lines,
                                    const PartitionLimits& limits)
{
    const SurfacePlane plane(surface);
    std::vector<Part> parts = {whole(surface.shape)};
    for (const ContactLine& line : lines)
        for (std::size_t k = 0, count = parts.size(); k < count && parts.size() < most_parts; ++k)
            if (auto sides = divided(parts[k], plane, surface, line, limits)) {
                parts[k] = std::move(sides->first);
                parts.push_back(std::move(sides->second));
            }
    std::vector<SurfacePiece> pieces;
    for (const Part& part : parts)
        add_pieces(part, surface, pieces);
    return pieces;
}

} // namespace

PartitionCuts cut_at_partitions(SceneFile& file, bool two_sided)
{
    PartitionCuts cuts;
    const std::size_t most_added = 1024 + file.surfaces.size() / 8;
    const PartitionLimits limits = {bounds_of(file.surfaces).diagonal(), two_sided};
    std::map<std::uint32_t, std::vector<SurfacePiece>> cut;
    const DividedSurfaces divided = divided_surfaces(file.surfaces, limits);
    cuts.complete = divided.complete;
    for (const auto& [s, lines] : divided.list) {
        std::vector<SurfacePiece> pieces = pieces_of(file.surfaces[s], lines, limits);
        if (cuts.pieces + pieces.size() > most_added + cuts.surfaces + 1) {
            cuts.complete = false;
            continue;
        }
        ++cuts.surfaces;
        cuts.pieces += pieces.size();
        cut.emplace(s, std::move(pieces));
    }
    if (cut.empty())
        return cuts;

    const auto put_pieces = [&](auto& list, const auto& piece_of) {
        std::decay_t<decltype(list)> result;
        for (std::uint32_t s = 0; s < list.size(); ++s)
            if (const auto found = cut.find(s); found == cut.end())
                result.push_back(list[s]);
            else
                for (const SurfacePiece& piece : found->second)
                    result.push_back(piece_of(piece, list[s]));
        list = std::move(result);
    };
    const auto same = [](const SurfacePiece&, const auto& value) { return value; };
    const auto part = [](const SurfacePiece& piece, const auto& whole) { return piece.of(whole); };
    put_pieces(file.surfaces, part);
    put_pieces(file.texture_frames, part);
    for (std::vector<std::uint32_t>* list : {&file.material, &file.group, &file.line})
        put_pieces(*list, same);
    return cuts;
}

} // namespace multipath
