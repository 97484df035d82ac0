// The physics that every run must obey, each law with its derivation. Statistical tests have fixed seeds; "within 4
// standard errors" takes the standard error from independent seeds. Even an exact law is missed by 4 of them once in
// 16,000 cases, and once in 2,000 where two dozen seeds estimate it.

#include "radiosity/error_measure.h"
#include "radiosity/first_shot.h"
#include "radiosity/solve.h"
#include "statistics.h"
#include "test_scenes.h"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>

using namespace multipath;

namespace {

const ProgressCallback silent = [](double) {};
constexpr std::array<Method, 4> walks = {Method::local, Method::global, Method::first_shot, Method::extended};
constexpr std::array<Method, 5> all_methods = {Method::local, Method::global, Method::first_shot, Method::extended,
                                               Method::reuse};

SolveOptions random_lines(Method method, std::uint64_t lines, std::uint64_t seed)
{
    SolveOptions options;
    options.method = method;
    options.sequence = "random";
    options.lines = lines;
    options.seed = seed;
    return options;
}

/// Mean of `quantity(solution)` over independent seeds.
template <class Quantity>
Estimate over_seeds(const Scene& scene, SolveOptions options, int seeds, const Quantity& quantity)
{
    std::vector<double> samples;
    for (int seed = 1; seed <= seeds; ++seed) {
        options.seed = static_cast<std::uint64_t>(seed);
        samples.push_back(quantity(solve(scene, options, silent)));
    }
    return estimate(samples);
}

/// Solves A x = b by elimination with pivoting.
std::vector<double> solve_dense(std::vector<std::vector<double>> a, std::vector<double> b)
{
    const std::size_t n = b.size();
    for (std::size_t k = 0; k < n; ++k) {
        std::size_t pivot = k;
        for (std::size_t i = k; i < n; ++i)
            if (std::abs(a[i][k]) > std::abs(a[pivot][k]))
                pivot = i;
        std::swap(a[k], a[pivot]);
        std::swap(b[k], b[pivot]);
        for (std::size_t i = k + 1; i < n; ++i) {
            const double factor = a[i][k] / a[k][k];
            for (std::size_t j = k; j < n; ++j)
                a[i][j] -= factor * a[k][j];
            b[i] -= factor * b[k];
        }
    }
    for (std::size_t k = n; k-- > 0;) {
        for (std::size_t j = k + 1; j < n; ++j)
            b[k] -= a[k][j] * b[j];
        b[k] /= a[k][k];
    }
    return b;
}

// Two parallel unit squares at distance 1 (Howell, A Catalog of Radiation Heat Transfer Configuration Factors, C-11, X
// = Y = 1): F = (2 / pi) (ln(2 / sqrt 3) + 2 sqrt 2 atan(1 / sqrt 2) - pi / 2) = 0.199825; by symmetry and closure the
// four others get (1 - F) / 4.
double opposite_form_factor()
{
    const double pi = 3.14159265358979323846;
    return 2.0 / pi *
           (std::log(2.0 / std::sqrt(3.0)) + 2.0 * std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0)) - pi / 2.0);
}

} // namespace

// A closed box whose walls all have emittance E and reflectance rho: every reflection returns the share rho of the
// light, so B = E (1 + rho + rho^2 + ...) = E / (1 - rho) everywhere, whatever the shape of the box.
TEST_CASE("in a closed box of uniform walls the radiosity is E / (1 - rho)" * doctest::test_suite("statistics"))
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.3, 1.4);
    builder.room({0, 0, 0}, {1, 2, 3}, wall).box({0.3, 0.5, 0.4}, {0.6, 0.9, 1.0}, wall);
    const Scene scene = builder.scene(1.0);
    for (const Method method : walks) {
        const SolveOptions options = random_lines(method, 1u << 14, 0);
        for (const std::uint32_t patch : {0u, 7u, scene.patch_count() - 1})
            CHECK(over_seeds(scene, options, 60, [&](const Solution& s) {
                      return s.radiosity[patch].g;
                  }).agrees_with(2.0));
    }
}

// The same with boxes standing exactly on the floor, bottoms included, and a sheet made of two coincident faces: the
// furnace has no gaps, so the law holds on covered patches too. Wrong order of coincident hits shows here at once.
TEST_CASE("the furnace law holds with coincident faces" * doctest::test_suite("statistics"))
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.3, 1.4); // below 0.5, so that the threshold (4) leaves something to shoot
    builder.room({0, 0, 0}, {1, 1, 1}, wall).box({0.2, 0.0, 0.2}, {0.5, 0.3, 0.5}, wall);
    builder.rectangle({0.6, 0.5, 0.6}, {0.3, 0, 0}, {0, 0, 0.3}, wall); // faces down
    builder.rectangle({0.6, 0.5, 0.6}, {0, 0, 0.3}, {0.3, 0, 0}, wall); // faces up
    const Scene scene = builder.scene(0.5);
    for (const Method method : {Method::global, Method::first_shot})
        for (const std::uint32_t patch : {0u, scene.first_patch(6), scene.first_patch(12), scene.first_patch(13)})
            CHECK(over_seeds(scene, random_lines(method, 1u << 15, 0), 24, [&](const Solution& s) {
                      return s.radiosity[patch].g;
                  }).agrees_with(2.0));
    const Solution solution = solve(scene, random_lines(Method::first_shot, 1u << 16, 5), silent);
    CHECK(solution.balance.behind.g == 0.0);
    CHECK(solution.balance.escaped.g == 0.0);
}

// Light does not know how a room is turned, where it stands or in which unit it is measured. In this furnace boxes
// stand on the floor, on each other, in a corner and against a wall, and a sheet lies on one of them: after a rotation
// all the planes that touch differ by rounding. Every patch has B = 2 in expectation, whatever the motion.
TEST_CASE("the furnace law holds for touching solids under any rigid motion and scale")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.3, 1.4); // below 0.5, so that the threshold (4) leaves something to shoot
    builder.room({0, 0, 0}, {1, 1, 1}, wall).box({0.2, 0.0, 0.2}, {0.5, 0.3, 0.5}, wall);
    builder.box({0.2, 0.3, 0.2}, {0.5, 0.5, 0.5}, wall);                // on the first, with the same footprint
    builder.box({0.6, 0.0, 0.6}, {1.0, 0.4, 1.0}, wall);                // in a corner
    builder.rectangle({0.6, 0.4, 0.6}, {0.3, 0, 0}, {0, 0, 0.3}, wall); // a sheet on it: its lower face,
    builder.rectangle({0.6, 0.4, 0.6}, {0, 0, 0.3}, {0.3, 0, 0}, wall); // and its upper one
    const SceneFile file = builder.file();
    std::vector<std::vector<double>> samples(file.surfaces.size());
    for (std::uint64_t key = 1; key <= 40; ++key) {
        const RigidMotion motion(key);
        const Scene scene(motion.moved(file), 10.0 * motion.scale());
        const Method method = key % 2 == 0 ? Method::global : Method::first_shot;
        const Solution solution = solve(scene, random_lines(method, 1u << 14, key), silent);
        CAPTURE(key);
        CHECK((solution.local_lines > 1000) == (method == Method::first_shot));
        CHECK(solution.balance.escaped.g == 0.0);
        CHECK(solution.balance.behind.g == 0.0);
        for (std::size_t i = 0; i < samples.size(); ++i)
            samples[i].push_back(solution.radiosity[i].g);
    }
    for (std::size_t i = 0; i < samples.size(); ++i) {
        CAPTURE(i);
        CHECK(estimate(samples[i]).agrees_with(2.0));
    }
}

// Every patch of a closed scene that shoots all its light at B = 1 receives H = 1: sum_j F_ij = 1, with rays alone.
// Here every way of touching appears: floor to ceiling, in corners, side by side, one on the other, a table on legs, a
// sheet on a box.
TEST_CASE("in a closed scene of equal radiosity every patch receives that radiosity, also where solids touch")
{
    SceneBuilder builder;
    const std::uint32_t black = builder.grey(0.0, 1.0);
    builder.room({0, 0, 0}, {1, 1, 1}, black);
    builder.box({0.0, 0.0, 0.0}, {0.2, 0.3, 0.2}, black); // in a corner
    builder.box({0.4, 0.0, 0.4}, {0.5, 1.0, 0.5}, black); // a pillar from floor to ceiling
    builder.box({0.6, 0.0, 0.1}, {0.7, 0.3, 0.3}, black); // two side by side
    builder.box({0.7, 0.0, 0.1}, {0.8, 0.3, 0.3}, black);
    builder.box({0.6, 0.3, 0.1}, {0.8, 0.4, 0.3}, black);    // and one on both
    builder.box({0.65, 0.0, 0.65}, {0.7, 0.4, 0.7}, black);  // a leg
    builder.box({0.85, 0.0, 0.85}, {0.9, 0.4, 0.9}, black);  // another
    builder.box({0.6, 0.4, 0.6}, {0.95, 0.45, 0.95}, black); // a table top on them
    builder.box({0.1, 0.9, 0.6}, {0.3, 1.0, 0.8}, black);    // a lamp at the ceiling
    for (std::uint64_t key = 1; key <= 6; ++key) {
        const RigidMotion motion(key);
        const Scene scene(motion.moved(builder.file()), 10.0 * motion.scale());
        PowerState state(scene);
        const auto sequence = make_sequence("random", key);
        const std::vector<Shot> shots = plan_first_shot(scene, state, 0.0, 200000);
        spend(scene, 0.0, shots, state);
        shoot(scene, *sequence, 0, shots, {2}, state);
        CHECK(state.escaped.g == 0.0);
        CHECK(state.behind.g == 0.0);
        const double power_per_ray = scene.source_power().g / 200000;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
            CAPTURE(i);
            const double rays =
                scene.area(i) / power_per_ray; // a Poisson variable at most: closer, since shots are stratified
            CHECK(std::abs(state.incident[i].g / power_per_ray - rays) < 5.0 * std::sqrt(rays));
        }
    }
}

// In a sphere every patch receives the same irradiance from an element of the sphere wherever it lies: F_ij = A_j /
// A_T. Hence B_i = E_i + rho_i H with H = mean(B) = mean(E) / (1 - mean(rho)) over the area. Of 360 facets this is true
// to 0.1 %, and what the walk leaves unshot is about as much; the standard error here is above 0.1 %, so 4 of them
// leave room for both.
TEST_CASE("in a sphere of two unlike halves every patch receives the same" * doctest::test_suite("statistics"))
{
    constexpr int n = 10;
    SceneBuilder builder;
    const std::uint32_t upper = builder.grey(0.8, 0.0);
    const std::uint32_t lower = builder.grey(0.3, 1.0);
    const double pi = 3.14159265358979323846;
    const auto point = [&](int ring, int side) {
        const double theta = pi * ring / n;
        const double phi = pi * (side % (2 * n)) / n;
        return Vec3{std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi)};
    };
    for (int ring = 0; ring < n; ++ring)
        for (int side = 0; side < 2 * n; ++side) {
            const std::uint32_t material = ring < n / 2 ? upper : lower;
            if (ring > 0) // the first and the last ring end in a pole
                builder.triangle(point(ring, side), point(ring + 1, side), point(ring, side + 1), material);
            if (ring + 1 < n)
                builder.triangle(point(ring, side + 1), point(ring + 1, side), point(ring + 1, side + 1), material);
        }
    const Scene scene = builder.scene(10.0);

    const double incident = 0.5 / (1.0 - 0.55); // mean(E) = 0.5, mean(rho) = 0.55 over two equal halves
    const auto mean_over = [&](const Solution& solution, double rho) {
        double power = 0.0;
        double area = 0.0;
        for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
            if (scene.reflectance(i).g == rho) {
                power += scene.area(i) * solution.radiosity[i].g;
                area += scene.area(i);
            }
        return power / area;
    };
    SolveOptions options = random_lines(Method::global, 1u << 18, 0);
    options.threads = 2;
    CHECK(over_seeds(scene, options, 8, [&](const Solution& s) {
              return mean_over(s, 0.8);
          }).agrees_with(0.8 * incident));
    CHECK(over_seeds(scene, options, 8, [&](const Solution& s) {
              return mean_over(s, 0.3);
          }).agrees_with(1.0 + 0.3 * incident));
}

// Six walls of one patch each: B_i = E_i + rho_i sum_j F_ij B_j with two known form factors is a system of six
// equations.
TEST_CASE("the unit cube with uneven walls solves its 6 x 6 system" * doctest::test_suite("statistics"))
{
    const std::array<double, 6> rho = {0.2, 0.7, 0.5, 0.3, 0.9, 0.6};
    const std::array<double, 6> emittance = {0.0, 3.0, 0.0, 0.0, 1.0, 0.0};
    SceneBuilder builder;
    std::vector<std::uint32_t> walls;
    for (std::size_t i = 0; i < 6; ++i)
        walls.push_back(builder.grey(rho[i], emittance[i]));
    const Scene scene = builder.room({0, 0, 0}, {1, 1, 1}, walls).scene(1.0);

    const double opposite = opposite_form_factor();
    CHECK(opposite == doctest::Approx(0.199825).epsilon(1e-6));
    const double adjacent = (1.0 - opposite) / 4.0;
    CHECK(adjacent == doctest::Approx(0.200044).epsilon(1e-6));
    std::vector<std::vector<double>> matrix(6, std::vector<double>(6));
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j)
            matrix[i][j] = i == j ? 1.0 : -rho[i] * (i / 2 == j / 2 ? opposite : adjacent);
    const std::vector<double> exact = solve_dense(matrix, {emittance.begin(), emittance.end()});

    std::vector<std::vector<double>> moved_samples(6);
    for (std::uint64_t key = 1; key <= 24; ++key) {
        const RigidMotion motion(key);
        const Scene moved(motion.moved(scene.file()), 10.0 * motion.scale());
        const Solution solution = solve(moved, random_lines(Method::first_shot, 1u << 14, key), silent);
        for (std::size_t i = 0; i < 6; ++i)
            moved_samples[i].push_back(solution.radiosity[i].r);
    }
    for (std::size_t i = 0; i < 6; ++i)
        CHECK(estimate(moved_samples[i]).agrees_with(exact[i]));

    for (const Method method : walks)
        for (const bool bidirectional : {true, false}) {
            SolveOptions options = random_lines(method, 1u << 14, 0);
            options.bidirectional = bidirectional;
            for (std::uint32_t i = 0; i < 6; ++i) {
                CAPTURE(i);
                CHECK(over_seeds(scene, options, 24, [&](const Solution& s) {
                          return s.radiosity[i].r;
                      }).agrees_with(exact[i]));
            }
        }
}

// Square 1 emits, both reflect: B_1 = E + rho_1 F B_2, B_2 = rho_2 F B_1. What the other square does not catch escapes:
// (1 - F) of all that leaves either square.
TEST_CASE("between two facing squares the share F arrives and the rest escapes" * doctest::test_suite("statistics"))
{
    SceneBuilder builder;
    const std::uint32_t lamp = builder.grey(0.4, 2.0);
    const std::uint32_t target = builder.grey(0.7, 0.0);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, lamp).rectangle({0, 1, 0}, {1, 0, 0}, {0, 0, 1}, target);
    const Scene scene = builder.scene(1.0);
    const double f = opposite_form_factor();
    const double b_1 = 2.0 / (1.0 - 0.4 * 0.7 * f * f);
    const double b_2 = 0.7 * f * b_1;
    const double escaped = (1.0 - f) * (b_1 + b_2);
    for (const Method method : walks) {
        const SolveOptions options = random_lines(method, 1u << 14, 0);
        CHECK(over_seeds(scene, options, 32, [](const Solution& s) { return s.radiosity[0].r; }).agrees_with(b_1));
        CHECK(over_seeds(scene, options, 32, [](const Solution& s) { return s.radiosity[1].r; }).agrees_with(b_2));
        CHECK(
            over_seeds(scene, options, 32, [](const Solution& s) { return s.balance.escaped.r; }).agrees_with(escaped));
    }
}

// A patch i that alone emits, among patches that reflect next to nothing, gives j the power A_i E F_ij. With the roles
// exchanged it is A_j E F_ji, and reciprocity says that both are equal, however unlike the patches.
TEST_CASE("exchanges between unlike patches are reciprocal")
{
    const auto irradiation = [](bool small_emits) {
        SceneBuilder builder;
        const double faint = 1e-9; // what arrives can be read from the radiosity, what is reflected does not matter
        const std::uint32_t dark = builder.grey(faint, 0.0);
        const std::uint32_t lamp = builder.grey(faint, 1.0);
        builder.room({0, 0, 0}, {2, 1, 1}, {dark, small_emits ? dark : lamp, dark, dark, dark, dark});
        builder.rectangle({0.1, 0.3, 0.2}, {0.1, 0.1, 0.2}, {0.3, 0, 0}, small_emits ? lamp : dark);
        const Scene scene = builder.scene(10.0);
        const std::uint32_t receiver_patch = small_emits ? 1 : 6;
        return over_seeds(scene, random_lines(Method::global, 1u << 15, 0), 24, [&](const Solution& s) {
            return s.radiosity[receiver_patch].r / faint * scene.area(receiver_patch); // [W] that arrived
        });
    };
    const Estimate one_way = irradiation(true);
    const Estimate other_way = irradiation(false);
    CHECK(one_way.mean > 0.0);
    const double error = std::hypot(one_way.standard_error, other_way.standard_error);
    CHECK(std::abs(one_way.mean - other_way.mean) <= 4.0 * error);
}

// emitted = absorbed + unshot + escaped + behind is an identity of the bookkeeping: only rounding may disturb it.
TEST_CASE("no power appears or vanishes, also in a scene that leaks and shows its backs")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.material({0.7, 0.5, 0.2}, {0, 0, 0});
    const std::uint32_t lamp = builder.material({0.1, 0.1, 0.1}, {3, 2, 1});
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, wall);             // a floor
    builder.rectangle({0, 1, 0}, {0.5, 0, 0}, {0, 0, 0.5}, lamp);         // a lamp above it
    builder.rectangle({0.2, 0.4, 0.2}, {0.3, 0, 0}, {0, 0.1, 0.3}, wall); // a sheet whose back looks up
    for (const bool two_sided : {false, true}) {
        const Scene scene = builder.scene(0.2, two_sided);
        for (const Method method : all_methods)
            for (const char* sequence : {"random", "sobol", "halton"}) {
                SolveOptions options = random_lines(method, 100000, 3);
                options.sequence = sequence;
                const Solution solution = solve(scene, options, silent);
                const PowerBalance& balance = solution.balance;
                CHECK(balance.relative_error() < 1e-12);
                Rgb unshot;
                for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
                    unshot += scene.area(i) * solution.unshot[i];
                CHECK(unshot.g == doctest::Approx(balance.unshot.g).epsilon(1e-12).scale(balance.source.g));
                CHECK(balance.escaped.r > 0.0);
                CHECK((balance.behind.r > 0.0) == !two_sided);
                // The forecast makes the emitted power a random variable around the true one.
                CHECK(balance.emitted.b == doctest::Approx(scene.source_power().b).epsilon(0.02));
            }
    }
}

// A grey scene is three times the same scalar computation.
TEST_CASE("a grey scene has the same bits in each channel")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.grey(0.63, 0.0);
    const std::uint32_t lamp = builder.grey(0.11, 7.3);
    const Scene scene = builder.room({0, 0, 0}, {1, 1, 1}, {wall, lamp, wall, wall, wall, wall}).scene(0.3);
    for (const Method method : all_methods)
        for (const Rgb b : solve(scene, random_lines(method, 50000, 1), silent).radiosity) {
            CHECK(b.r == b.g);
            CHECK(b.g == b.b);
        }
}

TEST_CASE("the result does not depend on the number of threads")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.material({0.6, 0.5, 0.4}, {0, 0, 0});
    const std::uint32_t lamp = builder.grey(0.2, 5.0);
    builder.room({0, 0, 0}, {1, 1, 1}, {wall, lamp, wall, wall, wall, wall}).box({0.2, 0, 0.2}, {0.5, 0.4, 0.6}, wall);
    const Scene scene = builder.scene(0.1);
    for (const Method method : all_methods) {
        SolveOptions options = random_lines(method, 150000, 9);
        options.sequence = method == Method::first_shot ? "sobol" : "random";
        const Solution alone = solve(scene, options, silent);
        for (const int threads : {2, 3, 7}) {
            options.threads = threads;
            const Solution together = solve(scene, options, silent);
            CHECK(together.radiosity == alone.radiosity);
            CHECK(together.balance.unshot == alone.balance.unshot);
        }
    }
}
