// The physics that every run must obey, each law with its derivation. Statistical tests have fixed seeds; "within 4
// standard errors" takes the standard error from independent seeds. Even an exact law is missed by 4 of them once in
// 16,000 cases, and once in 2,000 where two dozen seeds estimate it.

#include "base/elementary.h"
#include "form_factor.h"
#include "irregular_scene.h"
#include "linear_system.h"
#include "radiosity/run/replicates.h"
#include "seeded_runs.h"
#include "test_scenes.h"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>

namespace laws_test {

using namespace multipath;

namespace {

/// Those whose power moves along lines; the others solve equations.
std::vector<Method> methods_of_walks()
{
    std::vector<Method> methods;
    for (const Method method : all_methods())
        if (!method->traced.empty())
            methods.push_back(method);
    return methods;
}

} // namespace

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
    const std::vector<Estimate> halves = all_over_seeds(scene, options, 8, [&](const Solution& s) {
        return std::vector<double>{mean_over(s, 0.8), mean_over(s, 0.3)};
    });
    CHECK(halves[0].agrees_with(0.8 * incident));
    CHECK(halves[1].agrees_with(1.0 + 0.3 * incident));
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

    for (const Method method : methods_of_walks())
        for (const bool bidirectional : {true, false}) {
            SolveOptions options = random_lines(method, 1u << 14, 0);
            options.bidirectional = bidirectional;
            const std::vector<Estimate> found = radiosities(scene, options, 24, {0, 1, 2, 3, 4, 5});
            for (std::size_t i = 0; i < 6; ++i) {
                CAPTURE(i);
                CHECK(found[i].agrees_with(exact[i]));
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
    for (const Method method : methods_of_walks()) {
        const SolveOptions options = random_lines(method, 1u << 14, 0);
        const std::vector<Estimate> found = all_over_seeds(scene, options, 32, [](const Solution& s) {
            return std::vector<double>{s.radiosity[0].r, s.radiosity[1].r, s.balance.escaped.r};
        });
        CHECK(found[0].agrees_with(b_1));
        CHECK(found[1].agrees_with(b_2));
        CHECK(found[2].agrees_with(escaped));
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
        for (const Method method : all_methods())
            for (const char* sequence : {"random", "sobol", "halton"}) {
                SolveOptions options = random_lines(method, 100000, 3);
                options.sequence = sequence;
                const Solution solution = solve(scene, options, silent);
                const PowerBalance& balance = solution.balance;
                CHECK(balance.relative_error() < 1e-12);
                Rgb unshot;
                for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
                    unshot += scene.area(i) * solution.unshot[i];
                // A negative sum, of a residual, is counted with what is absorbed.
                CHECK(std::max(0.0, unshot.g) ==
                      doctest::Approx(balance.unshot.g).epsilon(1e-12).scale(balance.source.g));
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
    for (const Method method : all_methods())
        for (const Rgb b : solve(scene, random_lines(method, 50000, 1), silent).radiosity) {
            CHECK(b.r == b.g);
            CHECK(b.g == b.b);
        }
}

// Factors that are powers of two change no digit of any number. Lamps, a textured one among them, sky and sun light
// unlike patches with two sides; then lamps light a scene that leaks and whose backs are no patches.
TEST_CASE("light is found to the same digits in any unit of power and of length")
{
    SceneBuilder builder;
    builder.room({-1, 2, 0.5}, {0, 3, 2}, builder.material({0.7, 0.5, 0.2}, {}));
    SceneFile leaking = builder.rectangle({-0.8, 2.9, 0.7}, {0.4, 0, 0}, {0, 0, 0.3}, builder.material({}, {3, 0, 1}))
                            .rectangle({-0.7, 2.4, 0.8}, {0.3, 0, 0}, {0, 0.1, 0.3}, builder.grey(0.3, 0.2))
                            .file();
    leaking.surfaces.erase(leaking.surfaces.begin() + 3); // a wall
    for (auto* list : {&leaking.material, &leaking.group, &leaking.line})
        list->erase(list->begin() + 3);
    const auto solved = [](SceneFile file, bool irregular, double power, double length, SolveOptions options) {
        for (Material& material : file.materials)
            material.emittance = power * material.emittance;
        if (file.sun)
            file.sun->irradiance = power * file.sun->irradiance;
        for (Surface& s : file.surfaces)
            s = {s.shape, length * s.origin, length * s.edge_u, length * s.edge_v};
        const Scene scene = irregular ? unevenly_refined(Scene(std::move(file), 0.7 * length, true))
                                      : Scene(std::move(file), 0.25 * length);
        options.lines = std::uint64_t{100} * scene.patch_count();
        return solve_replicates(scene, prepare(scene, options), options, 2, silent);
    };
    for (const bool irregular : {true, false})
        for (const Method method : all_methods())
            for (const bool all_pairs : {true, false}) {
                CAPTURE(irregular);
                CAPTURE(method->name);
                CAPTURE(all_pairs);
                SolveOptions options = random_lines(method, 1, 5);
                options.all_pairs = all_pairs;
                if (!all_pairs && method != Method::reuse)
                    continue;
                const SceneFile file = irregular ? irregular_file() : leaking;
                const Solution one = solved(file, irregular, 1.0, 1.0, options);
                const Solution bright = solved(file, irregular, 0x1p-12, 1.0, options);
                const Solution large = solved(file, irregular, 1.0, 0x1p6, options);
                for (std::size_t i = 0; i < one.radiosity.size(); ++i) {
                    CHECK(bright.radiosity[i] == 0x1p-12 * one.radiosity[i]);
                    CHECK(bright.standard_error[i] == 0x1p-12 * one.standard_error[i]);
                }
                CHECK(bright.balance.escaped == 0x1p-12 * one.balance.escaped);
                CHECK(bright.balance.behind == 0x1p-12 * one.balance.behind);
                if (method == Method::reuse && one.global_lines == 0)
                    continue; // its first rays are shared by a power of the areas that is rounded
                CHECK(large.radiosity == one.radiosity);
                CHECK(large.standard_error == one.standard_error);
                CHECK(large.balance.escaped == 0x1p12 * one.balance.escaped);
                CHECK(large.balance.behind == 0x1p12 * one.balance.behind);
            }
}

TEST_CASE("the result does not depend on the number of threads")
{
    SceneBuilder builder;
    const std::uint32_t wall = builder.material({0.6, 0.5, 0.4}, {0, 0, 0});
    const std::uint32_t lamp = builder.grey(0.2, 5.0);
    builder.room({0, 0, 0}, {1, 1, 1}, {wall, lamp, wall, wall, wall, wall}).box({0.2, 0, 0.2}, {0.5, 0.4, 0.6}, wall);
    const Scene scene = builder.scene(0.1);
    for (const Method method : all_methods()) {
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

} // namespace laws_test
