#include "transport/exchange/exchange_estimate.h"

#include "statistics.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace exchange_estimate_test {

using namespace multipath;

namespace {

/// A floor and a ceiling of 4 x 4 patches at distance 2, and a sheet of two faces halfway between, at 0 < x < width.
/// All patches are parallel, so that their exchange without obstacles has a closed form.
Scene storeys(double width)
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 4}, {4, 0, 0}, grey).rectangle({0, 2, 0}, {4, 0, 0}, {0, 0, 4}, grey);
    if (width > 0.0) {
        builder.rectangle({0, 1, 0}, {0, 0, 4}, {width, 0, 0}, grey);
        builder.rectangle({0, 1, 0}, {width, 0, 0}, {0, 0, 4}, grey);
    }
    return builder.scene(1.0);
}

constexpr std::uint32_t ceiling = 16; ///< number of its first patch; the floor's is 0

/// Exchange area of two horizontal rectangles h apart: the integral of h^2 / (pi r^4) over both, in closed form from
/// the differences of their ends (catalogue of view factors, C-13).
double parallel_exchange(const Bounds& a, const Bounds& b)
{
    const double h = std::abs(a.low.y - b.low.y);
    const auto integral = [&](double x, double z) {
        const double across_x = std::sqrt(x * x + h * h);
        const double across_z = std::sqrt(z * z + h * h);
        return z * across_x * std::atan(z / across_x) + x * across_z * std::atan(x / across_z) -
               0.5 * h * h * std::log(x * x + z * z + h * h);
    };
    double sum = 0.0;
    for (int corner = 0; corner < 16; ++corner) {
        const auto end = [&](int bit, double low, double high) { return (corner >> bit & 1) != 0 ? high : low; };
        const double x = end(0, a.low.x, a.high.x) - end(1, b.low.x, b.high.x);
        const double z = end(2, a.low.z, a.high.z) - end(3, b.low.z, b.high.z);
        const int ends = (corner & 1) + (corner >> 1 & 1) + (corner >> 2 & 1) + (corner >> 3 & 1);
        sum += (ends % 2 == 0 ? 1.0 : -1.0) * integral(x, z);
    }
    return sum / (2.0 * std::acos(-1.0));
}

PairMatrix<float> unoccluded_exchange_of(const Scene& scene)
{
    PairMatrix<float> pairs(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        for (std::uint32_t j = 0; j < i; ++j) {
            const Surface a = scene.patch(i).shape;
            const Surface b = scene.patch(j).shape;
            const double rise = b.origin.y - a.origin.y;
            if (a.normal().y * rise > 0.0 && b.normal().y * rise < 0.0)
                pairs.at(i, j) = static_cast<float>(parallel_exchange(a.bounds(), b.bounds()));
        }
    return pairs;
}

struct Case
{
    const Scene& scene;
    PairMatrix<float> unoccluded;
    GlobalLines lines;

    explicit Case(const Scene& of) : scene(of), unoccluded(unoccluded_exchange_of(of)), lines(of.bounds(), Chords::box)
    {
    }
    double crossing_area(std::uint64_t cast) const { return 1.0 / lines.expected_crossings(1.0, cast); }
    ExchangeEstimate estimate(std::uint64_t cast, std::uint64_t seed, int threads = 2) const
    {
        const PairCounts counts = count_pairs(scene, lines, *make_sequence("random", seed), 0, cast, {threads});
        return estimate_exchange(scene, unoccluded, counts, crossing_area(cast), threads);
    }
};

/// The part of a floor-to-ceiling pair's exchange that passes the sheet: mean over rays between Sobol's points, whose
/// error, for a step function in four dimensions, is below 1e-3 of it with so many.
double free_exchange(const Surface& floor_patch, const Surface& ceiling_patch, double width)
{
    constexpr std::uint64_t rays = 1u << 16;
    std::vector<Item> items(rays);
    make_sequence("sobol", 0)->generate(0, items);
    double sum = 0.0;
    for (const Item& item : items) {
        const Vec3 x = floor_patch.at(item[0], item[1]);
        const Vec3 y = ceiling_patch.at(item[2], item[3]);
        const double square = dot(y - x, y - x);
        if (0.5 * (x.x + y.x) > width)
            sum += 4.0 / (square * square); // both cosines are 2 / r
    }
    return floor_patch.area() * ceiling_patch.area() * sum / (std::acos(-1.0) * static_cast<double>(rays));
}

struct Pair
{
    std::uint32_t floor;
    std::uint32_t ceiling;
    double exact; ///< [m^2]
    double share; ///< that is free

    bool half_hidden() const { return share > 0.05 && share < 0.95; }
};

std::vector<Pair> pairs_of_storeys(const Case& problem, double width)
{
    std::vector<Pair> pairs;
    for (std::uint32_t i = 0; i < 16; ++i)
        for (std::uint32_t j = ceiling; j < 32; ++j) {
            const double exact = free_exchange(problem.scene.patch(i).shape, problem.scene.patch(j).shape, width);
            pairs.push_back({i, j, exact, exact / static_cast<double>(problem.unoccluded.at(i, j))});
        }
    return pairs;
}

} // namespace

// The oracle of the following, checked: facing unit squares at distance 1 exchange 0.199825 (tables of view factors).
TEST_CASE("the closed form of parallel rectangles gives the tabulated exchange of facing squares")
{
    const Surface low = {Shape::parallelogram, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    const Surface high = {Shape::parallelogram, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
    CHECK(parallel_exchange(low.bounds(), high.bounds()) == doctest::Approx(0.199825).epsilon(1e-6));
}

TEST_CASE("pairs with nothing in between exchange what they would without obstacles, to the last bit")
{
    const Scene scene = storeys(0.0);
    const Case problem(scene);
    for (const std::uint64_t cast : {1u, 100u, 20000u}) {
        CAPTURE(cast);
        const ExchangeEstimate estimate = problem.estimate(cast, 1);
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            for (std::uint32_t j = 0; j <= i; ++j)
                CHECK(estimate.exchange.at(i, j) == problem.unoccluded.at(i, j));
    }
}

// What remains is the share that stands for lines not cast, at each level one line's worth of the larger blocks: below
// a hundredth of the exchange here, and below the noise that the variance claims.
TEST_CASE("hidden pairs exchange nothing beyond the noise")
{
    const Scene scene = storeys(4.0);
    const Case problem(scene);
    const ExchangeEstimate estimate = problem.estimate(20000, 1);
    for (std::uint32_t i = 0; i < 16; ++i)
        for (std::uint32_t j = ceiling; j < 32; ++j) {
            const auto exchange = static_cast<double>(estimate.exchange.at(i, j));
            CHECK(std::abs(exchange) < 0.01 * static_cast<double>(problem.unoccluded.at(i, j)));
            CHECK(std::abs(exchange) < std::sqrt(static_cast<double>(estimate.variance.at(i, j))));
        }
}

// The share of the blocks is told by other lines than the pair's own, so that no bias is left but that of Sobol's
// points and of the trust, both below a tenth of the standard error of 60 estimates.
TEST_CASE("half-hidden pairs are right on the average")
{
    constexpr double width = 1.7;
    const Scene scene = storeys(width);
    const Case problem(scene);
    std::vector<ExchangeEstimate> estimates;
    for (std::uint64_t seed = 1; seed <= 60; ++seed)
        estimates.push_back(problem.estimate(20000, seed));
    int checked = 0;
    for (const Pair& pair : pairs_of_storeys(problem, width)) {
        if (!pair.half_hidden())
            continue;
        std::vector<double> found;
        for (const ExchangeEstimate& one : estimates)
            found.push_back(static_cast<double>(one.exchange.at(pair.floor, pair.ceiling)));
        const Estimate mean = estimate(found);
        CAPTURE(mean.mean);
        CAPTURE(pair.exact);
        CHECK(mean.agrees_with(pair.exact));
        ++checked;
    }
    CHECK(checked > 100);
}

// A block tells the variance of its pairs together: one pair on the edge of a shadow may have three times as much, but
// their sum is right. Counting free lines alone has the variance a G V for each pair; taking out the chance by which
// lines meet it must help, although the blocks, two cells of four wide, are coarse here.
TEST_CASE("the variances are of the right order, and lower than those of counting free lines")
{
    constexpr double width = 1.7;
    constexpr std::uint64_t runs = 20;
    const Scene scene = storeys(width);
    const Case problem(scene);
    const std::vector<Pair> pairs = pairs_of_storeys(problem, width);
    double claimed = 0.0;
    double found = 0.0;
    double counting = 0.0;
    for (std::uint64_t seed = 1; seed <= runs; ++seed) {
        const ExchangeEstimate estimate = problem.estimate(20000, seed);
        for (const Pair& pair : pairs) {
            const double error = static_cast<double>(estimate.exchange.at(pair.floor, pair.ceiling)) - pair.exact;
            claimed += static_cast<double>(estimate.variance.at(pair.floor, pair.ceiling));
            found += error * error;
            counting += problem.crossing_area(20000) * pair.exact;
        }
    }
    CAPTURE(claimed);
    CAPTURE(counting);
    CHECK(claimed < 3.0 * found);
    CHECK(found < 3.0 * claimed);
    CHECK(found < 0.5 * counting);
}

// The share of a pair's exchange that the blocks tell is below 1, and the deviations, trusted little where lines are
// few, add less than half the area of the patch to its row. A single line of the first ten is worth three times that
// area.
TEST_CASE("few lines do not blow the estimates up, and variances are never negative")
{
    const Scene scene = storeys(1.7);
    const Case problem(scene);
    for (const std::uint64_t cast : {1u, 10u, 30u, 100u, 300u, 1000u, 3000u, 10000u})
        for (std::uint64_t seed = 1; seed <= 10; ++seed) {
            CAPTURE(cast);
            CAPTURE(seed);
            const ExchangeEstimate estimate = problem.estimate(cast, seed);
            bool sound = true;
            double worst = 0.0; // of a row, above what it would be without obstacles
            for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
                double excess = 0.0;
                for (std::uint32_t j = 0; j < scene.patch_count(); ++j) {
                    const auto unoccluded = static_cast<double>(problem.unoccluded.at(i, j));
                    const auto variance = static_cast<double>(estimate.variance.at(i, j));
                    excess += std::abs(static_cast<double>(estimate.exchange.at(i, j))) - unoccluded;
                    sound = sound && (unoccluded > 0.0 ? variance > 0.0 : variance == 0.0); // not so for NaN
                }
                sound = sound && std::isfinite(excess);
                worst = std::max(worst, excess / scene.area(i));
            }
            CHECK(sound);
            CHECK(worst < 0.5);
        }
}

TEST_CASE("every number of threads estimates the same bits")
{
    const Scene scene = storeys(1.7);
    const Case problem(scene);
    const ExchangeEstimate one = problem.estimate(3000, 1, 1);
    for (const int threads : {2, 7}) {
        const ExchangeEstimate more = problem.estimate(3000, 1, threads);
        const std::uint32_t n = scene.patch_count();
        CHECK(std::equal(one.exchange.row(0), one.exchange.row(n), more.exchange.row(0)));
        CHECK(std::equal(one.variance.row(0), one.variance.row(n), more.variance.row(0)));
    }
}

// Two pairs in one block: 0 of 8 lines through the first were free, 8 of 8 through the second. The share of each must
// be told by the other alone, and by one line more that stands for the larger blocks: at least 8/9 for the first, at
// most 1/9 for the second. Twice as many lines as expected met each pair, so that beta G + a (joined - 8 beta) with a =
// G / 4 is -beta G and (2 - beta) G, but for the trust t^2 > 0.97 in the second term.
TEST_CASE("the share of a pair is told by the lines of the other pairs")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, grey).rectangle({0, 2, -0.5}, {1, 0, 0}, {0, 0, 2}, grey);
    const Scene scene = builder.scene(1.0); // patch 0 below the patches 1 and 2
    REQUIRE(scene.patch_count() == 3);
    const Case problem(scene);
    const auto g = static_cast<double>(problem.unoccluded.at(1, 0));
    PairCounts counts(3);
    counts.pairs.at(1, 0) = {0, 8};
    counts.pairs.at(2, 0) = {8, 8};
    const ExchangeEstimate estimate = estimate_exchange(scene, problem.unoccluded, counts, g / 4.0, 1);
    const double hidden = static_cast<double>(estimate.exchange.at(1, 0)) / g;
    CHECK(hidden < -8.0 / 9.0 * (2 * 0.97 - 1.0));
    CHECK(hidden >= -1.0);
    const double open = static_cast<double>(estimate.exchange.at(2, 0)) / g;
    CHECK(open > (1.0 - 1.0 / 9.0) * 2 * 0.97);
    CHECK(open <= 2.0);
}

// A patch that 16 lines cross is trusted by half, one that 32 cross by 16/17, so that of what a pair of them found,
// beyond what its block lets expect, 8/17 counts. The only line was not free, so the surfaces are in two spaces: with
// one line more, that stands for the next larger blocks, the share of the whole scene is 1/2, of the spaces 1/4, of the
// surfaces 1/8 and of the middle blocks 1/16, which is left without the pair's own.
TEST_CASE("what patches found that few lines cross counts in part")
{
    for (const double other_width : {1.0, 2.0})
        for (const bool floor_first : {true, false}) {
            SceneBuilder builder;
            const std::uint32_t grey = builder.grey(0.5, 1.0);
            const Surface floor = {Shape::parallelogram, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
            const Surface ceiling = {Shape::parallelogram, {0, 2, 0}, {other_width, 0, 0}, {0, 0, 1}};
            builder.surface(floor_first ? floor : ceiling, grey).surface(floor_first ? ceiling : floor, grey);
            const Scene scene = builder.scene(other_width);
            REQUIRE(scene.patch_count() == 2);
            const Case problem(scene);
            PairCounts counts(2);
            counts.pairs.at(1, 0) = {0, 1};
            const double crossing_area = 1.0 / 16.0;
            const ExchangeEstimate estimate = estimate_exchange(scene, problem.unoccluded, counts, crossing_area, 1);
            const auto g = static_cast<double>(problem.unoccluded.at(1, 0));
            const double trusted = 0.5 * (other_width == 1.0 ? 0.5 : 16.0 / 17.0);
            CHECK(static_cast<double>(estimate.exchange.at(1, 0)) ==
                  doctest::Approx((g - trusted * crossing_area) / 16.0).epsilon(1e-6).scale(0.0)); // single precision
        }
}

} // namespace exchange_estimate_test
