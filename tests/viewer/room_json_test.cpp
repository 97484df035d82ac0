#include "viewer/room_json.h"

#include "image/shading/smooth_shading.h"
#include "sampling/random.h"
#include "test_scenes.h"

#include <doctest/doctest.h>
#include <map>

namespace room_json_test {

using namespace multipath;

namespace {

/// A floor with a wall standing on it, a triangle, and a lamp far above.
SceneBuilder shapes()
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 0.0);
    builder.rectangle({0, 0, 0}, {0, 0, 3}, {2, 0, 0}, grey);
    builder.rectangle({1, 0, 0}, {0, 2, 0}, {0, 0, 3}, grey);
    builder.rectangle({1, 0, 0}, {0, 0, 3}, {0, 2, 0}, grey);
    builder.triangle({10, 0, 0}, {10, 0, 2}, {12, 0, 0}, grey);
    return builder.rectangle({0, 50, 0}, {1, 0, 0}, {0, 0, 1}, builder.grey(0.5, 1.0));
}

/// The value at the corner of a patch, put together as the page does it.
class Assembled
{
public:
    Assembled(const Scene& scene, const CornerValues& corners) : scene_(scene), corners_(corners)
    {
        for (std::size_t n = 0; n < corners.places.size(); ++n)
            own_[corners.places[n]] = corners.own[n];
        std::size_t first = 0;
        for (int side = 0; side < (scene.two_sided() ? 2 : 1); ++side)
            for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s) {
                first_.push_back(first);
                const Tessellation& t = scene.tessellation(s);
                const std::size_t n = t.cells_u;
                first += t.shape == Shape::triangle ? (n + 1) * (n + 2) / 2 : (n + 1) * (t.cells_v + 1);
            }
        count_ = first;
    }

    std::size_t count() const { return count_; }
    Rgb at(std::uint32_t patch, std::uint32_t k) const
    {
        const auto own = own_.find(4 * patch + k);
        if (own != own_.end())
            return own->second;
        const std::uint32_t surface = scene_.surface_of(patch);
        const Tessellation& t = scene_.tessellation(surface);
        const GridPoint point = scene_.corners(patch).points[k];
        std::size_t number = point.i; // counted row by row
        for (std::size_t row = 0; row < point.j; ++row)
            number += t.cells_u + 1 - (t.shape == Shape::triangle ? row : 0);
        return corners_.shared[first_[surface + (scene_.is_front(patch) ? 0 : scene_.surfaces().size())] + number];
    }

private:
    const Scene& scene_;
    const CornerValues& corners_;
    std::map<std::uint32_t, Rgb> own_;
    std::vector<std::size_t> first_;
    std::size_t count_ = 0;
};

} // namespace

TEST_CASE("shared and own values together are those of smooth shading")
{
    for (const bool two_sided : {false, true}) {
        const Scene scene = shapes().scene(0.5, two_sided);
        std::vector<Rgb> values;
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
            const double x = bits_to_unit(random_bits(1, patch));
            values.push_back({1.0 + x, 2.0 * x, patch + 1.0});
        }
        const CornerValues corners = corner_values(scene, values, 1);
        const Assembled assembled(scene, corners);
        CHECK(corners.shared.size() == assembled.count());
        const SmoothShading shading(scene, values, 1);
        for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
            for (std::uint32_t k = 0; k < scene.corners(patch).count; ++k)
                if (scene.material_of(patch).emittance == Rgb{}) // of the surface, whichever side
                    CHECK(assembled.at(patch, k) == shading.at_corners(patch)[k]);
        // The floor has other values on the two sides of the wall: five or six points of its grid lie below it.
        CHECK(corners.places.size() >= 5);
        CHECK(corners.places.size() < scene.patch_count());
    }
}

TEST_CASE("a told line becomes a chain of points with the power along it")
{
    ViewerLine line;
    line.shape = {"line 1", {{{0, 0, 0}, {1, 0, 0}, false}, {{1, 0, 0}, {1.0 / 3.0, 2, 3e-9}, true}}, {{1, 0, 0}}};
    line.transfers = {{1, 7, 9, {0.5, 0.5, 0.5}, {1, 2, 3}, {1.5, 2.5, 3.5}},
                      {1, 9, Scene::no_patch, {}, {4, 4, 4}, {4, 4, 4}}};
    CHECK(story_json({"Lines", "All \"two\".", {line}}).document() ==
          "{\n  \"title\": \"Lines\",\n  \"note\": \"All \\\"two\\\".\",\n  \"lines\": [\n    {\"label\": \"line 1\", "
          "\"points\": [0, 0, 0, 1, 0, 0, 0.333333, 2, 3e-09], \"bold\": \"01\", \"meetings\": [1, 0, 0], "
          "\"transfers\": [\n    {\"stretch\": 1, \"from\": 7, \"to\": 9, \"forecast\": [0.5], \"held\": [1, 2, 3], "
          "\"counted\": [1.5, 2.5, 3.5]}, \n    {\"stretch\": 1, \"from\": 9, \"to\": null, \"forecast\": [0], "
          "\"held\": [4], \"counted\": [4]}]}]\n}\n");
}

} // namespace room_json_test
