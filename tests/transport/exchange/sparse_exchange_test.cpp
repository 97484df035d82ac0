#include "transport/exchange/sparse_exchange.h"

#include "scene/daylight.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numeric>

namespace sparse_exchange_test {

using namespace multipath;

namespace {

/// Rays per patch, twice as many of every third.
std::vector<double> rays_of_patches(const Scene& scene, double rays)
{
    std::vector<double> result;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        result.push_back(i % 3 == 0 ? 2.0 * rays : rays);
    return result;
}

struct Counted
{
    LineCounts counts;
    std::vector<double> cast; ///< rays that left each patch

    double lost(std::uint32_t i) const { return static_cast<double>(counts.escaped(i) + counts.behind(i)); }
};

std::vector<std::uint32_t> sides(const Scene& scene)
{
    std::vector<std::uint32_t> result;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        result.push_back(scene.surface_of(i));
    return result;
}

Counted counted(const Scene& scene, const std::vector<double>& expected, std::uint64_t seed = 0)
{
    const Allotment rays(expected, 0.5);
    Counted result{LineCounts(scene.patch_count()), {}};
    ShardRange range = ShardRange::of(ray_blocks(rays).count(), {});
    count_rays(scene, rays, *make_sequence(seed == 0 ? "sobol" : "sobol-owen", seed), 0, range, {2}, result.counts);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        result.cast.push_back(static_cast<double>(rays.rays_of(i)));
    return result;
}

Counted counted(const Scene& scene, double rays_per_patch)
{
    return counted(scene, rays_of_patches(scene, rays_per_patch));
}

/// A room with a box in it and without one wall.
Scene open_room()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.room({0, 0, 0}, {1, 1, 1}, grey).box({0.2, 0.2, 0.2}, {0.5, 0.6, 0.7}, grey);
    SceneFile file = builder.file();
    file.surfaces.erase(file.surfaces.begin() + 5);
    file.material.pop_back();
    file.group.pop_back();
    file.line.pop_back();
    return Scene(file, 0.1);
}

} // namespace

TEST_CASE(
    "the product with a counted exchange is symmetric, the same bits for any number of threads, and loses nothing")
{
    const Scene scene = open_room();
    for (const double rays : {1000.0, 0.6}) // of few, some patches have none
        for (const double unseen_rays : {0.0, 1.0}) {
            CAPTURE(rays);
            CAPTURE(unseen_rays);
            const Counted all = counted(scene, rays);
            const SparseExchange exchange(all.counts, scene.areas(), all.cast, sides(scene), {}, unseen_rays, 2);
            std::vector<Rgb> x;
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
                x.push_back({1.0, std::sin(i), 1.0 / (1.0 + i)});

            const std::vector<Rgb> y = exchange.apply(x, 1);
            CHECK(exchange.apply(x, 2) == y);
            CHECK(exchange.apply(x, 7) == y);
            double there = 0.0;
            double back = 0.0;
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
                // Whatever leaves the patch arrives, escapes or is lost.
                CHECK(y[i].r + exchange.escaping(i) + exchange.behind(i) ==
                      doctest::Approx(scene.area(i)).epsilon(1e-12));
                CHECK(y[i].b >= 0.0);
                there += x[i].b * y[i].g;
                back += x[i].g * y[i].b;
            }
            CHECK(there == doctest::Approx(back).epsilon(1e-7)); // light is multiplied in single precision
        }
}

// The oracle is the count of each pair: with thousands of rays per patch the factors are 1 to a few percent.
TEST_CASE("with many rays a counted exchange is what the rays counted, and they have seen nearly all of it")
{
    const Scene scene = open_room();
    const Counted all = counted(scene, 3000.0);
    const SparseExchange exchange(all.counts, scene.areas(), all.cast, sides(scene), {}, 0.0, 2);
    double escaping = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        CHECK(exchange.behind(i) == 0.0);
        escaping += exchange.escaping(i);
    }
    CHECK(escaping ==
          doctest::Approx(1.0).epsilon(0.005)); // area of the wall; a million rays, a fifth of them through it
    std::vector<Rgb> one(scene.patch_count());
    for (const std::uint32_t j : {0u, 77u, 301u}) {
        one[j] = {1.0, 1.0, 1.0};
        const std::vector<Rgb> column = exchange.apply(one, 2);
        one[j] = {};
        const CountRow row = all.counts.row(j);
        for (const std::uint32_t i : row) {
            const double rays = static_cast<double>(std::count(row.first, row.last, i));
            CHECK(column[i].g == doctest::Approx(rays / (all.cast[j] / scene.area(j) + all.cast[i] / scene.area(i)))
                                     .epsilon(0.1)
                                     .scale(1e-4 * scene.area(j)));
        }
    }
}

TEST_CASE("patches that few rays join only with each other still exchange light with all others")
{
    const Scene scene = open_room();
    const Counted few = counted(scene, 0.3);
    const SparseExchange exchange(few.counts, scene.areas(), few.cast, sides(scene), {}, 1.0, 2);
    std::vector<Rgb> one(scene.patch_count());
    one[5] = {1.0, 1.0, 1.0};
    for (const Rgb y : exchange.apply(one, 2))
        CHECK(y.r > 0.0);
}

// A plate before which there is but a speck: if its rays did not tell that the rest is open, the speck would have to
// fill the hemispheres of a plate 10^4 to 10^8 times as large. No factors exist for that.
TEST_CASE("where no exchange fills all areas, no patch exchanges more than its own")
{
    for (const double size : {0.1, 0.01, 0.001}) {
        CAPTURE(size);
        SceneBuilder builder;
        const std::uint32_t grey = builder.grey(0.5, 1.0);
        builder.rectangle({0, 0, 0}, {0, 0, 10}, {10, 0, 0}, grey);
        builder.rectangle({5, 1, 5}, {size, 0, 0}, {0, 0, size}, grey);
        const Scene scene = builder.scene(0.25);
        const Counted all = counted(scene, 64.0);
        std::vector<Segment> joined;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            for (const std::uint32_t j : all.counts.row(i))
                if (j < i)
                    joined.push_back({i, j});
        LineCounts without_losses(scene.patch_count());
        without_losses.add(joined);
        without_losses.merge(1);
        const SparseExchange exchange(without_losses, scene.areas(), all.cast, sides(scene), {}, 0.0, 2);
        const std::vector<Rgb> y = exchange.apply(std::vector<Rgb>(scene.patch_count(), Rgb{1, 1, 1}), 2);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            CHECK(y[i].g >= 0.0);
            CHECK((y[i].g + exchange.escaping(i) + exchange.behind(i)) / scene.area(i) ==
                  doctest::Approx(1.0).epsilon(1e-6));
        }
    }
}

TEST_CASE("an exchange is the same in any unit of length and of light")
{
    const Scene scene = open_room();
    const Counted all = counted(scene, 20.0);
    const SparseExchange exchange(all.counts, scene.areas(), all.cast, sides(scene), {}, 0.0, 2);
    std::vector<Rgb> x;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        x.push_back({1.0, 2.0 + std::sin(i), 1e-3 / (1.0 + i)});
    const std::vector<Rgb> y = exchange.apply(x, 2);
    for (const double length : {1e-30, 1e30})
        for (const double light : {1e-90, 1e90}) {
            CAPTURE(length);
            CAPTURE(light);
            std::vector<double> area = scene.areas();
            std::vector<Rgb> scaled;
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
                area[i] *= length * length;
                scaled.push_back(light * x[i]);
            }
            const std::vector<Rgb> result =
                SparseExchange(all.counts, area, all.cast, sides(scene), {}, 0.0, 2).apply(scaled, 2);
            for (std::uint32_t i = 0; i < scene.patch_count(); i += 7) {
                CHECK(result[i].g == doctest::Approx(length * length * light * y[i].g).epsilon(1e-5));
                CHECK(result[i].b == doctest::Approx(length * length * light * y[i].b).epsilon(1e-5));
            }
        }
}

// A sheet with one face stands before the open wall: light escapes, and is lost behind the sheet.
TEST_CASE("a patch without rays of its own loses as much of its light each way as all others together")
{
    SceneFile file = open_room().file();
    file.surfaces.push_back({Shape::parallelogram, {0.1, 0.15, 0.8}, {0.75, 0, 0}, {0, 0.7, 0.1}});
    for (auto* list : {&file.material, &file.group, &file.line})
        list->push_back(0);
    const Scene scene(file, 0.1);
    std::vector<double> rays = rays_of_patches(scene, 20.0);
    for (std::size_t i = 0; i < rays.size(); i += 5)
        rays[i] = 0.0;
    const Counted all = counted(scene, rays);
    double escaped = 0.0;
    double lost = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        escaped += static_cast<double>(all.counts.escaped(i));
        lost += all.lost(i);
    }
    CHECK(escaped > 0.3 * lost);
    CHECK(escaped < 0.8 * lost);
    const SparseExchange exchange(all.counts, scene.areas(), all.cast, sides(scene), {}, 0.0, 2);
    int losing = 0; // the rays of the others fill some rows
    for (std::uint32_t i = 0; i < rays.size(); i += 5)
        if (const double area = exchange.escaping(i) + exchange.behind(i); area > 0.0) {
            ++losing;
            CHECK(exchange.escaping(i) == doctest::Approx(area * escaped / lost).epsilon(1e-9).scale(0.0));
        }
    CHECK(losing > 50);
}

// As in a dim room that many rays from outside reach: the rays of others fill the rows, up to noise, whatever the few
// own rays of the patches have lost.
TEST_CASE("sides whose patches cast few rays lose what these rays have lost on the mean")
{
    const Scene scene = open_room();
    for (const double few : {3.0, 6.0}) {
        std::vector<double> rays(scene.patch_count(), 100.0);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            if (scene.surface_of(i) < 3)
                rays[i] = few;
        double lost[3] = {};
        double by_own_rays[3] = {};
        for (std::uint64_t seed = 1; seed <= 16; ++seed) {
            const Counted all = counted(scene, rays, seed);
            const SparseExchange exchange(all.counts, scene.areas(), all.cast, sides(scene), {}, 0.0, 2);
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
                if (const std::uint32_t side = scene.surface_of(i); side < 3) {
                    lost[side] += exchange.escaping(i) + exchange.behind(i);
                    by_own_rays[side] += scene.area(i) * all.lost(i) / all.cast[i];
                }
        }
        for (int side = 0; side < 3; ++side) {
            CAPTURE(few);
            CAPTURE(side);
            CAPTURE(by_own_rays[side]);
            CHECK(lost[side] == doctest::Approx(by_own_rays[side]).epsilon(0.1).scale(0.0));
        }
    }
}

// A small bright sill casts far more rays than the wall that it faces. The noise of the wall's few rays must not get
// into what the many rays of the sill say of the exchange between the two.
TEST_CASE("what many rays of one patch say is not scaled by the noise of the few of another")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.room({0, 0, 0}, {1, 1, 1}, grey);
    builder.rectangle({0.4, 0.3, 0.4}, {0, 0, 0.2}, {0.2, 0, 0}, grey);
    const Scene scene = builder.scene(0.1);
    const auto is_sill = [&](std::uint32_t i) { return scene.surface_of(i) == 6; };
    std::vector<double> rays(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        rays[i] = is_sill(i) ? 2000.0 : 6.0;
    double squares = 0.0;
    double differences = 0.0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Counted all = counted(scene, rays, seed);
        const SparseExchange exchange(all.counts, scene.areas(), all.cast, sides(scene), {}, 0.0, 2);
        std::vector<Rgb> light(scene.patch_count());
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            if (is_sill(i))
                light[i] = {1.0, 1.0, 1.0};
        const std::vector<Rgb> y = exchange.apply(light, 2);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            if (is_sill(i))
                continue;
            double by_rays = 0.0; // nearly all of the sill's
            for (const std::uint32_t j : all.counts.row(i))
                by_rays += is_sill(j) ? 1.0 / (all.cast[i] / scene.area(i) + all.cast[j] / scene.area(j)) : 0.0;
            squares += by_rays * by_rays;
            differences += (y[i].g - by_rays) * (y[i].g - by_rays);
        }
    }
    CHECK(std::sqrt(differences / squares) < 0.01);
}

// Between the two is a plate in the open, all of whose rays are lost. Each patch is the only one of its surface, or the
// surfaces are those of the scene.
TEST_CASE("a closed room beside one that loses light keeps its own")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.room({0, 0, 0}, {1, 1, 1}, grey).box({0.2, 0.2, 0.2}, {0.5, 0.6, 0.7}, grey);
    const std::size_t closed = builder.file().surfaces.size();
    builder.rectangle({1.1, 3, 0.2}, {0, 0, 0.3}, {0.3, 0, 0}, grey);
    const Scene open = open_room();
    for (const Surface& surface : open.surfaces())
        builder.surface({surface.shape, surface.origin + Vec3{2, 0, 0}, surface.edge_u, surface.edge_v}, grey);
    const Scene scene = builder.scene(0.1);
    const Counted all = counted(scene, 16.0);
    std::vector<std::uint32_t> alone(scene.patch_count());
    std::iota(alone.begin(), alone.end(), 0u);
    for (const std::vector<std::uint32_t>& side : {alone, sides(scene)}) {
        const SparseExchange exchange(all.counts, scene.areas(), all.cast, side, {}, 0.0, 2);
        double lost[3] = {}; // by the closed room, the plate and the open room
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const std::uint32_t surface = scene.surface_of(i);
            lost[surface < closed ? 0 : surface == closed ? 1 : 2] += exchange.escaping(i) + exchange.behind(i);
        }
        CHECK(lost[0] < 1e-9);
        CHECK(lost[1] == doctest::Approx(0.09).epsilon(1e-6));
        CHECK(lost[2] > 0.5);
    }
}

// A sheet with one face hides a part of what is outside, and its back takes light. The oracle is the definition: for
// each patch the second term of Returns sums to zero over its rays. What is lost behind the sheet had brought nothing.
TEST_CASE("what a ray takes away too much the other rays take away too little, below a sky and without one")
{
    SceneFile open = open_room().file();
    open.surfaces.push_back({Shape::parallelogram, {0.1, 0.15, 1.1}, {0.75, 0, 0}, {0, 0.7, 0.1}});
    for (auto* list : {&open.material, &open.group, &open.line})
        list->push_back(0);
    for (const bool has_sky : {false, true}) {
        CAPTURE(has_sky);
        SceneFile file = open;
        if (has_sky)
            add_sky(file, {1, 1, 1});
        const Scene scene(file, 0.13);
        std::vector<std::uint32_t> sky;
        std::vector<double> rays = rays_of_patches(scene, 9.0);
        std::vector<Rgb> radiosity;
        std::vector<Rgb> reflectance;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            const bool is_sky = scene.is_sky_patch(i);
            radiosity.push_back(is_sky ? Rgb{7.0, 0.0, 3.0} : Rgb{1.0 + 0.01 * i, 2.0 + std::sin(i), 1.0});
            reflectance.push_back(is_sky ? Rgb{} : Rgb{0.9, 0.5, i % 2 == 0 ? 0.0 : 0.4});
            if (is_sky) {
                sky.push_back(i);
                rays[i] = 0.0;
            }
        }
        const Counted all = counted(scene, rays);
        const SparseExchange exchange(all.counts, scene.areas(), all.cast, sides(scene), sky, 0.0, 2);
        const SparseExchange::Returns returns = exchange.returns(radiosity, reflectance, 2);
        for (double Rgb::*c : {&Rgb::r, &Rgb::g, &Rgb::b}) {
            double sum = returns.escaped.*c + returns.behind.*c;
            double sizes = 0.0;
            for (const Rgb& incident : returns.incident) {
                sum += incident.*c;
                sizes += std::abs(incident.*c);
            }
            CHECK(std::abs(sum) < 1e-5 * sizes); // light is multiplied in single precision
            CHECK(returns.behind.*c > 1e-3 * sizes);
            CHECK((returns.escaped.*c != 0.0) == !has_sky);
        }
    }
}

// With the radiosity of all and of the sky equal, all rays of a patch bring the same, be they many or one.
TEST_CASE("in a furnace, also below a sky as bright, the ray that brings light takes as much away as any other")
{
    SceneFile file = open_room().file();
    add_sky(file, {1, 1, 1});
    for (const double rays : {20.0, 0.7}) {
        const Scene scene(file, rays < 1.0 ? 0.05 : 0.1);
        std::vector<std::uint32_t> sky;
        std::vector<double> expected = rays_of_patches(scene, rays);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            if (scene.is_sky_patch(i)) {
                expected[i] = 0.0;
                sky.push_back(i);
            }
        const Counted all = counted(scene, expected);
        const SparseExchange exchange(all.counts, scene.areas(), all.cast, sides(scene), sky, 0.0, 2);
        CHECK(exchange.lost_area() > 0.5);
        const std::vector<Rgb> one(scene.patch_count(), Rgb{1, 1, 1});
        const SparseExchange::Returns returns =
            exchange.returns(one, std::vector<Rgb>(scene.patch_count(), Rgb{0.5, 0.2, 0.9}), 2);
        Rgb sum = returns.escaped + returns.behind;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            CHECK(std::abs(returns.incident[i].r) < 1e-6 * scene.area(i));
            CHECK(std::abs(returns.incident[i].b) < 1e-6 * scene.area(i));
            sum += returns.incident[i];
        }
        CHECK(std::abs(sum.b) < 1e-6);
    }
}

} // namespace sparse_exchange_test
