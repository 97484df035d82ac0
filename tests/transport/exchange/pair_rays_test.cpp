#include "transport/exchange/pair_rays.h"

#include "base/elementary.h"
#include "geometry/form_factor/exchange_area.h"
#include "sampling/allotment.h"
#include "sampling/random.h"
#include "statistics.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <utility>

namespace pair_rays_test {

using namespace multipath;

namespace {

/// Two unit squares that face each other (0: floor, 1: ceiling) and halfway a sheet over all x < edge. With two sides
/// the squares look away from each other, and it is their backs that see each other.
Scene half_plane(double edge, bool two_sided, double height = 100)
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    const Vec3 x = {1, 0, 0};
    const Vec3 z = {0, 0, 1};
    builder.rectangle({0, 0, 0}, two_sided ? x : z, two_sided ? z : x, grey);
    builder.rectangle({0, height, 0}, two_sided ? z : x, two_sided ? x : z, grey);
    builder.rectangle({-50, 0.5 * height, -50}, {0, 0, 100}, {50 + edge, 0, 0}, grey);
    if (!two_sided)
        builder.rectangle({-50, 0.5 * height, -50}, {50 + edge, 0, 0}, {0, 0, 100}, grey);
    return builder.scene(1000.0, two_sided);
}

/// A room of 72 patches with a box in it.
Scene furnished()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    const std::uint32_t dark = builder.grey(0.2, 0.0);
    return builder.room({0, 0, 0}, {3, 3, 3}, {dark, grey, grey, dark, grey, dark})
        .box({1, 1, 1}, {2, 2, 2}, grey)
        .scene(1.0);
}

/// As if the patches were points at their centres: good enough to tell pairs apart.
PairMatrix<float> rough_exchange(const Scene& scene)
{
    PairMatrix<float> pairs(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        for (std::uint32_t j = 0; j < i; ++j) {
            const Surface a = scene.patch(i).shape;
            const Surface b = scene.patch(j).shape;
            const Vec3 d = b.centre() - a.centre();
            const double cosines = std::max(0.0, dot(a.normal(), d)) * std::max(0.0, -dot(b.normal(), d)) / dot(d, d);
            pairs.at(i, j) = static_cast<float>(a.area() * b.area() * cosines / (std::acos(-1.0) * dot(d, d)));
        }
    return pairs;
}

struct Problem
{
    const Scene& scene;
    PairMatrix<float> unoccluded;
    double crossing_area; ///< [m^2]
    ExchangeEstimate estimate;
    std::vector<Rgb> radiosity;
    Problem(const Scene& of, PairMatrix<float> without_obstacles, double area_per_crossing)
        : scene(of),
          unoccluded(std::move(without_obstacles)),
          crossing_area(area_per_crossing),
          estimate{PairMatrix<float>(of.patch_count()), PairMatrix<float>(of.patch_count())},
          radiosity(of.patch_count(), Rgb{1, 1, 1})
    {
    }
    /// The lines have said that half is free, as uncertain as that is, or that it is surely so.
    void say_half(std::uint32_t i, std::uint32_t j, bool surely)
    {
        const auto exchange = static_cast<double>(unoccluded.at(i, j));
        estimate.exchange.at(i, j) = static_cast<float>(0.5 * exchange);
        estimate.variance.at(i, j) = static_cast<float>(surely ? 0.0 : 0.25 * crossing_area * exchange);
    }
};

/// A third of the pairs is in doubt.
Problem some_doubts(const Scene& scene, double crossing_area)
{
    Problem problem(scene, rough_exchange(scene), crossing_area);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        for (std::uint32_t j = 0; j < i; ++j)
            problem.say_half(i, j, (i + j) % 3 != 0);
    return problem;
}

constexpr double squares_exchange = 0.2; ///< [m^2] as assumed

/// The two squares in doubt after so many lines, nothing else.
Problem squares_in_doubt(const Scene& scene, double lines)
{
    PairMatrix<float> unoccluded(scene.patch_count());
    const std::uint32_t floor = scene.two_sided() ? 3 : 0;
    unoccluded.at(floor + 1, floor) = static_cast<float>(squares_exchange);
    Problem problem(scene, unoccluded, squares_exchange / lines);
    problem.say_half(floor + 1, floor, false);
    return problem;
}

struct Refined
{
    ExchangeEstimate estimate;
    std::uint64_t rays = 0; ///< as counted
};

Refined refined(const Problem& problem, const PairRays& plan, int threads = 2)
{
    std::uint64_t counted = 0;
    ExchangeEstimate result = problem.estimate;
    refine_by_rays(result, problem.scene, problem.unoccluded, problem.crossing_area, problem.radiosity,
                   *make_sequence("random", 5), plan, {threads, [&](std::uint64_t done) { counted += done; }});
    return {std::move(result), counted};
}

/// What rays alone tell of the free share of the two squares: the lines before are worth a thousandth of one.
double found_share(const Scene& scene, const PairRays& plan)
{
    const ExchangeEstimate after = refined(squares_in_doubt(scene, 1e-3), plan).estimate;
    const std::uint32_t floor = scene.two_sided() ? 3 : 0;
    return static_cast<double>(after.exchange.at(floor + 1, floor)) / squares_exchange;
}

bool same(const PairMatrix<float>& a, const PairMatrix<float>& b)
{
    return a.size() == b.size() && std::equal(a.row(0), a.row(a.size()), b.row(0));
}

/// The free share of the pair by the weight cos cos' / r^2 = height^2 / r^4 of lines between Sobol's points.
double free_share(double edge, double height)
{
    double all = 0.0;
    double free = 0.0;
    const auto sequence = make_sequence("sobol", 0);
    for (std::uint64_t n = 0; n < 1u << 14; ++n) {
        const Item item = sequence->item(n);
        const double square = std::pow(item[0] - item[2], 2) + std::pow(item[1] - item[3], 2) + height * height;
        all += 1.0 / (square * square);
        free += 0.5 * (item[0] + item[2]) > edge ? 1.0 / (square * square) : 0.0;
    }
    return free / all;
}

} // namespace

TEST_CASE("the rays counted are the rays of the plan, to within one")
{
    const Scene scene = furnished();
    for (const double crossing_area : {1e-5, 1e-3, 0.1})
        for (const std::uint64_t rays : {1u, 17u, 1000u, 1001u, 20001u}) {
            CAPTURE(crossing_area);
            CAPTURE(rays);
            const std::uint64_t counted = refined(some_doubts(scene, crossing_area), {17, rays, rays}).rays;
            CHECK((counted + 1 >= rays && counted <= rays + 1));
        }
}

// A ray between points u and v passes halfway at (u + v) / 2, which has a triangular distribution: 1 - 2 c^2 of them
// pass beyond c <= 1/2. The squares are so far apart that all rays weigh the same to 2e-4.
TEST_CASE("rays find the share of a pair that a half-plane leaves free")
{
    constexpr std::uint64_t rays = 20000;
    for (const bool two_sided : {false, true})
        for (const double edge : {-0.1, 0.1, 0.25, 0.5}) {
            CAPTURE(two_sided);
            CAPTURE(edge);
            const double share = edge < 0.0 ? 1.0 : 1.0 - 2.0 * edge * edge;
            const double standard_error = std::sqrt(share * (1.0 - share) / rays);
            const double found = found_share(half_plane(edge, two_sided), {17, rays, 1});
            CHECK(std::abs(found - share) < 4.0 * standard_error + 3e-4);
        }
}

// So close, rays are drawn from the solid angle of a patch instead of its points.
TEST_CASE("rays find the share of a near pair that a half-plane leaves free")
{
    CHECK(free_share(0.5, 1.0) == doctest::Approx(0.5).epsilon(1e-3)); // the pair is symmetric
    for (const bool two_sided : {false, true})
        for (const double height : {0.5, 1.0, 3.0}) {
            CAPTURE(two_sided);
            CAPTURE(height);
            const Scene scene = half_plane(0.2, two_sided, height);
            std::vector<double> found;
            for (std::uint64_t run = 0; run < 20; ++run)
                found.push_back(found_share(scene, {1000 * run, 1000, 1}));
            CHECK(estimate(found).agrees_with(free_share(0.2, height)));
            CHECK(estimate(found).standard_error < 0.01); // not because it is all noise
        }
}

// m rays and a first estimate that was worth lambda lines: a mean of both with the weights m and lambda.
TEST_CASE("rays and lines count by their numbers, and the variance falls to lambda / (lambda + m)")
{
    const Scene scene = half_plane(-0.1, false); // all rays are free
    for (const double lambda : {1.0, 50.0, 1000.0})
        for (const std::uint64_t m : {1u, 100u, 5000u}) {
            CAPTURE(lambda);
            CAPTURE(m);
            const Refined after = refined(squares_in_doubt(scene, lambda), {17, m, 1});
            const double left = lambda / (lambda + static_cast<double>(after.rays)); // m, or one more or less
            const double before = 0.25 * squares_exchange * squares_exchange / lambda;
            CHECK(static_cast<double>(after.estimate.variance.at(1, 0)) ==
                  doctest::Approx(left * before).epsilon(1e-6));
            CHECK(static_cast<double>(after.estimate.exchange.at(1, 0)) ==
                  doctest::Approx((1.0 - 0.5 * left) * squares_exchange).epsilon(1e-6));
        }
}

TEST_CASE("pairs without doubt get no rays and keep their bits")
{
    const Scene scene = furnished();
    const ExchangeEstimate before = some_doubts(scene, 0.01).estimate;
    const ExchangeEstimate after = refined(some_doubts(scene, 0.01), {17, 5000, 1}).estimate;
    int changed = 0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        for (std::uint32_t j = 0; j <= i; ++j)
            if (before.variance.at(i, j) == 0.0f) {
                CHECK(after.exchange.at(i, j) == before.exchange.at(i, j));
                CHECK(after.variance.at(i, j) == 0.0f);
            } else {
                CHECK(after.variance.at(i, j) <= before.variance.at(i, j));
                changed += after.variance.at(i, j) < before.variance.at(i, j) ? 1 : 0;
            }
    CHECK(changed > 100);
}

// What is smallest for a given number of rays: lines and rays of a pair in proportion to s times the root of
// rho_i^2 B_j^2 / A_i + rho_j^2 B_i^2 / A_j, summed over the colours, with s^2 the variance by one of them. All pairs
// want more than they have, so that the level is exact; rounding to whole rays leaves 1 in 1000.
TEST_CASE("rays are shared as the error to be expected asks for")
{
    SceneBuilder builder;
    builder.rectangle({0, 0, 0}, {0, 0, 2}, {3, 0, 0}, builder.material({0.9, 0.1, 0.4}, {}));                 // floor
    builder.triangle({0, 1, 0}, {0.5, 1, 0}, {0, 1, 0.7}, builder.material({0.0, 0.5, 0.2}, {0.3, 0.0, 9.0})); // down
    builder.rectangle({-1, 0.2, 0}, {0, 0.5, 0}, {0, 0, 2}, builder.material({0.3, 0.8, 0.0}, {}));  // along x
    builder.rectangle({4, 0.1, 0}, {0, 0, 0.7}, {0, 0.4, 0}, builder.material({0.7, 0.0, 0.6}, {})); // -x
    const Scene scene = builder.scene(10.0);
    Problem problem(scene, rough_exchange(scene), 1e-4);
    problem.radiosity = {{3.0, 2.0, 1.0}, {0.5, 0.0, 9.0}, {0.0, 7.0, 2.0}, {4.0, 0.3, 0.8}};
    struct Doubt
    {
        std::uint32_t i;
        std::uint32_t j;
        double spread; ///< share (1 - share) for the share that is free: the variance by one line
    };
    const std::vector<Doubt> doubts = {{1, 0, 0.25}, {2, 0, 0.09}, {3, 0, 0.16}, {3, 2, 0.21}};
    std::vector<double> deserved;
    for (const Doubt& doubt : doubts) {
        const auto exchange = static_cast<double>(problem.unoccluded.at(doubt.i, doubt.j));
        REQUIRE(exchange > 0.0);
        problem.estimate.variance.at(doubt.i, doubt.j) =
            static_cast<float>(doubt.spread * exchange * problem.crossing_area);
        const auto part = [&](std::uint32_t to, std::uint32_t from) {
            const Rgb reflected = scene.reflectance(to) * problem.radiosity[from];
            return 3.0 * mean(reflected * reflected) / scene.area(to);
        };
        deserved.push_back(exchange * std::sqrt(doubt.spread * (part(doubt.i, doubt.j) + part(doubt.j, doubt.i))));
    }
    const ExchangeEstimate after = refined(problem, {17, 200000, 1}).estimate;
    std::vector<double> known; // lines and rays of each pair
    for (const Doubt& doubt : doubts) {
        const double lines = static_cast<double>(problem.unoccluded.at(doubt.i, doubt.j)) / problem.crossing_area;
        known.push_back(lines * static_cast<double>(problem.estimate.variance.at(doubt.i, doubt.j)) /
                        static_cast<double>(after.variance.at(doubt.i, doubt.j)));
    }
    for (std::size_t k = 1; k < doubts.size(); ++k)
        CHECK(known[k] / known[0] == doctest::Approx(deserved[k] / deserved[0]).epsilon(2e-3).scale(0.0));
}

TEST_CASE("without rays, doubts or light nothing changes")
{
    const Scene scene = furnished();
    const auto unchanged = [&](const Problem& problem, std::uint64_t rays) {
        const Refined after = refined(problem, {17, rays, 1});
        return after.rays == 0 && same(after.estimate.exchange, problem.estimate.exchange) &&
               same(after.estimate.variance, problem.estimate.variance);
    };
    const Problem doubtful = some_doubts(scene, 0.01);
    CHECK_FALSE(unchanged(doubtful, 1000));
    CHECK(unchanged(doubtful, 0));
    Problem certain = doubtful;
    certain.estimate.variance = PairMatrix<float>(scene.patch_count());
    CHECK(unchanged(certain, 1000));
    Problem dark = doubtful;
    dark.radiosity.assign(scene.patch_count(), Rgb{});
    CHECK(unchanged(dark, 1000));
    const Scene two_squares = half_plane(0.25, false);
    CHECK(unchanged(squares_in_doubt(two_squares, 2.0), 0)); // a single doubt has what it deserves to the last bit
}

TEST_CASE("every number of threads refines to the same bits")
{
    const Scene scene = furnished();
    const Problem problem = some_doubts(scene, 0.01);
    const Refined one = refined(problem, {17, 5000, 1}, 1);
    for (const int threads : {2, 7}) {
        const Refined more = refined(problem, {17, 5000, 1}, threads);
        CHECK(more.rays == one.rays);
        CHECK(same(more.estimate.exchange, one.estimate.exchange));
        CHECK(same(more.estimate.variance, one.estimate.variance));
    }
}

// The weights of rays between two patches average to the exchange between them: A_1 A_2 / pi times the mean of
// cos cos' / r^2 over pairs of points, or A_1 / pi times the mean of solid angle times cosine.

namespace {

Scene two_patches(const Surface& one, const Surface& other)
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    return builder.surface(one, grey).surface(other, grey).scene(1e6);
}

/// Mean and standard error of the weights, and the largest one.
struct Weights
{
    Estimate mean;
    double largest;
};

Weights weights(const Scene& scene)
{
    const RayPair pair(scene, 0, 1);
    const std::unique_ptr<Sequence> random = make_sequence("random", 7);
    std::vector<double> samples;
    for (std::uint64_t k = 0; k < 100000; ++k)
        samples.push_back(pair.ray(random->item(k)).weight);
    return {estimate(samples), *std::max_element(samples.begin(), samples.end())};
}

const Surface unit_square = {Shape::parallelogram, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}}; // looks to +y

} // namespace

TEST_CASE("far from each other, the mean weight is the exchange over both areas")
{
    for (const Shape shape : {Shape::parallelogram, Shape::triangle}) {
        const Surface other = {shape, {1, 5, 0}, {2, 0.5, 0}, {0, 0, 1}};
        const Scene scene = two_patches(unit_square, other);
        const double exact = pi * exchange_area(unit_square, other, 1e-9) / (scene.area(0) * scene.area(1));
        CHECK(exact > 0.0);
        CHECK(weights(scene).mean.agrees_with(exact));
    }
}

TEST_CASE("of patches that touch, the mean weight is the exchange over the smaller area, and none exceeds pi")
{
    for (const Shape shape : {Shape::parallelogram, Shape::triangle}) {
        const Surface wall = {shape, {0, 0, 0}, {0.9, 0, 0}, {0, 0.8, 0}}; // shares an edge, looks to +z
        const Scene scene = two_patches(unit_square, wall);
        const Weights found = weights(scene);
        const double smaller = std::min(scene.area(0), scene.area(1));
        CHECK(found.mean.agrees_with(pi * exchange_area(unit_square, wall, 1e-9) / smaller));
        CHECK(found.largest <= pi * (1.0 + 1e-12));
    }
}

TEST_CASE("patches that are turned away from each other have no ray of any weight")
{
    const Surface behind = {Shape::parallelogram, {0, -1, 0}, {0, 0, 1}, {1, 0, 0}};
    CHECK(weights(two_patches(unit_square, behind)).largest == 0.0);
}

namespace {

struct KnownPatch
{
    double importance;
    double lines;
};

/// Importance and lines spread over so many powers of ten; every eighth patch is empty.
std::vector<KnownPatch> some_patches(std::uint64_t key, std::size_t count, double spread)
{
    std::vector<KnownPatch> patches;
    for (std::size_t k = 0; k < count; ++k) {
        const auto power = [&](std::uint64_t counter) {
            return std::pow(10.0, spread * (bits_to_unit(random_bits(key, counter)) - 0.5));
        };
        patches.push_back({power(2 * k), k % 8 == 0 ? 0.0 : power(2 * k + 1)});
    }
    return patches;
}

double poured(const std::vector<KnownPatch>& patches, double level)
{
    double sum = 0.0;
    for (const KnownPatch& patch : patches)
        sum += std::max(0.0, level * patch.importance - patch.lines);
    return sum;
}

/// The level by bisection of its definition.
double exact_level(const std::vector<KnownPatch>& patches, double rays)
{
    double low = 0.0;
    double high = 1.0;
    while (poured(patches, high) < rays)
        high *= 2.0;
    for (int step = 0; step < 200; ++step) {
        const double middle = 0.5 * (low + high);
        (poured(patches, middle) < rays ? low : high) = middle;
    }
    return high;
}

WaterFilling filled(const std::vector<KnownPatch>& patches)
{
    WaterFilling level;
    for (const KnownPatch& patch : patches)
        level.add(patch.importance, patch.lines);
    return level;
}

} // namespace

// Depths are told apart by a sixteenth. Within the class of the true level some patches count as reached that are not:
// the level found lies in the same class, above the true one.
TEST_CASE("the level is the one of the definition, at most a sixteenth above")
{
    for (std::uint64_t key = 1; key <= 20; ++key)
        for (const double spread : {0.1, 2.0, 8.0})
            for (const double rays : {1e-2, 1.0, 1e3, 1e6}) {
                CAPTURE(key);
                CAPTURE(spread);
                CAPTURE(rays);
                const std::vector<KnownPatch> patches = some_patches(key, 100, spread);
                const double exact = exact_level(patches, rays);
                const double level = filled(patches).level(rays);
                CHECK(level >= exact * (1.0 - 1e-12));
                CHECK(level <= exact * (1.0 + 1.0 / 16.0));
            }
}

// The worst case: nearly all the importance is just above the level, as deep as the class goes or a little deeper.
TEST_CASE("patches just above the level raise it by a sixteenth at most")
{
    for (const double depth : {1.02, 1.06, 1.1, 1.12, 1.18, 1.24}) {
        CAPTURE(depth);
        const std::vector<KnownPatch> patches = {{1.0, 1.0}, {100.0, 100.0 * depth}};
        const double level = filled(patches).level(0.01); // 1.01 by the definition
        CHECK(level >= 1.01 * (1.0 - 1e-12));
        CHECK(level <= 1.01 * (1.0 + 1.0 / 16.0));
    }
}

// Only the patches of one class of depths are misjudged, one of dozens when they are spread over orders of magnitude.
TEST_CASE("the patches take the rays together, to a few percent")
{
    for (std::uint64_t key = 1; key <= 20; ++key)
        for (const double rays : {1e2, 1e4, 1e6}) {
            CAPTURE(key);
            CAPTURE(rays);
            const std::vector<KnownPatch> patches = some_patches(key, 1000, 6.0);
            CHECK(poured(patches, filled(patches).level(rays)) == doctest::Approx(rays).epsilon(0.03));
        }
}

TEST_CASE("one patch takes all rays, and none has no level")
{
    for (const KnownPatch patch :
         {KnownPatch{3.0, 0.0}, KnownPatch{3.0, 6.0}, KnownPatch{1e-9, 1e6}, KnownPatch{1e9, 1e-6}}) {
        CAPTURE(patch.importance);
        const double level = filled({patch}).level(60.0);
        CHECK(level == doctest::Approx((60.0 + patch.lines) / patch.importance).epsilon(1e-12));
    }
    CHECK(WaterFilling().level(60.0) == 0.0);
}

// Depth 0 for both: 30 rays in proportion to the importance. Depths 0 and 100: nothing for the second until the first
// has reached 100.
TEST_CASE("empty patches share in proportion, full ones wait")
{
    CHECK(filled({{1.0, 0.0}, {2.0, 0.0}}).level(30.0) == doctest::Approx(10.0).epsilon(1e-12));
    CHECK(filled({{1.0, 0.0}, {2.0, 200.0}}).level(90.0) == doctest::Approx(90.0).epsilon(1e-12));
    CHECK(filled({{1.0, 0.0}, {2.0, 200.0}}).level(130.0) == doctest::Approx(110.0).epsilon(1e-12));
}

// Sums of doubles in another order: 1e-12.
TEST_CASE("patches added in parts are all there")
{
    const std::vector<KnownPatch> patches = some_patches(5, 100, 4.0);
    WaterFilling sum = filled({patches.begin(), patches.begin() + 37});
    sum.add(filled({patches.begin() + 37, patches.end()}));
    CHECK(sum.level(50.0) == doctest::Approx(filled(patches).level(50.0)).epsilon(1e-12));
}

} // namespace pair_rays_test
