#include "radiosity/reuse/surface_tree.h"

#include "test_scenes.h"

#include <algorithm>
#include <doctest/doctest.h>

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
    const std::vector<RaySums> found = pooled(tree, own, 4.0, 2);
    CHECK(found[0].value == 20.0);
    CHECK(found[1].value == 25.0); // with its neighbour
    CHECK(found[2].value == 26.0); // 3 rays with its neighbour are too few
    CHECK(found[3].rays == 14.0);
    CHECK(found[0].standard_deviation() == 0.0);
    CHECK(found[1].standard_deviation() == doctest::Approx(std::sqrt(65.0 / 11.0 - 625.0 / 121.0)));
    CHECK(RaySums().standard_deviation() == 0.0);
}

} // namespace surface_tree_test
