#include "transport/lines/line_segments.h"

#include "geometry/conditions.h"

namespace multipath {

Passage passage_at(const Scene& scene, const Hit& hit)
{
    const Scene::Sides sides = scene.patches_at(hit.surface, hit.u, hit.v, Segment::behind);
    return hit.front ? Passage{sides.front, sides.back} : Passage{sides.back, sides.front};
}

namespace {

/// Writes the segments of one line to `out`, at most one more than it has hits, and returns the end of what was
/// written. Branchless: every segment is stored, and `out` advances only past those that touch a patch, which cannot be
/// predicted.
Segment* write_segments(const Scene& scene, HitLists::List hits, Segment* out)
{
    std::uint32_t from = Segment::outside;
    const auto write = [&](std::uint32_t to) {
        *out = {from, to};
        out += any(Segment::is_patch(from), Segment::is_patch(to));
    };
    for (const Hit& hit : hits) {
        const Passage passage = passage_at(scene, hit);
        write(passage.arrives_at);
        from = passage.leaves;
    }
    write(Segment::outside);
    return out;
}

} // namespace

void append_segments(const Scene& scene, HitLists::List hits, std::vector<Segment>& segments)
{
    const std::size_t before = segments.size();
    segments.resize(before + hits.size() + 1);
    const Segment* end = write_segments(scene, hits, segments.data() + before);
    segments.resize(static_cast<std::size_t>(end - segments.data()));
}

void find_segments(const Scene& scene, const HitLists& lists, std::vector<Segment>& segments)
{
    segments.resize(lists.hit_count() + lists.size() + 1);
    Segment* end = segments.data();
    for (std::size_t line = 0; line < lists.size(); ++line)
        end = write_segments(scene, lists[line], end);
    segments.resize(static_cast<std::size_t>(end - segments.data()));
}

} // namespace multipath
