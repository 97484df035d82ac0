// A floor that runs on below a wall is cut where the wall stands. Contacts are the segments in which the plane of the
// floor meets other surfaces. Contacts on a common line count together, since a wall may consist of many triangles. The
// parts of a surface form a binary space partition (Fuchs, Kedem and Naylor 1980): each part is cut along the line that
// walls cover most, until walls cover too little of all lines through it.

#include "scene/partitions.h"

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
    double rise() const { return diagonal / 100.0; }
    double contact() const { return diagonal / 20.0; }
    double width() const { return diagonal / 500.0; }
};
constexpr double least_share = 0.4;      ///< [1] of the contacts of a line over the length of the part along it
constexpr double nearly_parallel = 1e-3; ///< [radian]
constexpr double most_box_tests = 1u << 26;
constexpr std::size_t most_lines = 64;  ///< through a surface; those of the longest contacts
constexpr std::size_t most_parts = 256; ///< of a surface

struct Span
{
    double low;
    double high;
};

/// The segment in which a surface meets the plane of another one.
struct Contact
{
    Vec3 from;
    Vec3 to;
    double size() const { return length(to - from); }
};

/// A directed line in the plane of a surface with the contacts along it.
struct ContactLine
{
    Vec3 origin;
    Vec3 along;                      ///< unit vector
    Vec3 across;                     ///< unit vector in the plane, to the left
    std::vector<Span> contacts = {}; ///< along the line, by their beginning
    double length = 0.0;             ///< of all contacts

    double height(Vec3 p) const { return dot(across, p - origin); } ///< distance, positive to the left
    double place(Vec3 p) const { return dot(along, p - origin); }

    /// The length of a part of the line that contacts cover.
    double covered(Span part) const
    {
        double sum = 0.0;
        double end = part.low; // of what is counted
        for (const Span& contact : contacts) {
            sum += std::max(0.0, std::min(contact.high, part.high) - std::max(contact.low, end));
            end = std::max(end, contact.high);
        }
        return sum;
    }
};

/// The contact of the plane of a surface with another surface, if that rises from it.
std::optional<Contact> contact_with(const Surface& surface, const Surface& other, const PartitionLimits& limits)
{
    const Vec3 normal = surface.normal();
    const FlatPolygon polygon = polygon_of(other);
    const HeightRange range = heights(polygon, surface.origin, normal);
    if (range.low > limits.touching() || range.high < -limits.touching() ||
        !(range.high > limits.rise() || (limits.both_sides && range.low < -limits.rise())))
        return std::nullopt;
    const Vec3 direction = cross(normal, other.normal());
    if (!(length(direction) > nearly_parallel))
        return std::nullopt;
    std::vector<Vec3> met;
    for (std::size_t k = 0; k < polygon.size; ++k) {
        const Vec3 from = polygon.corners[k];
        const Vec3 to = polygon.next(k);
        const double here = dot(from - surface.origin, normal);
        const double there = dot(to - surface.origin, normal);
        if (std::abs(here) <= limits.touching())
            met.push_back(from);
        else if (std::abs(there) > limits.touching() && (here > 0.0) != (there > 0.0))
            met.push_back(from + (here / (here - there)) * (to - from));
    }
    if (met.empty())
        return std::nullopt;
    const auto [first, last] = std::minmax_element(
        met.begin(), met.end(), [&](Vec3 a, Vec3 b) { return dot(direction, a) < dot(direction, b); });
    const Contact found = {*first, *last};
    return found.size() > limits.touching() ? std::optional(found) : std::nullopt;
}

/// Contacts of a surface with all others, longest first. `boxes`: the bounds of all surfaces.
std::vector<Contact> contacts_of(std::uint32_t s, const SurfaceList& surfaces, const LargeVector<Bounds>& boxes,
                                 const PartitionLimits& limits)
{
    Bounds around = boxes[s];
    const Vec3 margin = {limits.touching(), limits.touching(), limits.touching()};
    around.include(around.low - margin);
    around.include(around.high + margin);
    std::vector<Contact> contacts;
    for (std::uint32_t other = 0; other < surfaces.size(); ++other)
        if (other != s && overlap(around, boxes[other]))
            if (const auto found = contact_with(surfaces[s], surfaces[other], limits))
                contacts.push_back(*found);
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const Contact& a, const Contact& b) { return a.size() > b.size(); });
    return contacts;
}

/// The lines on which the contacts of a surface lie, without those of short contacts.
std::vector<ContactLine> contact_lines(const Surface& surface, const std::vector<Contact>& contacts,
                                       const PartitionLimits& limits)
{
    std::vector<ContactLine> lines;
    for (const Contact& contact : contacts) {
        const double near = 2.0 * limits.touching();
        auto line = std::find_if(lines.begin(), lines.end(), [&](const ContactLine& other) {
            return std::abs(other.height(contact.from)) <= near && std::abs(other.height(contact.to)) <= near;
        });
        if (line == lines.end()) {
            if (lines.size() == most_lines)
                continue;
            const Vec3 along = normalized(contact.to - contact.from);
            lines.push_back({contact.from, along, normalized(cross(surface.normal(), along))});
            line = lines.end() - 1;
        }
        const auto [low, high] = std::minmax({line->place(contact.from), line->place(contact.to)});
        line->contacts.push_back({low, high});
    }
    for (ContactLine& line : lines) {
        std::sort(line.contacts.begin(), line.contacts.end(), [](Span a, Span b) { return a.low < b.low; });
        line.length = line.covered({-Bounds::infinity, Bounds::infinity});
    }
    const auto is_short = [&](const ContactLine& line) { return line.length < limits.contact(); };
    lines.erase(std::remove_if(lines.begin(), lines.end(), is_short), lines.end());
    return lines;
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

/// The parts of a surface on the two sides of a line.
struct Division
{
    Part left = {};
    Part right = {};
    double covered = 0.0; ///< length of the contacts between them; 0 if they are too short to divide
};

Division divided(const Part& part, const Surface& surface, const ContactLine& line, const PartitionLimits& limits)
{
    std::vector<double> heights, places;
    for (const SurfacePoint& p : part) {
        heights.push_back(line.height(surface.at(p.u, p.v)));
        places.push_back(line.place(surface.at(p.u, p.v)));
    }
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    const auto [first, last] = std::minmax_element(places.begin(), places.end());
    if (!(*low < -limits.width() && *high > limits.width()) || line.length < least_share * (*last - *first))
        return {};
    Division sides;
    Span chord = {Bounds::infinity, -Bounds::infinity};
    const auto on_line = [&](SurfacePoint p) {
        const double place = line.place(surface.at(p.u, p.v));
        chord = {std::min(chord.low, place), std::max(chord.high, place)};
        sides.left.push_back(p);
        sides.right.push_back(p);
    };
    const double rounding = 1e-3 * limits.touching();
    for (std::size_t k = 0; k < part.size(); ++k) {
        const std::size_t next = k + 1 < part.size() ? k + 1 : 0;
        const double here = heights[k];
        const double there = heights[next];
        if (std::abs(here) <= rounding)
            on_line(part[k]);
        else
            (here > 0.0 ? sides.left : sides.right).push_back(part[k]);
        if (std::abs(here) > rounding && std::abs(there) > rounding && (here > 0.0) != (there > 0.0)) {
            const double t = here / (here - there);
            on_line({part[k].u + t * (part[next].u - part[k].u), part[k].v + t * (part[next].v - part[k].v)});
        }
    }
    const double covered = line.covered(chord);
    sides.covered = covered > limits.width() ? covered : 0.0;
    return sides;
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

/// Adds a convex part as a parallelogram, or as triangles with a common corner.
void add_pieces(const Part& part, const Surface& surface, std::vector<SurfacePiece>& pieces)
{
    if (part.size() == 4) {
        const auto apart = [&](SurfacePoint a, SurfacePoint b) {
            return length((b.u - a.u) * surface.edge_u + (b.v - a.v) * surface.edge_v);
        };
        const SurfacePoint fourth = {part[1].u + part[3].u - part[0].u, part[1].v + part[3].v - part[0].v};
        if (apart(fourth, part[2]) <= 1e-9 * apart(part[0], part[2])) {
            pieces.push_back({Shape::parallelogram, part[0], part[1], part[3]});
            return;
        }
    }
    for (std::size_t k = 2; k < part.size(); ++k)
        pieces.push_back({Shape::triangle, part[0], part[k - 1], part[k]});
}

/// The pieces of a surface between the lines that divide it; one if none does.
std::vector<SurfacePiece> pieces_of(const Surface& surface, const std::vector<ContactLine>& lines,
                                    const PartitionLimits& limits)
{
    std::vector<Part> parts = {whole(surface.shape)};
    for (std::size_t k = 0; k < parts.size();) {
        Division best;
        for (const ContactLine& line : lines)
            if (Division next = divided(parts[k], surface, line, limits); next.covered > best.covered)
                best = std::move(next);
        if (best.covered > 0.0 && parts.size() < most_parts) {
            parts[k] = std::move(best.left);
            parts.push_back(std::move(best.right));
        } else
            ++k;
    }
    std::vector<SurfacePiece> pieces;
    for (const Part& part : parts)
        add_pieces(part, surface, pieces);
    return pieces;
}

} // namespace

PartitionCuts cut_at_partitions(SceneFile& file, bool two_sided)
{
    const PartitionLimits limits = {bounds_of(file.surfaces).diagonal(), two_sided};
    LargeVector<Bounds> boxes;
    for (const Surface& surface : file.surfaces)
        boxes.push_back(surface.bounds());
    const std::size_t most_added = 1024 + file.surfaces.size() / 8;
    PartitionCuts cuts;
    std::map<std::uint32_t, std::vector<SurfacePiece>> cut;
    double box_tests = 0.0;
    for (const std::uint32_t s : order_by_descending_area(file.surfaces)) {
        if (boxes[s].diagonal() < limits.contact())
            continue;
        box_tests += static_cast<double>(file.surfaces.size());
        if (box_tests > most_box_tests) {
            cuts.complete = false;
            break;
        }
        const std::vector<Contact> contacts = contacts_of(s, file.surfaces, boxes, limits);
        std::vector<SurfacePiece> pieces =
            pieces_of(file.surfaces[s], contact_lines(file.surfaces[s], contacts, limits), limits);
        if (pieces.size() == 1)
            continue;
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
