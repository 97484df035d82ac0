#pragma once

#include "geometry/bounds.h"
#include "geometry/conditions.h"
#include "geometry/intersector/surface_block.h"
#include "geometry/line.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace multipath {

/// How a line runs with respect to the scene's box, as far as the filters need to know.
enum class LineCourse : std::uint32_t {
    misses = 0, ///< meets no surface that is filtered: the line misses the box or is a single point
    passes = 1, ///< the infinite line meets the box, and the line can be filtered
    unfit = 2   ///< the line must be decided in double precision: it starts too far away for single precision, or its
                ///< direction is too long or too short
};

/// Lines in the form that the filters use, as a structure of arrays: in single precision, and in coordinates whose
/// origin is the centre of the scene's box and whose unit is half the diagonal of this box. Of each line they have the
/// segment near the scene, which is `middle` + t * `direction` with -half_length <= t <= half_length. Here t counts
/// from the middle, in the same unit as the parameter of the original line. All but the course is of use only if it is
/// `passes`.
struct LineBatch
{
    static constexpr std::size_t most = 256; ///< capacity: a batch fits into the first-level cache

    alignas(64) float direction[3][most];
    float middle[3][most];
    float half_length[most];
    float scale[most]; ///< |x| + |y| + |z| of the direction, an upper bound of the length of the direction
    LineCourse course[most];
    double middle_t[most]; ///< parameter of `middle` on the original line

    bool passes(std::size_t i) const { return course[i] == LineCourse::passes; }
};

/// Surfaces of a small scene that each line of a batch may meet, as bits.
struct FlatMarks
{
    /// Bit s % 32 of word[s / 32][i] is set if line i may meet surface s.
    alignas(64) std::uint32_t word[FlatSurfaces::most / 32][LineBatch::most];
};

/// The surface of a small scene that each line of a batch may meet first. Values of t count from the middle of the
/// line; FlatSurfaces::never stands for "no such surface".
struct NearestCandidates
{
    alignas(64) float first[LineBatch::most]; ///< lower bound of t at this surface, or never
    float second[LineBatch::most];            ///< lower bound of t at all other surfaces, or never
    float number[LineBatch::most];            ///< number of this surface (see FlatSurfaces); 0 if `first` is never
};

/// Coordinate system of LineBatch for a scene. Coordinates in this system are called "in the frame".
class FilterFrame
{
public:
    FilterFrame() = default;
    /// `box` must contain all surfaces, with a margin for rounding (see box_around).
    explicit FilterFrame(const Bounds& box);

    /// Transforms a line into the frame, as entry i of the batch.
    void place(const Line& line, std::size_t i, LineBatch& batch) const;

    Vec3 to_frame(Vec3 p) const { return scale_ * (p - centre_); }
    Vec3 centre() const { return centre_; }   ///< centre of the box [scene units]
    double radius() const { return radius_; } ///< half the diagonal of the box [scene units]
    double scale() const { return scale_; }   ///< 1 / radius
    /// Limit of distances [radius], from 1e4 to 1e7: a line is unfit unless |start|^2 + |origin|^2 < reach^2, where
    /// |start| and |origin| are the distances from the centre of the box to the start of the line and to the origin of
    /// the scene's coordinates.
    double reach() const { return reach_; }

private:
    Vec3 centre_;
    double radius_ = 1.0;
    double scale_ = 1.0;
    double reach_ = 0.0; ///< [radius]
    /// Squared distance of the centre from the origin of the scene's coordinates, in the frame.
    double centre_square_ = 0.0;
    Vec3 half_size_; ///< half the size of the box, in the frame
};

// Branch-free: whether a random chord meets the box is hard to predict.
inline void FilterFrame::place(const Line& line, std::size_t i, LineBatch& batch) const
{
    const Vec3 o = to_frame(line.origin);
    const Vec3 d = scale_ * line.direction;
    const double square = dot(d, d);

    // Separating axis test: the axes that can separate a line from a box are the cross products of the direction and
    // the coordinate axes.
    const Vec3 m = cross(o, d);
    const Vec3 size = {std::abs(d.x), std::abs(d.y), std::abs(d.z)};
    const bool apart = any(std::abs(m.x) > half_size_.y * size.z + half_size_.z * size.y,
                           std::abs(m.y) > half_size_.z * size.x + half_size_.x * size.z,
                           std::abs(m.z) > half_size_.x * size.y + half_size_.y * size.x);

    // A segment around the point nearest to the centre; it contains any chord of the sphere around the box.
    const double inverse_square = 1.0 / square;
    const double nearest = -dot(o, d) * inverse_square;
    const double half_chord = 1.01 * std::sqrt(inverse_square);
    const double sphere_entry = nearest - half_chord;
    const double sphere_exit = nearest + half_chord;
    const double first = sphere_entry > 0.0 ? sphere_entry : 0.0;
    const double last = sphere_exit < line.t_max ? sphere_exit : line.t_max;
    const double middle_t = 0.5 * (first + last);
    const Vec3 middle = o + middle_t * d;
    batch.direction[0][i] = static_cast<float>(d.x);
    batch.direction[1][i] = static_cast<float>(d.y);
    batch.direction[2][i] = static_cast<float>(d.z);
    batch.middle[0][i] = static_cast<float>(middle.x);
    batch.middle[1][i] = static_cast<float>(middle.y);
    batch.middle[2][i] = static_cast<float>(middle.z);
    batch.half_length[i] = static_cast<float>(0.5 * (last - first));
    batch.scale[i] = static_cast<float>(size.x + size.y + size.z);
    batch.middle_t[i] = middle_t;

    const bool fits = every(square > 1e-40, square < 1e40, dot(o, o) + centre_square_ < reach_ * reach_);
    const bool meets = every(!apart, first <= last);
    const bool is_point = every(size.x == 0.0, size.y == 0.0, size.z == 0.0);
    batch.course[i] = static_cast<LineCourse>(static_cast<std::uint32_t>(every(fits, meets)) |
                                              static_cast<std::uint32_t>(!any(fits, is_point)) << 1);
}

inline FilterFrame::FilterFrame(const Bounds& box)
    : centre_(box.centre()),
      radius_(0.5 * box.diagonal()),
      scale_(1.0 / radius_),
      reach_(std::clamp(100.0 * scale_ * length(centre_), 1e4, 1e7)),
      centre_square_(dot(scale_ * centre_, scale_ * centre_)),
      half_size_(0.5 * scale_ * box.size())
{
}

} // namespace multipath
