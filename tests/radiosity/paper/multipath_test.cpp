#include "radiosity/paper/multipath.h"

#include "radiosity/run/solve.h"
#include "radiosity/run/statistics.h"
#include "scene/obj/obj_reader.h"
#include "scene/scene_builder.h"

#include <cstdlib>
#include <doctest/doctest.h>
#include <fstream>
#include <map>
#include <sstream>
#include <tuple>

namespace multipath_test {

using namespace multipath;

namespace {

const ProgressCallback silent = [](double) {};

Scene grey_five_cubes()
{
    return Scene(read_obj("tests/fixtures/reference/5cubes-grey.obj"), 0.1);
}

/// The converged radiosity that an independent program found, brought into our order by the patches' centres.
std::vector<Rgb> reference_radiosity(const Scene& scene)
{
    std::ifstream file("tests/fixtures/reference/5cubes-grey-reference.csv");
    std::map<std::tuple<long, long, long>, double> by_centre;
    const auto key = [](Vec3 p) {
        return std::make_tuple(std::lround(p.x * 1e6), std::lround(p.y * 1e6), std::lround(p.z * 1e6));
    };
    std::string row;
    while (std::getline(file, row)) {
        std::replace(row.begin(), row.end(), ',', ' ');
        std::istringstream numbers(row);
        double x = 0, y = 0, z = 0, area = 0, reflectance = 0, emittance = 0, radiosity = 0;
        if (numbers >> x >> y >> z >> area >> reflectance >> emittance >> radiosity)
            by_centre[key({x, y, z})] = radiosity;
    }
    std::vector<Rgb> result;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double b = by_centre.at(key(scene.patch(i).shape.centre()));
        result.push_back({b, b, b});
    }
    return result;
}

} // namespace

// Lines that leave a small lamp are rare and independent: by their number n the power that they send has the relative
// variance 1 / n, of which the estimate is twice as much. The mean square over 200 runs scatters by a tenth.
TEST_CASE("the power that lines send in one direction or both is as uncertain as it is told to be")
{
    SceneBuilder builder;
    builder.room({0, 0, 0}, {2, 1, 3}, builder.grey(0.4, 0.0));
    builder.rectangle({0.7, 0.9, 1.3}, {0.2, 0, 0}, {0, 0, 0.3}, builder.material({0.2, 0.2, 0.2}, {30, 20, 10}));
    const Scene scene = builder.scene(1.0);
    SolveOptions options;
    options.method = Method::global;
    options.sequence = "random";
    options.lines = 3000;
    for (const bool bidirectional : {true, false}) {
        CAPTURE(bidirectional);
        options.bidirectional = bidirectional;
        double squares = 0.0; // of the deviations over the errors
        constexpr int runs = 200;
        for (int run = 0; run < runs; ++run) {
            options.seed = static_cast<std::uint64_t>(run);
            const PowerBalance balance = solve(scene, options, silent).balance;
            const double deviation = mean(balance.emitted - balance.source) / balance.emitted_error;
            squares += deviation * deviation / runs;
        }
        CHECK(squares > 0.3);
        CHECK(squares < 0.7);
    }
}

// Published with the scene: first shot at N_l / N_g = 0.8 and 2^21 lines in all gives MSE 9.5e-6 with random lines
// and 2.8e-6 with Sobol's, measured by an independent program; 30 % for the spread of a single figure.
TEST_CASE("on the grey 5CUBES the error is that of an independent implementation" * doctest::test_suite("statistics"))
{
    const Scene scene = grey_five_cubes();
    REQUIRE(scene.patch_count() == 736);
    const std::vector<Rgb> reference = reference_radiosity(scene);
    SolveOptions options;
    options.lines = 1u << 21;
    options.ratio = 0.8;
    options.threads = 2;
    const auto mean_square_error = [&] {
        return measure_error(scene.areas(), solve(scene, options, silent).radiosity, reference).mean_square;
    };
    CHECK(mean_square_error() == doctest::Approx(2.8e-6).epsilon(0.3));

    options.sequence = "random";
    double sum = 0.0;
    for (options.seed = 1; options.seed <= 4; ++options.seed)
        sum += mean_square_error();
    CHECK(sum / 4.0 == doctest::Approx(9.5e-6).epsilon(0.3));
}

// The paper's section 3: two successive 2-D points are so correlated that the lines are far from uniform, however many
// there are.
TEST_CASE("4-D Sobol items converge, pairs of 2-D items do not" * doctest::test_suite("statistics"))
{
    const Scene scene = grey_five_cubes();
    const std::vector<Rgb> reference = reference_radiosity(scene);
    const auto error = [&](const char* sequence, Pairing pairing, std::uint64_t lines) {
        SolveOptions options;
        options.sequence = sequence;
        options.pairing = pairing;
        options.lines = lines;
        options.ratio = 0.8;
        options.threads = 2;
        return measure_error(scene.areas(), solve(scene, options, silent).radiosity, reference).relative_mean_square;
    };
    const double few = error("sobol", Pairing::four_dimensional, 1u << 16);
    const double many = error("sobol", Pairing::four_dimensional, 1u << 20);
    CHECK(few / many > 12.0);
    const double few_pairs = error("sobol", Pairing::two_dimensional, 1u << 16);
    const double many_pairs = error("sobol", Pairing::two_dimensional, 1u << 20);
    CHECK(few_pairs / many_pairs < 2.0);
    CHECK(many_pairs > 100.0 * many);
}

} // namespace multipath_test
