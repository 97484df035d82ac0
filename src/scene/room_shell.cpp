#include "scene/room_shell.h"

#include "geometry/pi.h"
#include "geometry/polygon.h"
#include "scene/vertex_weld.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace multipath {

namespace {

/// [sr] Of a triangle seen from the origin, positive from behind (van Oosterom and Strackee 1983).
double solid_angle(Vec3 a, Vec3 b, Vec3 c)
{
    const double la = length(a), lb = length(b), lc = length(c);
    return 2.0 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
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

bool emits(const SceneFile& file, std::size_t surface)
{
    return file.materials[file.material[surface]].emittance != Rgb{};
}

/// Surfaces that share corners, directly or by others, have the same number.
std::vector<std::uint32_t> connected_parts(const SurfaceList& surfaces)
{
    LargeVector<Vec3> corners;
    std::vector<std::uint32_t> owner;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s)
        for (const Vec3 corner : corners_of(surfaces[s])) {
            corners.push_back(corner);
            owner.push_back(s);
        }
    const LargeVector<std::uint32_t> welded = weld(corners);
    std::vector<std::uint32_t> parent(surfaces.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t s) {
        while (parent[s] != s)
            s = parent[s] = parent[parent[s]];
        return s;
    };
    for (std::uint32_t k = 0; k < welded.size(); ++k) {
        const std::uint32_t a = root(owner[k]);
        const std::uint32_t b = root(owner[welded[k]]);
        parent[std::max(a, b)] = std::min(a, b);
    }
    for (std::uint32_t s = 0; s < parent.size(); ++s)
        parent[s] = root(s);
    return parent;
}

class Shell
{
public:
    /// The part that reaches as far as all surfaces; empty if none or several do.
    explicit Shell(const SceneFile& file) : file_(file), part_(connected_parts(file.surfaces))
    {
        std::vector<Bounds> bounds(file.surfaces.size());
        for (std::size_t s = 0; s < file.surfaces.size(); ++s) {
            const Bounds box = file.surfaces[s].bounds();
            bounds[part_[s]].include(box);
            all_.include(box);
        }
        const double tolerance = 1e-3 * size();
        std::vector<std::uint32_t> found;
        for (std::uint32_t p = 0; p < bounds.size(); ++p)
            if (part_[p] == p && length(bounds[p].low - all_.low) <= tolerance &&
                length(bounds[p].high - all_.high) <= tolerance)
                found.push_back(p);
        if (found.size() != 1)
            return;
        for (std::uint32_t s = 0; s < part_.size(); ++s)
            if (part_[s] == found[0])
                surfaces_.push_back(s);
        in_shell_ = found[0];
    }

    const std::vector<std::uint32_t>& surfaces() const { return surfaces_; }
    bool has(std::uint32_t surface) const { return !surfaces_.empty() && part_[surface] == in_shell_; }

    /// The winding number is 1 within closed surfaces that look outward.
    bool surrounds(Vec3 point) const
    {
        double sum = 0.0;
        for (const std::uint32_t s : surfaces_)
            sum += solid_angle(file_.surfaces[s], point);
        return sum > 0.99 * 4.0 * pi;
    }

    bool is_convex() const
    {
        constexpr std::size_t most = 4096; // surfaces; the test takes their square
        if (surfaces_.size() > most)
            return false;
        const double tolerance = 1e-6 * size();
        for (const std::uint32_t s : surfaces_) {
            const Surface& face = file_.surfaces[s];
            const Vec3 normal = face.normal();
            for (const std::uint32_t other : surfaces_)
                for (const Vec3 corner : corners_of(file_.surfaces[other]))
                    if (dot(normal, corner - face.origin) > tolerance)
                        return false;
        }
        return true;
    }

    double size() const { return all_.diagonal(); }

private:
    const SceneFile& file_;
    std::vector<std::uint32_t> part_;
    std::vector<std::uint32_t> surfaces_;
    std::uint32_t in_shell_ = 0;
    Bounds all_;
};

} // namespace

std::size_t turn_shell_inward(SceneFile& file)
{
    std::vector<std::uint32_t> emitters;
    for (std::uint32_t s = 0; s < file.surfaces.size(); ++s)
        if (emits(file, s))
            emitters.push_back(s);
    if (emitters.empty() || emitters.size() == file.surfaces.size())
        return 0;

    // In a room that looks inward the winding number is -1, or 0 in and behind its lamps. Most scenes end here.
    const Vec3 first = file.surfaces[emitters[0]].centre();
    double around = 0.0;
    for (std::uint32_t s = 0; s < file.surfaces.size(); ++s)
        around += s == emitters[0] ? 0.0 : solid_angle(file.surfaces[s], first);
    if (around < 0.4 * 4.0 * pi)
        return 0;

    const Shell shell(file);
    std::optional<bool> convex;
    constexpr std::size_t most_tested = 16;
    const std::size_t step = (emitters.size() + most_tested - 1) / most_tested;
    for (std::size_t k = 0; k < emitters.size(); k += step) {
        const Surface& emitter = file.surfaces[emitters[k]];
        if (!shell.has(emitters[k])) {
            if (!shell.surrounds(emitter.centre()))
                return 0;
            continue;
        }
        if (!convex)
            convex = shell.is_convex();
        if (!*convex || !shell.surrounds(emitter.centre() - 1e-6 * shell.size() * emitter.normal()))
            return 0;
    }
    for (const std::uint32_t s : shell.surfaces())
        std::swap(file.surfaces[s].edge_u, file.surfaces[s].edge_v);
    return shell.surfaces().size();
}

} // namespace multipath
