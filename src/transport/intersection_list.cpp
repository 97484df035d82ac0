#include "transport/intersection_list.h"

namespace multipath {

namespace {

std::uint32_t patch_or_behind(const Scene& scene, const Hit& hit, bool front)
{
    const std::uint32_t patch = scene.patch_at(hit.surface, hit.u, hit.v, front);
    return patch == Scene::no_patch ? Segment::behind : patch;
}

} // namespace

void append_passages(const Scene& scene, HitLists::List hits, std::vector<Passage>& passages)
{
    for (const Hit& hit : hits)
        passages.push_back({patch_or_behind(scene, hit, hit.front), patch_or_behind(scene, hit, !hit.front)});
}

void append_segments(const Scene& scene, HitLists::List hits, std::vector<Segment>& segments)
{
    std::uint32_t from = Segment::outside;
    const auto append = [&](std::uint32_t to) {
        if (Segment::is_patch(from) || Segment::is_patch(to))
            segments.push_back({from, to});
    };
    for (const Hit& hit : hits) {
        append(patch_or_behind(scene, hit, hit.front)); // the side that the line arrives at
        from = patch_or_behind(scene, hit, !hit.front); // the side that it leaves
    }
    if (!hits.empty())
        append(Segment::outside);
}

} // namespace multipath
