// Light is followed from lamps, sky and sun along random paths, which go on where they meet a front and end where they
// meet a back. A closed part of the scene that light meets only from behind is turned over. Whether a part is closed is
// seen from its winding number around points at its surfaces: the sum of the solid angles of its surfaces, over 4 pi,
// with a sign, positive for a surface seen from behind (Jacobson, Kavan and Sorkine-Hornung 2013 generalise the winding
// number to meshes with holes). Inside a closed part it is 1 if the part faces outward and -1 if it faces inward;
// outside it is 0.

#include "scene/facing.h"

#include "base/elementary.h"
#include "base/lists.h"
#include "geometry/intersector/hit_lists.h"
#include "scene/random_ray.h"
#include "scene/surface_edges.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace multipath {

namespace {

/// [sr] Solid angle of a triangle at the origin, positive if it is seen from behind (van Oosterom and Strackee 1983).
double solid_angle(Vec3 a, Vec3 b, Vec3 c)
{
    const double la = length(a), lb = length(b), lc = length(c);
    return 2.0 *
           elementary::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

double solid_angle(const Surface& surface, Vec3 from)
{
    const Vec3 a = surface.origin - from;
    const Vec3 b = a + surface.edge_u;
    const Vec3 d = a + surface.edge_v;
    if (surface.shape == Shape::triangle)
        return solid_angle(a, b, d);
    const Vec3 c = b + surface.edge_v;
    return solid_angle(a, b, c) + solid_angle(a, c, d);
}

/// A scene some of whose surfaces are turned over.
struct TurnedScene
{
    const SceneFile& file;
    const Intersector& intersector;
    bool two_sided;
    std::vector<char> turned;                 ///< per surface
    std::vector<std::uint32_t> surfaces = {}; ///< without the sky
    std::vector<std::uint32_t> lamps = {};    ///< surfaces that emit
    Bounds bounds = {};                       ///< without the sky

    const Material& material(std::uint32_t surface) const { return file.materials[file.material[surface]]; }
    Vec3 normal(std::uint32_t surface, bool front) const
    {
        const Vec3 normal = file.surfaces[surface].normal();
        return front != (turned[surface] != 0) ? normal : -normal;
    }
    double small_distance() const { return 1e-5 * bounds.diagonal(); }
};

/// The connected parts of a scene, without the sky. A part is named by the index of its first surface.
class Parts
{
public:
    explicit Parts(const TurnedScene& scene)
        : scene_(scene), part_(connected_parts(scene.file.surfaces, scene.bounds)), members_(scene.surfaces.size())
    {
        for (const std::uint32_t s : scene.surfaces)
            members_[part_[s]].push_back(s);
    }

    std::uint32_t of(std::uint32_t surface) const { return part_[surface]; }
    /// The surfaces of a part; empty for an index that names no part.
    const std::vector<std::uint32_t>& members(std::uint32_t part) const { return members_[part]; }
    std::uint32_t end() const { return static_cast<std::uint32_t>(members_.size()); }

    double area(std::uint32_t part) const
    {
        return sum_over(members_[part], [this](std::uint32_t s) { return scene_.file.surfaces[s].area(); });
    }

    /// True if the winding number is an integer directly behind up to 16 surfaces of the part.
    bool is_closed(std::uint32_t part) const
    {
        const std::vector<std::uint32_t>& own = members_[part];
        for (std::size_t k = 0; k < own.size(); k += (own.size() + 15) / 16) {
            const double winding = winding_behind(own[k]);
            if (std::abs(winding - std::round(winding)) > 0.01)
                return false;
        }
        return true;
    }

    /// The winding number of a surface's part around a point directly behind the surface.
    double winding_behind(std::uint32_t surface) const
    {
        const Surface& face = scene_.file.surfaces[surface];
        const Vec3 point = face.centre() - scene_.small_distance() * face.normal();
        const auto angle = [&](std::uint32_t s) { return solid_angle(scene_.file.surfaces[s], point); };
        return sum_over(members_[part_[surface]], angle) / (4.0 * pi);
    }

    bool reaches_all_sides(std::uint32_t part) const
    {
        Bounds bounds;
        for (const std::uint32_t s : members_[part])
            bounds.include(scene_.file.surfaces[s].bounds());
        const double tolerance = 1e-3 * scene_.bounds.diagonal();
        return length(bounds.low - scene_.bounds.low) <= tolerance &&
               length(bounds.high - scene_.bounds.high) <= tolerance;
    }

private:
    const TurnedScene& scene_;
    std::vector<std::uint32_t> part_;
    std::vector<std::vector<std::uint32_t>> members_; ///< indexed by part
};

/// Where light arrives in a scene.
struct Arrivals
{
    std::vector<std::uint32_t> fronts; ///< paths that met the front of each surface
    std::vector<std::uint32_t> backs;
    std::vector<double> lamps; ///< [m^2] of the lamps that shine directly on the back of each surface

    explicit Arrivals(std::size_t surfaces) : fronts(surfaces), backs(surfaces), lamps(surfaces) {}
    bool any(const std::vector<std::uint32_t>& side) const
    {
        return std::any_of(side.begin(), side.end(), [](std::uint32_t count) { return count > 0; });
    }
};

/// Random paths of light through a scene.
class LightPaths
{
public:
    explicit LightPaths(const TurnedScene& scene) : scene_(scene), arrivals_(scene.turned.size()) {}

    /// Follows `count` paths from the lamps, and as many from sky and sun to the `receivers`.
    Arrivals follow(std::size_t count, const std::vector<std::uint32_t>& receivers)
    {
        meet_surfaces(start_at_lamps(count));
        start_outside(count, receivers);
        constexpr int most_reflections = 8;
        for (int reflection = 0; reflection < most_reflections && !rays_.empty(); ++reflection)
            meet_surfaces(std::vector<double>(rays_.size()));
        return std::move(arrivals_);
    }

private:
    void start(std::uint32_t surface, const Line& ray)
    {
        from_.push_back(surface);
        rays_.push_back(ray);
    }

    /// Every lamp, however weak, begins as many paths, or every k-th lamp begins one. They begin a little in front,
    /// since a lamp in the plane of a ceiling that looks upward would touch its front. Returns the area [m^2] for which
    /// each stands.
    std::vector<double> start_at_lamps(std::size_t count)
    {
        const std::vector<std::uint32_t>& lamps = scene_.lamps;
        std::vector<double> areas;
        for (std::size_t k = 0; k < count && !lamps.empty(); ++k) {
            const std::uint32_t lamp = lamps[k * lamps.size() / count];
            const Surface& surface = scene_.file.surfaces[lamp];
            const Vec3 front = scene_.normal(lamp, true);
            const Vec3 point = random_.point(surface) + scene_.small_distance() * front;
            start(Intersector::no_surface, {point, random_.direction(front)});
            areas.push_back(surface.area() * static_cast<double>(lamps.size()) / static_cast<double>(count));
        }
        return areas;
    }

    /// Light from outside is followed backwards, from both sides of the receivers, so that small ones count, too: half
    /// of the paths are spread over their number, the others over their area.
    void start_outside(std::size_t count, const std::vector<std::uint32_t>& receivers)
    {
        if (scene_.file.sky_surfaces == 0 && !scene_.file.sun)
            return;
        std::vector<double> area_before; // [m^2]
        double area = 0.0;
        for (const std::uint32_t s : receivers) {
            area_before.push_back(area);
            area += scene_.file.surfaces[s].area();
        }
        const auto chosen = [&](std::size_t k) {
            if (k % 2 == 0)
                return k * receivers.size() / count;
            const double here = area * static_cast<double>(k) / static_cast<double>(count);
            const auto after = std::upper_bound(area_before.begin(), area_before.end(), here);
            return static_cast<std::size_t>(after - area_before.begin()) - 1;
        };
        std::vector<std::uint32_t> from;
        std::vector<Line> rays;
        for (std::size_t k = 0; k < count; ++k) {
            from.push_back(receivers[chosen(k)]);
            const bool to_sun = scene_.file.sun && (scene_.file.sky_surfaces == 0 || random_.number() < 0.5);
            const Vec3 side = scene_.normal(from.back(), random_.number() < 0.5);
            const Vec3 point = random_.point(scene_.file.surfaces[from.back()]);
            rays.push_back({point, to_sun ? scene_.file.sun->direction : random_.direction(side)});
        }
        scene_.intersector.closest_hits_from(from.data(), rays.data(), count, hits_);
        for (std::size_t k = 0; k < count; ++k)
            if (!hits_.is_hit(k) || hits_[k].surface >= scene_.file.own_surfaces())
                arrive(from[k], dot(rays[k].direction, scene_.normal(from[k], true)) > 0.0, rays[k].origin, 0.0);
    }

    /// Follows all rays to the next surface. `lamp_areas`: [m^2] of the lamps for which they stand.
    void meet_surfaces(const std::vector<double>& lamp_areas)
    {
        const std::vector<std::uint32_t> from = std::move(from_);
        const std::vector<Line> rays = std::move(rays_);
        from_.clear();
        rays_.clear();
        scene_.intersector.closest_hits_from(from.data(), rays.data(), rays.size(), hits_);
        for (std::size_t k = 0; k < rays.size(); ++k)
            if (hits_.is_hit(k) && hits_[k].surface < scene_.file.own_surfaces())
                arrive(hits_[k].surface, hits_[k].front != (scene_.turned[hits_[k].surface] != 0),
                       rays[k].at(hits_[k].t), lamp_areas[k]);
    }

    /// Counts the arrival, and reflects a share of the paths by Russian roulette.
    void arrive(std::uint32_t surface, bool front, Vec3 point, double lamp_area)
    {
        if (!front && !scene_.two_sided) {
            ++arrivals_.backs[surface];
            arrivals_.lamps[surface] += lamp_area;
            return;
        }
        ++arrivals_.fronts[surface];
        if (random_.number() < mean(scene_.material(surface).reflectance))
            start(surface, {point, random_.direction(scene_.normal(surface, front))});
    }

    const TurnedScene& scene_;
    Arrivals arrivals_;
    RandomRay random_;
    std::vector<std::uint32_t> from_; ///< per ray: the surface on which it starts
    std::vector<Line> rays_;
    FirstHits hits_;
};

/// Decides which surfaces of a scene are turned over.
class Facing
{
public:
    Facing(const SceneFile& file, const Intersector& intersector, bool two_sided)
        : scene_{file, intersector, two_sided, std::vector<char>(file.surfaces.size())}
    {
        for (std::uint32_t s = 0; s < file.own_surfaces(); ++s) {
            scene_.surfaces.push_back(s);
            scene_.bounds.include(file.surfaces[s].bounds());
            if (emits(s))
                scene_.lamps.push_back(s);
        }
    }

    std::vector<std::uint32_t> turned()
    {
        if (scene_.lamps.size() == scene_.surfaces.size())
            return {};
        bool changed = true; // what was turned may reflect light to other surfaces
        while (changed) {
            const Arrivals light = LightPaths(scene_).follow(few_paths, scene_.surfaces);
            changed = turn_closed_parts(light) || (!light.any(light.fronts) && turn_dark_scene(light));
        }
        std::vector<std::uint32_t> result;
        std::copy_if(scene_.surfaces.begin(), scene_.surfaces.end(), std::back_inserter(result),
                     [&](std::uint32_t s) { return scene_.turned[s] != 0; });
        return result;
    }

private:
    static constexpr std::size_t few_paths = 1 << 12;  ///< to find what may look away from the light
    static constexpr std::size_t many_paths = 1 << 14; ///< to decide

    bool emits(std::uint32_t s) const { return scene_.material(s).emittance != Rgb{}; }

    const Parts& parts()
    {
        if (!parts_)
            parts_.emplace(scene_);
        return *parts_;
    }

    /// True if light meets the part from behind, and so little in front that it comes through cracks.
    bool is_lit_from_behind(std::uint32_t part, const Arrivals& light)
    {
        std::uint64_t fronts = 0, backs = 0;
        for (const std::uint32_t s : parts().members(part)) {
            fronts += light.fronts[s];
            backs += light.backs[s];
        }
        return backs > 1000 * fronts;
    }

    bool is_housing(std::uint32_t part, const Arrivals& light)
    {
        const double lamps = sum_over(parts().members(part), [&](std::uint32_t s) { return light.lamps[s]; }); // [m^2]
        return parts().area(part) <= 4.0 * lamps;
    }

    // The cases (a) to (c) of the header; each returns true if it has turned anything.

    bool turn_closed_parts(const Arrivals& seen)
    {
        if (!seen.any(seen.backs))
            return false;
        std::vector<std::uint32_t> candidates, receivers;
        for (std::uint32_t part = 0; part < parts().end(); ++part)
            if (is_lit_from_behind(part, seen) && !scene_.turned[part] && parts().is_closed(part)) {
                candidates.push_back(part);
                receivers.insert(receivers.end(), parts().members(part).begin(), parts().members(part).end());
            }
        if (candidates.empty())
            return false;
        const Arrivals light = LightPaths(scene_).follow(many_paths, receivers);
        bool any = false;
        for (const std::uint32_t part : candidates)
            if (is_lit_from_behind(part, light) && !is_housing(part, light)) {
                turn(parts().members(part));
                any = true;
            }
        return any;
    }

    bool turn_dark_scene(const Arrivals& seen) { return seen.any(seen.backs) ? turn_open_parts() : turn_bright_room(); }

    bool turn_open_parts()
    {
        std::vector<std::uint32_t> open;
        for (std::uint32_t part = 0; part < parts().end(); ++part)
            if (!parts().members(part).empty() && !parts().is_closed(part))
                for (const std::uint32_t s : parts().members(part))
                    if (!emits(s) && !scene_.turned[s])
                        open.push_back(s);
        const Arrivals light = LightPaths(scene_).follow(many_paths, scene_.surfaces);
        if (light.any(light.fronts) ||
            std::none_of(open.begin(), open.end(), [&](std::uint32_t s) { return light.backs[s] > 0; }))
            return false;
        turn(open);
        return true;
    }

    bool turn_bright_room()
    {
        if (scene_.lamps.empty())
            return false;
        const std::uint32_t part = parts().of(scene_.lamps[0]);
        const auto is_own = [&](std::uint32_t lamp) { return parts().of(lamp) == part; };
        if (scene_.turned[part] || !std::all_of(scene_.lamps.begin(), scene_.lamps.end(), is_own) ||
            !parts().reaches_all_sides(part) || !parts().is_closed(part) ||
            parts().winding_behind(scene_.lamps[0]) < 0.5)
            return false;
        turn(parts().members(part));
        return true;
    }

    void turn(const std::vector<std::uint32_t>& surfaces)
    {
        for (const std::uint32_t s : surfaces)
            scene_.turned[s] = 1;
    }

    TurnedScene scene_;
    std::optional<Parts> parts_; ///< costly, and seldom needed
};

} // namespace

std::vector<std::uint32_t> surfaces_to_turn(const SceneFile& file, const Intersector& intersector, bool two_sided)
{
    return Facing(file, intersector, two_sided).turned();
}

} // namespace multipath
