// Planes are found again through a hash of their rounded normal and offset. A value close to a rounding limit is looked
// up on both sides of it, so that two almost equal planes always meet in one cell of the hash.

#include "geometry/shared_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

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

class PlaneIndex
{
public:
    PlaneIndex(Vec3 centre, double diagonal) : centre_(centre), diagonal_(diagonal) {}

    /// The number of a known plane that holds the whole surface, or of a new plane.
    std::uint32_t find_or_add(const Surface& surface, const Plane& plane)
    {
        const auto keys = coordinates(plane);
        for (int corner = 0; corner < 16; ++corner) {
            const std::uint64_t key = cell_key(keys, corner);
            if (corner > 0 && key == cell_key(keys, 0))
                continue;
            const auto head = head_.find(key);
            for (std::uint32_t p = head == head_.end() ? none : head->second; p != none; p = next_[p])
                if (holds(planes_[p], surface))
                    return p;
        }
        const auto number = static_cast<std::uint32_t>(planes_.size());
        planes_.push_back(plane);
        const auto [head, is_new] = head_.emplace(cell_key(keys, 0), number);
        next_.push_back(is_new ? none : head->second);
        head->second = number;
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

    /// Key of the cell that holds the coordinates (corner 0) or of a neighbour they almost touch.
    static std::uint64_t cell_key(const std::array<double, 4>& coordinates, int corner)
    {
        constexpr double almost = 0.3; // of a cell: small faces tilt by more than large ones
        std::uint64_t key = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const double own = std::floor(coordinates[i]);
            const double inside = coordinates[i] - own;
            const double neighbour = inside < almost ? own - 1.0 : inside > 1.0 - almost ? own + 1.0 : own;
            const double cell = (corner >> i & 1) != 0 ? neighbour : own;
            key = (key ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(cell))) * 0x9e3779b97f4a7c15u;
            key ^= key >> 29;
        }
        return key;
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
    std::vector<Plane> planes_;
    std::vector<std::uint32_t> next_; ///< next plane of the same cell
    std::unordered_map<std::uint64_t, std::uint32_t> head_;
};

} // namespace

SharedPlanes share_planes(const std::vector<Surface>& surfaces)
{
    SharedPlanes result;
    if (surfaces.empty())
        return result;
    Bounds bounds;
    std::vector<double> areas;
    for (const Surface& surface : surfaces) {
        bounds.include(surface.bounds());
        areas.push_back(surface.area());
    }
    // From large to small: a small face in the plane of a large one does not say exactly where that plane is.
    std::vector<std::uint32_t> by_size(surfaces.size());
    std::iota(by_size.begin(), by_size.end(), 0u);
    std::stable_sort(by_size.begin(), by_size.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });

    struct Use
    {
        std::uint32_t along = 0;
        std::uint32_t against = 0;
    };
    PlaneIndex index(bounds.centre(), bounds.diagonal());
    std::vector<Use> uses; // per plane: surfaces that face with and against its own direction
    result.plane_of_surface.resize(surfaces.size());
    result.plane_number.resize(surfaces.size());
    for (const std::uint32_t s : by_size) {
        const Vec3 normal = surfaces[s].normal();
        const Plane own = {normal, dot(normal, surfaces[s].centre())};
        const std::uint32_t number = index.find_or_add(surfaces[s], unoriented(own));
        uses.resize(index.size());
        ++(dot(index.plane(number).normal, normal) > 0.0 ? uses[number].along : uses[number].against);
        result.plane_of_surface[s] = own;
        result.plane_number[s] = number;
    }
    for (std::uint32_t s = 0; s < surfaces.size(); ++s) {
        const Use use = uses[result.plane_number[s]];
        if (use.along == 0 || use.against == 0)
            continue;
        const Plane& shared = index.plane(result.plane_number[s]);
        const bool along = dot(shared.normal, result.plane_of_surface[s].normal) > 0.0;
        result.plane_of_surface[s] = along ? shared : Plane{-shared.normal, -shared.offset};
    }
    for (const Use& use : uses)
        result.is_shared.push_back(use.along + use.against > 1);
    return result;
}

} // namespace multipath
