#include "radiosity/reuse/light_tree.h"

#include "base/elementary.h"
#include "sampling/random.h"
#include "test_scenes.h"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

namespace light_tree_test {

using namespace multipath;

namespace {

constexpr double angle = 0.3;

/// A room whose ceiling carries 20 x 20 panels, flush with it, and lamps of other directions in a corner.
Scene room_with_lamps()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    const std::uint32_t lamp = builder.grey(0.5, 3.0);
    const std::uint32_t bright = builder.grey(0.5, 20.0);
    builder.room({0, 0, 0}, {4, 2, 4}, grey);
    for (int k = 0; k < 400; ++k)
        builder.rectangle({0.1 + 0.19 * (k % 20), 1.99, 0.1 + 0.19 * (k / 20)}, {0.05, 0, 0}, {0, 0, 0.05}, lamp);
    builder.box({0.2, 0.2, 0.2}, {0.3, 0.5, 0.4}, bright);
    return builder.scene(0.25);
}

/// [W/m^2] By the exact exchange with every light.
double irradiance(const Scene& scene, std::uint32_t patch)
{
    double sum = 0.0;
    for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s)
        if (const double emittance = mean(scene.emittance(scene.first_patch(s))); emittance > 0.0)
            sum += emittance * exchange_area(scene.patch(patch).shape, scene.surfaces()[s], 1e-9);
    return sum / scene.area(patch);
}

} // namespace

TEST_CASE("a cluster has the power and the area of its lights, and no light is outside")
{
    const Scene scene = room_with_lamps();
    const LightTree tree(scene);
    CHECK(tree.cluster(0).power == doctest::Approx(mean(scene.source_power())).epsilon(1e-12));
    std::vector<std::uint32_t> stack = {0};
    std::size_t leaves = 0;
    while (!stack.empty()) {
        const std::uint32_t node = stack.back();
        stack.pop_back();
        if (tree.is_leaf(node)) {
            ++leaves;
            CHECK(mean(scene.emittance(scene.first_patch(tree.surface(node)))) > 0.0);
            continue;
        }
        for (const std::uint32_t child : {tree.first_child(node), tree.first_child(node) + 1}) {
            const LightTree::Cluster& inner = tree.cluster(child);
            CHECK(length(inner.centre - tree.cluster(node).centre) <= tree.cluster(node).radius);
            CHECK(inner.power < tree.cluster(node).power);
            stack.push_back(child);
        }
    }
    CHECK(leaves == 406);
}

TEST_CASE("the projected area is never less than what is seen, and right where all look the same way")
{
    const LightTree tree(room_with_lamps());
    for (std::uint32_t node = 0; node < 811; ++node) {
        const LightTree::Cluster& cluster = tree.cluster(node);
        for (std::uint64_t k = 0; k < 10; ++k) {
            const double z = 2.0 * bits_to_unit(random_bits(node, 2 * k)) - 1.0;
            const double turn = 2.0 * pi * bits_to_unit(random_bits(node, 2 * k + 1));
            const double r = std::sqrt(1.0 - z * z);
            const Vec3 d = {r * std::cos(turn), r * std::sin(turn), z};
            double seen = 0.0;
            std::vector<std::uint32_t> stack = {node};
            while (!stack.empty()) {
                const std::uint32_t below = stack.back();
                stack.pop_back();
                if (tree.is_leaf(below)) {
                    seen += tree.piece(below).area * std::max(0.0, dot(tree.piece(below).normal, d));
                } else {
                    stack.push_back(tree.first_child(below));
                    stack.push_back(tree.first_child(below) + 1);
                }
            }
            CHECK(cluster.projected_area(d) >= seen - 1e-9 * cluster.area);
            if (tree.is_leaf(node))
                CHECK(cluster.projected_area(d) == doctest::Approx(seen).epsilon(1e-6).scale(1e-3 * cluster.area));
        }
    }
}

TEST_CASE("lights are chosen in proportion to their power")
{
    const Scene scene = room_with_lamps();
    const LightTree tree(scene);
    constexpr int choices = 100000;
    double bright = 0.0;
    for (int k = 0; k < choices; ++k)
        bright += mean(scene.emittance(scene.first_patch(tree.surface(tree.choose(0, (k + 0.5) / choices))))) > 10.0;
    const double panels = 400 * 0.0025 * 3.0;
    CHECK(bright / choices == doctest::Approx(1.0 - panels / mean(scene.source_power())).epsilon(1e-3));
}

// The oracle: the exact exchange with each of the 406 lights.
TEST_CASE("a cut holds about the light of all lamps, with few clusters, and nothing where nothing is seen")
{
    const Scene scene = room_with_lamps();
    const LightTree tree(scene);
    const LightCuts cuts(scene, tree, angle, 2);
    double clusters = 0.0;
    double error = 0.0;
    double area = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        clusters += static_cast<double>(cuts.of(i).size());
        const double expected = irradiance(scene, i);
        if (expected < 1e-9) {
            CHECK(cuts.irradiance(i) < 1e-6);
            continue;
        }
        CHECK(cuts.irradiance(i) == doctest::Approx(expected).epsilon(0.3));
        error += scene.area(i) * std::pow(cuts.irradiance(i) / expected - 1.0, 2);
        area += scene.area(i);
    }
    CHECK(std::sqrt(error / area) < 0.07); // 0.058; 0.11 if the bright box is taken as a whole
    CHECK(clusters / scene.patch_count() < 60.0);
    const LightCuts fine(scene, tree, 0.0, 1); // every light by itself
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        CHECK(fine.irradiance(i) == doctest::Approx(irradiance(scene, i)).epsilon(1e-3).scale(1e-6));
}

TEST_CASE("cuts are the same for any number of threads")
{
    const Scene scene = room_with_lamps();
    const LightTree tree(scene);
    const LightCuts one(scene, tree, angle, 1);
    const LightCuts seven(scene, tree, angle, 7);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        CHECK(one.irradiance(i) == seven.irradiance(i));
        CHECK(std::equal(one.of(i).begin(), one.of(i).end(), seven.of(i).begin(), seven.of(i).end(),
                         [](const SeenCluster& a, const SeenCluster& b) {
                             return a.node == b.node && a.irradiance == b.irradiance;
                         }));
    }
}

} // namespace light_tree_test

namespace surface_tree_test {

using namespace multipath;

namespace {

SurfaceTree tree_of(const Scene& scene, std::uint32_t most_of_leaf)
{
    return {scene.patch_count(), [&](std::uint32_t i) { return scene.patch(i).shape; }, scene.bounds().diagonal(),
            most_of_leaf};
}

Scene room()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    return builder.room({0, 0, 0}, {2, 1, 1}, grey).box({0.4, 0, 0.2}, {0.7, 0.5, 0.6}, grey).scene(0.1);
}

} // namespace

TEST_CASE("each surface is in one leaf, in order there, and each node holds what its children hold")
{
    const Scene scene = room();
    for (const std::uint32_t most : {1u, 8u}) {
        const SurfaceTree tree = tree_of(scene, most);
        std::vector<int> found(scene.patch_count());
        for (const SurfaceTree::Node& node : tree.nodes()) {
            if (!node.is_leaf()) {
                const SurfaceTree::Node& first = tree.nodes()[node.first_child];
                const SurfaceTree::Node& second = tree.nodes()[node.first_child + 1];
                CHECK(first.begin == node.begin);
                CHECK(first.end == second.begin);
                CHECK(second.end == node.end);
                CHECK(&tree.nodes()[first.parent] == &node);
                continue;
            }
            CHECK(node.end - node.begin <= most);
            for (std::uint32_t place = node.begin; place < node.end; ++place) {
                ++found[tree.surface(place)];
                CHECK((place == node.begin || tree.surface(place - 1) < tree.surface(place)));
            }
        }
        CHECK(found == std::vector<int>(scene.patch_count(), 1));
    }
}

TEST_CASE("a leaf of the patches of a room lies on one wall, or on neighbouring ones at an edge")
{
    const Scene scene = room();
    const SurfaceTree tree = tree_of(scene, 8);
    for (const SurfaceTree::Node& node : tree.nodes())
        if (node.is_leaf()) {
            const Surface first = scene.patch(tree.surface(node.begin)).shape;
            for (std::uint32_t place = node.begin; place < node.end; ++place)
                CHECK(length(scene.patch(tree.surface(place)).shape.centre() - first.centre()) < 0.6);
        }
}

TEST_CASE("a tree of nothing, of one surface and of surfaces in one place can be made")
{
    const Surface square = {Shape::parallelogram, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto same = [&](std::uint32_t) { return square; };
    CHECK(SurfaceTree(0, same, 1.0, 1).nodes().size() == 1);
    CHECK(SurfaceTree(1, same, 1.0, 1).nodes().size() == 1);
    const SurfaceTree many(1000, same, 1.0, 1);
    CHECK(many.nodes().size() == 1999);
}

// By hand: patches with many rays tell for themselves, others with those around them until there are enough.
TEST_CASE("sums are pooled over the smallest group with enough rays")
{
    const auto apart = [](std::uint32_t i) {
        return Surface{Shape::parallelogram, {static_cast<double>(i), 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};
    };
    const SurfaceTree tree(4, apart, 4.0, 1); // ((0 1) (2 3))
    const std::vector<RaySums> own = {{10, 10, 20, 40}, {1, 1, 5, 25}, {2, 2, 0, 0}, {1, 1, 1, 1}};
    const std::vector<RaySums> found = pooled(tree, own, 4.0, OwnRays::counted, 2);
    CHECK(found[0].value == 20.0);
    CHECK(found[1].value == 25.0); // with its neighbour
    CHECK(found[2].value == 26.0); // 3 rays with its neighbour are too few
    CHECK(found[3].rays == 14.0);
    CHECK(found[0].standard_deviation() == 0.0);
    CHECK(found[1].standard_deviation() == doctest::Approx(std::sqrt(65.0 / 11.0 - 625.0 / 121.0)));
    CHECK(RaySums().standard_deviation() == 0.0);
}

} // namespace surface_tree_test
