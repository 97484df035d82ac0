// Planes are found again through a hash of their rounded normal and offset. A value close to a rounding limit is looked
// up on both sides of it, so that two almost equal planes always meet in one cell of the hash.

#include "geometry/intersector/shared_planes.h"

#include "geometry/intersector/surface_sizes.h"
#include "parallel/memory.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace multipath {

namespace {

constexpr double normal_cell = 1e-3;
constexpr double offset_cell = 1e-4; // of the scene's diagonal
constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// One of the two descriptions of a plane, the same for both of its sides. The direction of comparison is
/// arbitrary but oblique, so that no common normal is perpendicular to it.
Plane unoriented(const Plane& plane)
{
    const double side = dot(plane.normal, {0.80172, 0.47113, 0.36719});
    return side < 0.0 ? Plane{-plane.normal, -plane.offset} : plane;
}

/// Which list of planes belongs to a cell: a hash table with open addressing.
class CellTable
{
public:
    explicit CellTable(std::size_t most_cells)
    {
        std::size_t size = 16;
        while (size < 2 * most_cells)
            size *= 2;
        slots_.resize(size);
    }

    void prefetch(std::uint64_t key) const { multipath::prefetch(&slots_[place_of(key)]); }
    /// The first plane of the cell, or `none`.
    std::uint32_t head(std::uint64_t key) const { return slots_[find(key)].head; }
    void set_head(std::uint64_t key, std::uint32_t head) { slots_[find(key)] = {key, head}; }

private:
    struct Slot
    {
        std::uint64_t key = 0;
        std::uint32_t head = none;
    };

    std::size_t place_of(std::uint64_t key) const { return key & (slots_.size() - 1); }
    std::size_t find(std::uint64_t key) const
    {
        std::size_t place = place_of(key);
        while (slots_[place].head != none && slots_[place].key != key)
            place = (place + 1) & (slots_.size() - 1);
        return place;
    }

    LargeVector<Slot> slots_;
};

class PlaneIndex
{
public:
    /// Of the cell that holds a plane (first) and of the neighbours that it almost touches.
    struct Keys
    {
        std::array<std::uint64_t, 16> key;
        std::size_t count;
    };

    PlaneIndex(Vec3 centre, double diagonal, std::size_t most_planes)
        : centre_(centre), diagonal_(diagonal), cells_(most_planes)
    {
        planes_.reserve(most_planes);
        next_.reserve(most_planes);
    }

    /// The cells in which a plane is to be looked for; has the memory bring them.
    Keys keys(const Plane& plane) const
    {
        const Keys keys = keys_of(coordinates(plane));
        for (std::size_t i = 0; i < keys.count; ++i)
            cells_.prefetch(keys.key[i]);
        return keys;
    }

    /// The number of a known plane that holds the whole surface, or of a new plane.
    std::uint32_t find_or_add(const Surface& surface, const Plane& plane, const Keys& keys)
    {
        for (std::size_t i = 0; i < keys.count; ++i)
            for (std::uint32_t p = cells_.head(keys.key[i]); p != none; p = next_[p])
                if (holds(planes_[p], surface))
                    return p;
        const auto number = static_cast<std::uint32_t>(planes_.size());
        planes_.push_back(plane);
        next_.push_back(cells_.head(keys.key[0]));
        cells_.set_head(keys.key[0], number);
        return number;
    }

    const Plane& plane(std::uint32_t number) const { return planes_[number]; }
    std::size_t size() const { return planes_.size(); }

private:
    /// In units of the hash cells; the offset is taken from the scene's centre so that it stays small.
    std::array<double, 4> coordinates(const Plane& plane) const
    {
        const double offset = plane.offset - dot(plane.normal, centre_);
        return {plane.normal.x / normal_cell, plane.normal.y / normal_cell, plane.normal.z / normal_cell,
                offset / (offset_cell * diagonal_)};
    }

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

    static std::uint64_t mixed(std::uint64_t key, double cell)
    {
        key = (key ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(cell))) * 0x9e3779b97f4a7c15u;
        return key ^ key >> 29;
    }

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
    LargeVector<Plane> planes_;
    LargeVector<std::uint32_t> next_; ///< next plane of the same cell
    CellTable cells_;
};

/// How many surfaces of a plane face with and against its own direction.
struct PlaneUse
{
    std::uint32_t along = 0;
    std::uint32_t against = 0;
};

} // namespace

SharedPlanes share_planes(const SurfaceList& surfaces, const std::vector<std::uint32_t>& order)
{
    SharedPlanes result;
    if (surfaces.empty())
        return result;
    const Bounds bounds = bounds_of(surfaces);
    PlaneIndex index(bounds.centre(), bounds.diagonal(), surfaces.size());
    LargeVector<PlaneUse> uses;
    result.plane_of_surface.reserve(surfaces.size());
    for (const Surface& surface : surfaces) {
        const Vec3 normal = surface.normal();
        result.plane_of_surface.push_back({normal, dot(normal, surface.centre())});
    }
    result.plane_number.resize(surfaces.size());
    // From large to small: a small face in the plane of a large one does not say exactly where that plane is.
    constexpr std::size_t ahead = 16; // surfaces whose cells are on their way from memory
    std::array<PlaneIndex::Keys, ahead> keys;
    for (std::size_t k = 0; k < order.size() + ahead; ++k) {
        if (k + ahead < order.size())
            prefetch(&result.plane_of_surface[order[k + ahead]]);
        PlaneIndex::Keys& slot = keys[k % ahead];
        const PlaneIndex::Keys due = slot;
        if (k < order.size()) {
            slot = index.keys(unoriented(result.plane_of_surface[order[k]]));
            prefetch(&surfaces[order[k]]);
        }
        if (k < ahead)
            continue;
        const std::uint32_t s = order[k - ahead];
        const Plane& own = result.plane_of_surface[s];
        const std::uint32_t number = index.find_or_add(surfaces[s], unoriented(own), due);
        if (number == uses.size())
            uses.emplace_back();
        ++(dot(index.plane(number).normal, own.normal) > 0.0 ? uses[number].along : uses[number].against);
        result.plane_number[s] = number;
    }
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const PlaneUse use = uses[result.plane_number[s]];
        if (use.along == 0 || use.against == 0)
            continue;
        const Plane& shared = index.plane(result.plane_number[s]);
        const bool along = dot(shared.normal, result.plane_of_surface[s].normal) > 0.0;
        result.plane_of_surface[s] = along ? shared : Plane{-shared.normal, -shared.offset};
    }
    return result;
}

} // namespace multipath
