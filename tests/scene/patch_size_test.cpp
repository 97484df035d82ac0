#include "scene/patch_size.h"

#include "test_scenes.h"

#include <cmath>
#include <doctest/doctest.h>

#include <vector>

namespace patch_size_test {

using namespace multipath;

TEST_CASE("the default patch size is a round number that gives some thousand patches")
{
    for (const double edge : {1e-3, 0.5, 1.0, 3.0, 6.4, 700.0}) {
        SceneBuilder builder;
        const SceneFile file = builder.room({0, 0, 0}, {edge, edge, edge}, builder.grey(0.5, 1.0)).file();
        const std::uint32_t patches = Scene(file, default_patch_size(file.surfaces)).patch_count();
        CHECK(patches >= 2000);
        CHECK(patches <= 5500);
    }
}

TEST_CASE("a wanted number of patches is met closely and not exceeded")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.room({0, 0, 0}, {3, 2, 1}, grey).box({1, 0, 0.2}, {1.3, 0.9, 0.7}, grey);
    const SceneFile file = builder.file();
    for (const std::uint64_t wanted : {100ull, 1000ull, 30000ull, 1000000ull}) {
        const double size = patch_size_for_count(file.surfaces, wanted);
        const double count = cell_count(file.surfaces, size);
        CHECK(count <= static_cast<double>(wanted));
        CHECK(count > 0.8 * static_cast<double>(wanted));
    }
    CHECK(Scene(file, patch_size_for_count(file.surfaces, 1)).patch_count() == 12); // the surfaces alone
}

// A strip 1e5 times as long as wide: squares of its mean area would be wider than it.
TEST_CASE("the default patch size grows where long strips give more patches than their area says")
{
    const std::vector<Surface> strips(100, {Shape::parallelogram, {0, 0, 0}, {1e5, 0, 0}, {0, 1, 0}});
    const double size = default_patch_size(strips);
    const double by_area = std::sqrt(100 * 1e5 / 2500.0);
    CHECK(size > 1.25 * by_area);
    CHECK(size <= 3.0 * by_area);
}

// sqrt(6 x 2.1^2 / 2500) = 0.103: the next round size below is 0.1, and 6 x 21^2 patches are not too many.
TEST_CASE("the default patch size grows with the scene, also through the powers of ten")
{
    for (int exponent = -6; exponent <= 6; ++exponent) {
        const double unit = std::pow(10.0, exponent);
        SceneBuilder builder;
        const Vec3 size = 2.1 * unit * Vec3{1, 1, 1};
        const SceneFile file = builder.room({0, 0, 0}, size, builder.grey(0.5, 1.0)).file();
        CHECK(default_patch_size(file.surfaces) == doctest::Approx(0.1 * unit).epsilon(1e-12).scale(0.0));
    }
}

// A disk cut like a cake into slivers, each as long as its radius.
TEST_CASE("the default patch size leaves thousands of slivers almost whole")
{
    constexpr int n = 20000;
    std::vector<Surface> slivers;
    for (int i = 0; i < n; ++i) {
        const auto rim = [](int k) { return Vec3{std::cos(6.283185307 * k / n), std::sin(6.283185307 * k / n), 0}; };
        slivers.push_back({Shape::triangle, {0, 0, 0}, rim(i), rim(i + 1)});
    }
    CHECK(cell_count(slivers, default_patch_size(slivers)) <= 131072.0 + 8.0 * n);
}

} // namespace patch_size_test
