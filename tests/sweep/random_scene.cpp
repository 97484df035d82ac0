#include "sweep/random_scene.h"

#include "geometry/bounds.h"
#include "refinement/adaptive_patches.h"
#include "sampling/random.h"
#include "scene/daylight.h"
#include "scene/scene_builder.h"
#include "test_scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace multipath {

namespace {

class Random
{
public:
    explicit Random(std::uint64_t key) : key_(key) {}
    double within(double low, double high) { return low + (high - low) * bits_to_unit(random_bits(key_, counter_++)); }
    bool chance(double probability) { return within(0, 1) < probability; }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(within(0, n)); }
    /// From `low` to `high`, each power of ten as often as any other.
    double magnitude(double low, double high) { return std::exp(within(std::log(low), std::log(high))); }
    Vec3 point(Vec3 low, Vec3 high) { return {within(low.x, high.x), within(low.y, high.y), within(low.z, high.z)}; }

private:
    std::uint64_t key_;
    std::uint64_t counter_ = 0;
};

/// Puts a scene together: shape by shape, then its light and what may happen to any scene.
class SceneMaker
{
public:
    explicit SceneMaker(std::uint64_t key) : random_(mix_bits(key)), shape_(key % shapes), palette_(random_.below(4))
    {
        constexpr std::array<const char*, 4> palettes = {"", ", white", ", dark", ", white and dark"};
        two_sided_ = random_.chance(shape_ == sheets ? 0.7 : 0.3);
        (this->*makers[shape_].make)();
        kind_ = std::string(makers[shape_].name) + palettes[palette_];
        if (two_sided_)
            kind_ += ", two-sided";
        if (shape_ != convex_body)
            add_coincident_faces();
        add_light();
    }

    RandomScene scene(std::uint32_t most_patches)
    {
        SceneFile file = placed(textured(builder_.file()));
        if (sky_ > 0.0)
            add_sky(file, {sky_, 0.8 * sky_, 0.6 * sky_});
        const auto wanted = static_cast<std::uint64_t>(random_.magnitude(1, most_patches));
        const double size = patch_size_for_count(file.surfaces, wanted);
        Scene scene(std::move(file), size, two_sided_);
        if (shape_ != convex_body && random_.chance(0.2)) {
            scene = adaptively_refined(scene, 2 * scene.patch_count(), 2e9, 1, [](double) {});
            kind_ += ", adaptive";
        }
        const double lines = random_.magnitude(1, 100) * scene.patch_count();
        kind_ += ", " + std::to_string(scene.patch_count()) + " patches";
        return {std::move(scene), std::max<std::uint64_t>(64, static_cast<std::uint64_t>(lines)), kind_,
                shape_ == convex_body && !sunny_};
    }

private:
    std::uint32_t wall()
    {
        // A white cavity inside a body keeps what gets in through the least error for ever.
        if ((palette_ & 1) != 0 && !two_sided_ && random_.chance(0.4))
            return builder_.grey(1.0, 0.0);
        if ((palette_ & 2) != 0 && random_.chance(0.3))
            return builder_.grey(0.0, 0.0);
        return builder_.material({random_.within(0, 0.9), random_.within(0, 0.9), random_.within(0, 0.9)}, {});
    }

    /// The walls of a room whose numbers are in `open` are missing.
    void room(Vec3 size, const std::vector<std::uint32_t>& open)
    {
        SceneBuilder closed;
        closed.room({0, 0, 0}, size, 0);
        const std::uint32_t grey = builder_.grey(0.5, 0.0); // absorbs, in whatever room
        for (std::uint32_t side = 0; side < 6; ++side)
            if (std::find(open.begin(), open.end(), side) == open.end())
                builder_.surface(closed.file().surfaces[side], side == 5 || random_.chance(0.3) ? grey : wall());
        inside_ = size;
    }
    void boxes(std::uint32_t most)
    {
        const std::uint32_t count = random_.below(most + 1);
        for (std::uint32_t k = 0; k < count; ++k) { // some cross each other, some stand on the floor or on the last one
            Vec3 low = random_.point({0.05 * inside_.x, 0, 0.05 * inside_.z}, 0.6 * inside_);
            const Vec3 size = random_.point(0.1 * inside_, 0.35 * inside_);
            if (random_.chance(0.5))
                low.y = 0.0;
            box(low, low + size);
            if (random_.chance(0.3))
                box({low.x + 0.2 * size.x, low.y + size.y, low.z},
                    {low.x + 0.7 * size.x, low.y + 1.2 * size.y, low.z + size.z});
        }
    }
    void box(Vec3 low, Vec3 high)
    {
        builder_.box(low, high, wall());
        solid_.include(low);
        solid_.include(high);
    }

    void make_closed_room()
    {
        room(random_.point({1, 1, 1}, {4, 4, 4}), {});
        boxes(3);
        lamp_ = true;
    }
    void make_open_room()
    {
        std::vector<std::uint32_t> sides = {0, 1, 2, 3, 4, 5};
        for (std::uint32_t k = 0; k < 5; ++k)
            std::swap(sides[k], sides[k + random_.below(6 - k)]);
        sides.resize(1 + random_.below(5));
        room(random_.point({1, 1, 1}, {4, 4, 4}), sides);
        boxes(2);
    }
    void make_buildings()
    {
        inside_ = random_.point({3, 1, 3}, {6, 4, 6});
        builder_.rectangle({0, 0, 0}, {0, 0, inside_.z}, {inside_.x, 0, 0}, wall());
        boxes(5);
    }
    void make_street()
    {
        inside_ = random_.point({3, 2, 3}, {5, 6, 6});
        const Vec3 x = {inside_.x, 0, 0};
        const Vec3 y = {0, inside_.y, 0};
        const Vec3 z = {0, 0, inside_.z};
        builder_.rectangle({0, 0, 0}, z, x, wall()).rectangle({0, 0, 0}, y, z, wall()).rectangle(x, z, y, wall());
        boxes(2);
    }
    void make_sheets()
    {
        inside_ = {3, 3, 3};
        const std::uint32_t count = 1 + random_.below(6);
        for (std::uint32_t k = 0; k < count; ++k) {
            const Vec3 corner = random_.point({0, 0, 0}, inside_);
            const Vec3 u = random_.point({-1, -1, -1}, {1, 1, 1});
            const Vec3 v = random_.point({-1, -1, -1}, {1, 1, 1});
            const std::uint32_t material = wall();
            if (random_.chance(0.5))
                builder_.triangle(corner, corner + u, corner + v, material);
            else
                builder_.rectangle(corner, u, v, material);
        }
    }
    void make_convex_body()
    {
        inside_ = random_.point({0.2, 0.2, 0.2}, {2, 2, 2});
        builder_.box({0, 0, 0}, inside_, wall());
    }
    void make_terrain()
    {
        constexpr std::uint32_t n = 5;
        inside_ = {4, 2, 4};
        std::vector<std::uint32_t> ground = {wall(), wall(), wall()};
        std::vector<Vec3> points;
        for (std::uint32_t k = 0; k <= n; ++k)
            for (std::uint32_t l = 0; l <= n; ++l)
                points.push_back({4.0 * k / n, random_.within(0, 1.5), 4.0 * l / n});
        for (std::uint32_t k = 0; k < n; ++k)
            for (std::uint32_t l = 0; l < n; ++l) {
                const Vec3* const p = &points[k * (n + 1) + l];
                builder_.triangle(p[0], p[1], p[n + 1], ground[random_.below(3)]);
                builder_.triangle(p[1], p[n + 2], p[n + 1], ground[random_.below(3)]);
            }
        boxes(2);
    }
    /// One wall has a hole, and a sill outside.
    void make_window()
    {
        const Vec3 d = random_.point({2, 2, 2}, {4, 4, 4});
        room(d, {4});
        const std::uint32_t frame = wall();
        const Vec3 low = {0.3 * d.x, 0.4 * d.y, 0};
        const Vec3 high = {random_.within(0.35, 0.9) * d.x, random_.within(0.5, 0.9) * d.y, 0};
        const auto part = [&](double x0, double x1, double y0, double y1) {
            builder_.rectangle({x0, y0, 0}, {x1 - x0, 0, 0}, {0, y1 - y0, 0}, frame);
        };
        part(0, low.x, 0, d.y);
        part(high.x, d.x, 0, d.y);
        part(low.x, high.x, 0, low.y);
        part(low.x, high.x, high.y, d.y);
        builder_.rectangle({low.x, low.y, -0.5}, {0, 0, 0.5}, {high.x - low.x, 0, 0}, wall());
        boxes(2);
    }

    /// A face again, turned over and of another material or not. Rounding decides which of two that face the same way
    /// is lit.
    void add_coincident_faces()
    {
        if (!random_.chance(0.25))
            return;
        const SceneFile file = builder_.file();
        for (std::uint32_t k = 1 + random_.below(3); k > 0; --k) {
            const std::uint32_t again = random_.below(static_cast<std::uint32_t>(file.surfaces.size()));
            Surface face = file.surfaces[again];
            if (cross(face.edge_u, face.edge_v).x == 0.0 && cross(face.edge_u, face.edge_v).z == 0.0)
                continue; // something may stand on it: which of three coincident faces is hidden is a matter of taste
            if (mean(file.materials[file.material[again]].reflectance) == 1.0)
                continue; // a gap between white faces traps the walks that gather light
            // Back to back only where lines pass solids: elsewhere they do not tell a sheet from a gap.
            const bool turned = shape_ == closed_room && !two_sided_ && random_.chance(0.5);
            if (turned)
                std::swap(face.edge_u, face.edge_v);
            builder_.surface(face, turned ? wall() : file.material[again]);
        }
        kind_ += ", coincident faces";
    }

    void add_light()
    {
        if (shape_ != closed_room) {
            sky_ = shape_ == convex_body || random_.chance(0.7) ? random_.magnitude(0.1, 100) : 0.0;
            sunny_ = random_.chance(sky_ > 0.0 ? 0.2 : 0.6);
            lamp_ = shape_ != convex_body && ((sky_ == 0.0 && !sunny_) || random_.chance(0.3));
        }
        if (sky_ > 0.0)
            kind_ += ", sky";
        if (sunny_) {
            builder_.sun(sun_at(random_.within(0, 360), random_.within(10, 90), {0, 1, 0}, {20, 18, 15}));
            kind_ += ", sun";
        }
        if (lamp_)
            add_lamps();
    }
    void add_lamps()
    {
        const std::uint32_t lamp =
            builder_.material({0.3, 0.2, 0.0}, {random_.within(1, 9), random_.within(1, 9), random_.within(1, 9)});
        const std::uint32_t count = 1 + random_.below(2);
        for (std::uint32_t k = 0; k < count; ++k) {
            const Vec3 corner = random_.point(0.2 * inside_, 0.7 * inside_) + Vec3{0, 0.25 * inside_.y, 0};
            const Vec3 u = {0.2 * inside_.x, 0, 0};
            const Vec3 v = {0, 0, 0.2 * inside_.z};
            builder_.rectangle(corner, u, v, lamp); // shines down
            if (random_.chance(0.7)) {              // its cover
                // Lines tell a sheet from a gap where they pass solids. Inside of one a lamp would light its cover.
                const bool touches = shape_ == closed_room && !two_sided_ && corner.y > solid_.high.y;
                const Vec3 above = {0, touches ? 0.0 : 0.05 * inside_.y, 0};
                builder_.rectangle(corner + above, v, u, builder_.grey(0.5, 0.0));
            }
        }
        kind_ += ", lamps";
    }

    SceneFile textured(SceneFile file)
    {
        if (shape_ == convex_body || !random_.chance(0.2))
            return file;
        file.textures.push_back(
            std::make_shared<const Texture>("squares.pgm", "P2 3 2 255\n255 20 130\n90 255 60\n", true));
        file.materials[0].texture = 0;
        file.materials[0].texture_scale = {0.9, 0.7, 0.5};
        file.materials[0].reflectance = file.textures[0]->mean() * file.materials[0].texture_scale;
        file.texture_frames.assign(file.surfaces.size(), {{0.1, 0.2}, {2, 0.3}, {-0.2, 1}, true});
        kind_ += ", textured";
        return file;
    }
    SceneFile placed(SceneFile file)
    {
        if (random_.chance(0.3)) {
            const RigidMotion motion(random_.below(1u << 20));
            file = motion.moved(std::move(file));
            kind_ += ", moved and scaled";
        }
        if (random_.chance(0.15)) {
            const double away = random_.magnitude(1e2, 1e5) * length(file.surfaces[0].edge_u);
            for (Surface& surface : file.surfaces)
                surface.origin = surface.origin + away * Vec3{0.3, -0.8, 0.5};
            kind_ += ", far";
        }
        return file;
    }

    struct Maker
    {
        const char* name;
        void (SceneMaker::*make)();
    };
    static constexpr std::uint64_t shapes = 8;
    static constexpr std::uint64_t closed_room = 0;
    static constexpr std::uint64_t sheets = 4;
    static constexpr std::uint64_t convex_body = 5;
    static constexpr std::array<Maker, shapes> makers = {{{"closed room", &SceneMaker::make_closed_room},
                                                          {"open room", &SceneMaker::make_open_room},
                                                          {"buildings", &SceneMaker::make_buildings},
                                                          {"street", &SceneMaker::make_street},
                                                          {"sheets", &SceneMaker::make_sheets},
                                                          {"convex body", &SceneMaker::make_convex_body},
                                                          {"terrain", &SceneMaker::make_terrain},
                                                          {"window", &SceneMaker::make_window}}};

    Random random_;
    std::uint64_t shape_;
    std::uint32_t palette_;
    SceneBuilder builder_;
    std::string kind_;
    Bounds solid_; ///< contains the boxes
    Vec3 inside_;  ///< lamps and boxes are put between the origin and this point
    bool lamp_ = false;
    double sky_ = 0.0; ///< [W/m^2]
    bool sunny_ = false;
    bool two_sided_ = false;
};

} // namespace

RandomScene random_scene(std::uint64_t key, std::uint32_t most_patches)
{
    return SceneMaker(key).scene(most_patches);
}

} // namespace multipath
