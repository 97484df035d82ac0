// Finds common planes of coplanar surfaces. Planes are looked up in a hash table of cells in the space of normals and
// offsets. A plane is stored in its own cell only. A look-up also visits the neighbouring cells that the plane almost
// touches, so that almost equal planes are found. Surfaces are processed from large to small: a small face in the plane
// of a large one does not define the plane well. The cells of some surfaces are
// prefetched before their planes are looked up.

#include "geometry/intersector/shared_planes.h"

#include "geometry/intersector/surface_sizes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace multipath {

namespace {

constexpr double normal_cell = 1e-3;
constexpr double offset_cell = 1e-4; // share of the scene's diagonal
constexpr std::uint32_t no_plane = std::numeric_limits<std::uint32_t>::max();

/// Canonical one of the two equations of a plane, the same for both orientations. The direction of comparison is
/// arbitrary but oblique, so that no common normal is perpendicular to it.
Plane unoriented(const Plane& plane)
{
    const double side = dot(plane.normal, {0.80172, 0.47113, 0.36719});
    return side < 0.0 ? Plane{-plane.normal, -plane.offset} : plane;
}

/// All different planes found so far, with a look-up by cell: a hash table with lists.
class PlaneIndex
{
public:
    /// Keys of the cell of a plane (the first key) and of the neighbouring cells that the plane almost touches.
    struct Keys
    {
        std::array<std::uint64_t, 16> key;
        std::size_t count;
    };

    PlaneIndex(Vec3 centre, double diagonal, std::size_t most_planes) : centre_(centre), diagonal_(diagonal)
    {
        std::size_t size = 16;
        while (size < 2 * most_planes)
            size *= 2;
        last_.resize(size, no_plane);
        planes_.reserve(most_planes);
    }

    /// The cells in which a plane must be looked up; prefetches them.
    Keys keys(const Plane& plane) const
    {
        const Keys keys = keys_of(coordinates(plane));
        for (std::size_t i = 0; i < keys.count; ++i)
            prefetch(&last_[slot_of(keys.key[i])]);
        return keys;
    }

    /// The number of a known plane that contains the whole surface, or else of a new plane.
    std::uint32_t find_or_add(const Surface& surface, const Plane& plane, const Keys& keys)
    {
        for (std::size_t i = 0; i < keys.count; ++i)
            for (std::uint32_t p = last_[slot_of(keys.key[i])]; p != no_plane; p = planes_[p].before)
                if (planes_[p].cell == keys.key[i] && holds(planes_[p].plane, surface))
                    return p;
        std::uint32_t& last = last_[slot_of(keys.key[0])];
        planes_.push_back({plane, keys.key[0], last});
        last = static_cast<std::uint32_t>(planes_.size() - 1);
        return last;
    }

    const Plane& plane(std::uint32_t number) const { return planes_[number].plane; }

private:
    struct KnownPlane
    {
        Plane plane;
        std::uint64_t cell;   ///< its key
        std::uint32_t before; ///< the previous plane in the same slot of the hash table
    };

    std::size_t slot_of(std::uint64_t key) const { return key & (last_.size() - 1); }

    /// Normal and offset in units of cells. The offset is relative to the scene's centre, so that it stays small.
    std::array<double, 4> coordinates(const Plane& plane) const
    {
        const double offset = plane.offset - dot(plane.normal, centre_);
        return {plane.normal.x / normal_cell, plane.normal.y / normal_cell, plane.normal.z / normal_cell,
                offset / (offset_cell * diagonal_)};
    }

    /// Builds the keys coordinate by coordinate; each coordinate near a cell border doubles their number.
    static Keys keys_of(const std::array<double, 4>& coordinates)
    {
        constexpr double almost = 0.3; // of a cell: small faces tilt by more than large ones
        Keys keys{{}, 1};
        for (const double coordinate : coordinates) {
            const double own = std::floor(coordinate);
            const double inside = coordinate - own;
            const double step = inside < almost ? -1.0 : inside > 1.0 - almost ? 1.0 : 0.0;
            if (step != 0.0) {
                for (std::size_t i = 0; i < keys.count; ++i)
                    keys.key[keys.count + i] = mixed(keys.key[i], own + step);
            }
            for (std::size_t i = 0; i < keys.count; ++i)
                keys.key[i] = mixed(keys.key[i], own);
            keys.count *= step != 0.0 ? 2 : 1;
        }
        return keys;
    }

    /// Hash of the key so far and the cell number of one more coordinate.
    static std::uint64_t mixed(std::uint64_t key, double cell)
    {
        key = (key ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(cell))) * 0x9e3779b97f4a7c15u;
        return key ^ key >> 29;
    }

    /// True if all corners of the surface are within coplanar_distance of the plane.
    bool holds(const Plane& plane, const Surface& surface) const
    {
        const auto near_plane = [&](Vec3 p) {
            return std::abs(dot(plane.normal, p - centre_) - (plane.offset - dot(plane.normal, centre_))) <=
                   coplanar_distance * diagonal_;
        };
        const Vec3 far_corner = surface.shape == Shape::triangle ? surface.origin : surface.at(1.0, 1.0);
        return near_plane(surface.origin) && near_plane(surface.at(1.0, 0.0)) && near_plane(surface.at(0.0, 1.0)) &&
               near_plane(far_corner);
    }

    Vec3 centre_;
    double diagonal_;
    LargeVector<KnownPlane> planes_;
    LargeVector<std::uint32_t> last_; ///< per slot of the hash table: the last plane found with such a key
};

} // namespace

SharedPlanes share_planes(const SurfaceList& surfaces, const std::vector<std::uint32_t>& order)
{
    SharedPlanes result;
    if (surfaces.empty())
        return result;
    const Bounds bounds = bounds_of(surfaces);
    PlaneIndex index(bounds.centre(), bounds.diagonal(), surfaces.size());
    // The orientations of the surfaces in each plane, as bits: their normals point along or against that of the plane.
    constexpr unsigned along = 1;
    constexpr unsigned against = 2;
    std::vector<unsigned> orientations;
    result.plane_of_surface.reserve(surfaces.size());
    for (const Surface& surface : surfaces) {
        const Vec3 normal = surface.normal();
        result.plane_of_surface.push_back({normal, dot(normal, surface.centre())});
    }
    result.plane_number.resize(surfaces.size());
    constexpr std::size_t at_a_time = 32;
    std::array<PlaneIndex::Keys, at_a_time> keys;
    for (std::size_t first = 0; first < order.size(); first += at_a_time) {
        const std::size_t end = std::min(first + at_a_time, order.size());
        for (std::size_t k = first; k < end; ++k) {
            prefetch(&surfaces[order[k]]);
            keys[k - first] = index.keys(unoriented(result.plane_of_surface[order[k]]));
        }
        for (std::size_t k = first; k < end; ++k) {
            const std::uint32_t s = order[k];
            const Plane& own = result.plane_of_surface[s];
            const std::uint32_t number = index.find_or_add(surfaces[s], unoriented(own), keys[k - first]);
            if (number == orientations.size())
                orientations.push_back(0);
            orientations[number] |= dot(index.plane(number).normal, own.normal) > 0.0 ? along : against;
            result.plane_number[s] = number;
        }
    }
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        if (orientations[result.plane_number[s]] != (along | against))
            continue;
        const Plane& shared = index.plane(result.plane_number[s]);
        const bool is_along = dot(shared.normal, result.plane_of_surface[s].normal) > 0.0;
        result.plane_of_surface[s] = is_along ? shared : Plane{-shared.normal, -shared.offset};
    }
    return result;
}

} // namespace multipath
