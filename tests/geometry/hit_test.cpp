#include "geometry/hit.h"

#include <doctest/doctest.h>
#include <string>
#include <vector>

namespace hit_test {

using namespace multipath;

namespace {

/// "A" arrives at a front, "D" departs through one, in order of t; letters joined by '=' share their t.
/// Returns the order after order_coincident_hits, as numbers of the letters.
std::string ordered(const std::string& pattern, bool starts_in_solid = false)
{
    std::vector<Hit> hits;
    double t = 0.0;
    for (const char c : pattern) {
        if (c == '=')
            t -= 1.0;
        else
            hits.push_back(
                {t++, static_cast<std::uint32_t>(hits.size()), 0.01 * static_cast<double>(hits.size()), 0.3, c == 'A'});
    }
    order_coincident_hits(hits.data(), hits.size(), starts_in_solid);
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
    // Down through the box: top (arrival), then the bottom departs before the floor is met.
    CHECK(ordered("DAA=D") == "0132");
    CHECK(ordered("DAD=A") == "0123");
    CHECK(ordered("DD=AA") == "0213"); // a thin sheet: arrival at one face, departure from the other
    CHECK(ordered("DA=DA") == "0123");
}

TEST_CASE("at the start of a line the first hit that tells decides")
{
    // From below a floor with a box on it: floor departs, bottom is met, box top departs.
    CHECK(ordered("A=DDA") == "1023");
    CHECK(ordered("D=ADA") == "0123");
    CHECK(ordered("D=AA") == "102");      // a sheet lit from both sides: arrival first
    CHECK(ordered("D=AA=DD") == "01324"); // a box in a corner: two gaps, then something departs: still inside
    CHECK(ordered("D=AA=DA") == "10234"); // two sheets in front of something
}

// Below a floor that is seen from both sides of nothing, inside a wall that encloses all: out of the open to a box.
TEST_CASE("a floor that stands in the open is met from below before the box on it")
{
    CHECK(ordered("DD=ADA") == "01234"); // up: the wall departs, the floor, the bottom, the top, the wall
    CHECK(ordered("DA=DDA") == "02134");
    CHECK(ordered("DAA=DA") == "01324"); // down: the same reversed
    CHECK(ordered("DAD=AA") == "01234");
    CHECK(ordered("DA=DAA") == "01234"); // a sheet before a wall: arrival first
}

TEST_CASE("solids that overlap are all left before the floor on which they stand")
{
    CHECK(ordered("AAD=A=D") == "01423"); // down, whatever the order in the list
    CHECK(ordered("AAA=D=D") == "01432");
    CHECK(ordered("AAD=D=A") == "01324");
    CHECK(ordered("D=A=ADD") == "01234"); // up: the floor is left, then the bottoms are met
    CHECK(ordered("A=D=ADD") == "10234");
    CHECK(ordered("DD=A=ADDA") == "0123456"); // inside walls
    CHECK(ordered("DAAD=A=DA") == "0125346");
    CHECK(ordered("DAAD=A=D=ADDA") == "0125346789"); // two on two
    CHECK(ordered("A=A=DD") == "0213"); // the cover of a lamp on a wall: the lamp ends where the wall begins
}

TEST_CASE("when no hit tells, the kind of scene decides")
{
    CHECK(ordered("D=A") == "10");            // a sheet in the open
    CHECK(ordered("D=AA=D", true) == "0132"); // from wall to wall through a box in a corner
    CHECK(ordered("D=AA=D") == "1023");
}

TEST_CASE("what a line meets alone is a sheet in any scene")
{
    CHECK(ordered("D=A", true) == "10");
    CHECK(ordered("A=D", true) == "01");
}

// Corners in another order: u and v change places, or run the other way.
TEST_CASE("when no hit tells, faces of one outline are a sheet")
{
    const auto first_of = [](Hit other) {
        std::vector<Hit> hits = {{1.0, 0, 0.2, 0.3, false}, other, {2.0, 2, 0.1, 0.4, true}, {2.0, 3, 0.5, 0.6, false}};
        order_coincident_hits(hits.data(), hits.size(), true);
        return hits.front().surface;
    };
    CHECK(first_of({1.0, 1, 0.3, 0.2, true}) == 1);
    CHECK(first_of({1.0, 1, 0.7, 0.2, true}) == 1);
    CHECK(first_of({1.0, 1, 0.3, 0.5, true}) == 1); // barycentric 0.2, 0.3, 0.5
    CHECK(first_of({1.0, 1, 0.3, 0.4, true}) == 0);
    std::vector<Hit> from_sky = {
        {1.0, 0, 0.2, 0.3, false}, {1.0, 1, 0.3, 0.2, true}, {2.0, 2, 0.1, 0.4, true}, {2.0, 3, 0.5, 0.6, false}};
    order_coincident_hits(from_sky.data(), from_sky.size(), true, true);
    CHECK(from_sky.front().surface == 0);
}

// A plate without a back, in a room, before or behind a lamp with a cover: the plate encloses nothing.
TEST_CASE("faces of one outline are a sheet on a line through faces without backs")
{
    const Hit lamp{2.0, 0, 0.2, 0.3, true};
    const Hit cover{2.0, 1, 0.3, 0.2, false};
    const Hit plate{1.0, 2, 0.7, 0.4, true};
    const Hit wall_before{0.0, 3, 0.5, 0.6, false};
    const Hit wall_behind{3.0, 4, 0.5, 0.6, true};
    for (const double at : {1.0, 2.5}) {
        Hit here = plate;
        here.t = at;
        std::vector<Hit> hits = {wall_before, lamp, cover, wall_behind};
        hits.insert(at < 2.0 ? hits.begin() + 1 : hits.end() - 1, here);
        order_coincident_hits(hits.data(), hits.size(), true);
        const std::size_t first = at < 2.0 ? 2 : 1;
        CHECK(hits[first].surface == lamp.surface);
        CHECK(hits[first + 1].surface == cover.surface);
    }
    // Two boxes of the same outline that stand on each other, in a room: a gap.
    Hit bottom_of_upper = cover;
    Hit end_of_lower{2.5, 5, 0.5, 0.5, false};
    std::vector<Hit> hits = {wall_before, plate, lamp, bottom_of_upper, end_of_lower, wall_behind};
    order_coincident_hits(hits.data(), hits.size(), true);
    CHECK(hits[2].surface == bottom_of_upper.surface);
}

TEST_CASE("no hit is lost when coincident faces do not alternate")
{
    CHECK(ordered("DA=A=D") == "0132"); // two arrivals cannot alternate: the second comes last
    CHECK(ordered("A=A") == "01");
    CHECK(ordered("D=D=D") == "210"); // of several departures the last of the list comes first
}

} // namespace hit_test
