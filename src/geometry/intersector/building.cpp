// Construction of an intersector. Coplanar surfaces get a common plane first (see share_planes). Then all surfaces get
// a hierarchy; those of a small scene also get lists, all of which are tested against many lines at a time. Surfaces
// that single precision cannot describe (see can_be_filtered) are in neither and are tested in double precision.

#include "geometry/intersector/core.h"

#include "geometry/intersector/block_filling.h"
#include "geometry/intersector/surface_sizes.h"
#include "parallel/blocks.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace multipath {

namespace {

constexpr std::uint32_t prepared_at_a_time = 1024; ///< surfaces or leaves per range of the parallel loops

/// True if testing all surfaces is faster than a hierarchy. The measured relative costs are those of a rectangle, of a
/// frame, paid once for all of its rectangles, and of any other surface.
bool is_few(const FramedRectangles& framed)
{
    const std::size_t surfaces = framed.rectangles.size() + framed.others.size();
    const std::size_t cost = 8 * framed.rectangles.size() + 18 * framed.frames.size() + 20 * framed.others.size();
    return surfaces <= FlatSurfaces::most && cost <= 2560;
}

WideTree tree_over_all(const LargeVector<Bounds>& boxes, const FilterFrame& frame)
{
    std::vector<std::uint32_t> all(boxes.size());
    std::iota(all.begin(), all.end(), 0u);
    return WideTree(boxes, all, frame);
}

} // namespace

Intersector::Core::Core(const SurfaceList& surfaces, const FilterKernel& kernel, int threads, std::size_t enclosing)
    : kernel_(&kernel),
      frame_(box_around(surfaces)),
      first_enclosing_(surfaces.size() - enclosing),
      outside_is_solid_(is_interior({surfaces.begin(), surfaces.end() - static_cast<std::ptrdiff_t>(enclosing)}))
{
    const LargeVector<Bounds> boxes = boxes_around_each(surfaces);
    SharedPlanes planes;
    // Planes and hierarchy take about the same time and are built in parallel.
    parallel_blocks(2, threads, [&](std::uint64_t part) {
        if (part == 0) {
            planes = share_planes(surfaces, order_by_descending_area(surfaces));
        } else if (surfaces.size() > FlatSurfaces::most) {
            tree_ = tree_over_all(boxes, frame_);
        }
    });
    neighbours_ = PlaneNeighbours(surfaces, boxes, planes.plane_number, tree_, frame_, threads);
    table_ = SurfaceTable(surfaces, planes, threads);
    area_.reserve(surfaces.size());
    for (const Surface& surface : surfaces)
        area_.push_back(surface.area());
    plane_ = std::move(planes.plane_number);

    const std::vector<std::uint32_t> filtered = sort_out_unfiltered(surfaces, threads);
    if (filtered.size() <= FlatSurfaces::most)
        store_flat(group_by_frames(table_, filtered, frame_));
    if (tree_.empty() || !unfiltered_.empty())
        tree_ = WideTree(boxes, filtered, frame_);
    store_leaves(threads);
}

/// Stores the surfaces that cannot be filtered in unfiltered_ and returns the others.
std::vector<std::uint32_t> Intersector::Core::sort_out_unfiltered(const SurfaceList& surfaces, int threads)
{
    std::vector<unsigned char> fits(surfaces.size());
    parallel_ranges(table_.size(), prepared_at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t s = first; s < end; ++s)
            fits[s] = can_be_filtered(table_.row(s), surfaces[s], frame_);
    });
    std::vector<std::uint32_t> filtered;
    for (std::uint32_t s = 0; s < surfaces.size(); ++s)
        (fits[s] != 0 ? filtered : unfiltered_).push_back(s);
    return filtered;
}

/// Stores what FlatSurfaces shows, if the surfaces are few.
void Intersector::Core::store_flat(FramedRectangles framed)
{
    is_few_ = is_few(framed);
    if (!is_few_)
        return;
    framed_ = std::move(framed);
    const std::vector<std::uint32_t>& others = framed_.others;
    for (std::size_t first = 0; first < others.size(); first += SurfaceBlock::lanes) {
        const std::size_t count = std::min<std::size_t>(SurfaceBlock::lanes, others.size() - first);
        flat_blocks_.push_back(block_of(table_, others.data() + first, count, frame_));
    }
    flat_surface_ = others;
    flat_surface_.insert(flat_surface_.end(), framed_.surfaces.begin(), framed_.surfaces.end());
    for (const std::uint32_t surface : flat_surface_)
        flat_plane_.push_back(static_cast<float>(plane_[surface]));
    flat_ = {flat_blocks_.data(),
             flat_plane_.data(),
             static_cast<unsigned>(others.size()),
             static_cast<unsigned>(flat_surface_.size()),
             framed_.frames.data(),
             static_cast<unsigned>(framed_.frames.size()),
             framed_.rectangles.data()};
}

void Intersector::Core::store_leaves(int threads)
{
    const LargeVector<std::uint32_t>& surfaces = tree_.primitives();
    leaves_.resize(surfaces.size() / SurfaceBlock::lanes);
    const auto count = static_cast<std::uint32_t>(leaves_.size());
    parallel_ranges(count, prepared_at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t leaf = first; leaf < end; ++leaf) {
            const std::uint32_t* const begin = surfaces.data() + std::size_t{SurfaceBlock::lanes} * leaf;
            const std::uint32_t* const last = std::find(begin, begin + SurfaceBlock::lanes, WideTree::nothing);
            leaves_[leaf] = block_of(table_, begin, static_cast<std::size_t>(last - begin), frame_);
        }
    });
}

Intersector::Intersector(const SurfaceList& surfaces, int threads, std::size_t enclosing)
    : Intersector(surfaces, *available_kernels()[0], threads, enclosing)
{
}

Intersector::Intersector(const SurfaceList& surfaces, const FilterKernel& kernel, int threads, std::size_t enclosing)
    : core_(std::make_unique<const Core>(surfaces, kernel, threads, enclosing))
{
}

Intersector::~Intersector() = default;
Intersector::Intersector(Intersector&&) noexcept = default;
Intersector& Intersector::operator=(Intersector&&) noexcept = default;

} // namespace multipath
