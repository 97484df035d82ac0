#include "radiosity/intersection_list.h"

#include "test_scenes.h"

#include <doctest/doctest.h>
#include <string>

using namespace multipath;

namespace {

/// "A" arrives at a front, "D" departs through one, in order of t; letters joined by '=' share their t.
/// Returns the order after order_coincident_hits, as numbers of the letters.
std::string ordered(const std::string& pattern)
{
    std::vector<Hit> hits;
    double t = 0.0;
    for (const char c : pattern) {
        if (c == '=')
            t -= 1.0;
        else
            hits.push_back({t++, static_cast<std::uint32_t>(hits.size()), 0.5, 0.5, c == 'A'});
    }
    order_coincident_hits(hits);
    std::string order;
    for (const Hit& hit : hits)
        order += std::to_string(hit.surface);
    return order;
}

} // namespace

TEST_CASE("hits of different t stay where they are")
{
    CHECK(ordered("DADA") == "0123");
    CHECK(ordered("AADD") == "0123");
}

// A box resting on a floor: the line leaves the box through its bottom and arrives at the floor, both at one t.
TEST_CASE("coincident faces continue the alternation of departures and arrivals")
{
    CHECK(ordered("DAA=D") ==
          "0132"); // down through the box: top (arrival), then bottom departs before the floor is met
    CHECK(ordered("DAD=A") == "0123");
    CHECK(ordered("DD=AA") == "0213"); // a thin sheet: arrival at one face, departure from the other
    CHECK(ordered("DA=DA") == "0123");
}

TEST_CASE("at the start of a line what comes next decides")
{
    CHECK(ordered("A=DDA") ==
          "1023"); // from below a floor with a box on it: floor departs, bottom is met, box top departs
    CHECK(ordered("D=ADA") == "0123");
    CHECK(ordered("D=AA") == "102"); // a sheet lit from both sides: arrival first
    CHECK(ordered("D=A") == "10");
}

TEST_CASE("no hit is lost when coincident faces do not alternate")
{
    CHECK(ordered("DA=A=D") == "0132"); // two arrivals cannot alternate: the second comes last
    CHECK(ordered("A=A") == "01");
    CHECK(ordered("D=D=D") == "012");
}

TEST_CASE("segments join departures and arrivals and name what has no patch")
{
    SceneBuilder builder;
    const std::uint32_t grey = builder.grey(0.5, 1.0);
    builder.rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, grey); // 0: looks up
    builder.rectangle({0, 1, 0}, {0, 0, 1}, {1, 0, 0}, grey); // 1: looks up too, so it shows its back to 0
    builder.rectangle({0, 2, 0}, {1, 0, 0}, {0, 0, 1}, grey); // 2: looks down
    const auto segments_of = [](const Scene& scene) {
        std::vector<Hit> hits;
        std::vector<Segment> segments;
        scene.intersector().all_hits({{0.5, -1, 0.5}, {0, 1, 0}}, hits);
        append_segments(scene, hits, segments);
        return segments;
    };
    const std::vector<Segment> one_sided = segments_of(builder.scene(1.0));
    REQUIRE(one_sided.size() == 2); // those between a back and nothing are left out
    CHECK((one_sided[0].from == 0 && one_sided[0].to == Segment::behind));
    CHECK((one_sided[1].from == 1 && one_sided[1].to == 2));

    const std::vector<Segment> two_sided = segments_of(builder.scene(1.0, true)); // backs are patches 3, 4, 5
    REQUIRE(two_sided.size() == 4);
    CHECK((two_sided[0].from == Segment::outside && two_sided[0].to == 3));
    CHECK((two_sided[1].from == 0 && two_sided[1].to == 4));
    CHECK((two_sided[2].from == 1 && two_sided[2].to == 2));
    CHECK((two_sided[3].from == 5 && two_sided[3].to == Segment::outside));
}
