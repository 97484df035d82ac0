// Construction of an intersector. Coplanar surfaces get a common plane first (see share_planes). Then a small scene
// gets blocks of surfaces, which are all tested against every line, and a large scene a hierarchy. Surfaces that single
// precision cannot describe (see can_be_filtered) are in neither and are tested in double precision.

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

} // namespace

/// The data structures built first. Planes and hierarchy take about the same time and are built in parallel.
struct Intersector::Core::Groundwork
{
    FilterFrame frame;
    LargeVector<Bounds> boxes;
    SharedPlanes planes;
    std::vector<std::uint32_t> size_rank;
    PlaneNeighbours neighbours;
    WideTree tree; ///< over all surfaces, if they are many

    static Groundwork of(const SurfaceList& surfaces, int threads)
    {
        Groundwork ground;
        ground.frame = FilterFrame(box_around(surfaces));
        ground.boxes = boxes_around_each(surfaces);
        parallel_blocks(2, threads, [&](std::uint64_t part) {
            if (part == 0)
                ground.find_planes(surfaces);
            else if (surfaces.size() > FlatSurfaces::most)
                ground.arrange();
        });
        ground.neighbours =
            PlaneNeighbours(surfaces, ground.boxes, ground.planes.plane_number, ground.tree, ground.frame, threads);
        return ground;
    }

private:
    void find_planes(const SurfaceList& surfaces)
    {
        const std::vector<std::uint32_t> order = order_by_descending_area(surfaces);
        planes = share_planes(surfaces, order);
        size_rank = size_ranks(order);
    }

    void arrange()
    {
        std::vector<std::uint32_t> all(boxes.size());
        std::iota(all.begin(), all.end(), 0u);
        tree = WideTree(boxes, all, frame);
    }
};

Intersector::Core::Core(const SurfaceList& surfaces, const FilterKernel& kernel, int threads)
    : Core(surfaces, Groundwork::of(surfaces, threads), kernel, threads)
{
}

Intersector::Core::Core(const SurfaceList& surfaces, Groundwork groundwork, const FilterKernel& kernel, int threads)
    : kernel_(&kernel),
      table_(surfaces, groundwork.planes, threads),
      frame_(groundwork.frame),
      tree_(std::move(groundwork.tree)),
      outside_is_solid_(is_interior(surfaces)),
      plane_(std::move(groundwork.planes.plane_number)),
      size_rank_(std::move(groundwork.size_rank)),
      neighbours_(std::move(groundwork.neighbours))
{
    const std::vector<std::uint32_t> filtered = sort_out_unfiltered(surfaces, threads);
    if (filtered.size() <= FlatSurfaces::most)
        framed_ = group_by_frames(table_, filtered, frame_);
    if (filtered.size() <= FlatSurfaces::most && is_few(framed_)) {
        tree_ = {};
        lane_number_.assign(framed_.others.begin(), framed_.others.end());
        lane_number_.insert(lane_number_.end(), framed_.surfaces.begin(), framed_.surfaces.end());
    } else {
        if (tree_.empty() || !unfiltered_.empty())
            tree_ = WideTree(groundwork.boxes, filtered, frame_);
        framed_ = {};
    }
    if (tree_.empty())
        fill_blocks();
    else
        fill_leaves(threads);
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

void Intersector::Core::fill_blocks()
{
    const auto end_of_triangles = std::stable_partition(lane_number_.begin(), lane_number_.end(),
                                                        [this](std::uint32_t s) { return table_.is_triangle(s); });
    flat_triangles_ = static_cast<unsigned>(end_of_triangles - lane_number_.begin());
    flat_number_.assign(lane_number_.begin(), lane_number_.end());
    for (const std::uint32_t surface : lane_number_)
        flat_plane_.push_back(static_cast<float>(plane_[surface]));
    blocks_.resize((lane_number_.size() + SurfaceBlock::lanes - 1) / SurfaceBlock::lanes, empty_block());
    for (std::size_t i = 0; i < lane_number_.size(); ++i)
        fill_lane(blocks_[i / SurfaceBlock::lanes], i % SurfaceBlock::lanes, table_.row(lane_number_[i]), frame_);
}

void Intersector::Core::fill_leaves(int threads)
{
    const LargeVector<std::uint32_t>& surfaces = tree_.primitives();
    leaves_.resize(surfaces.size() / LeafBlock::lanes);
    const auto count = static_cast<std::uint32_t>(leaves_.size());
    parallel_ranges(count, prepared_at_a_time, threads, [&](std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t leaf = first; leaf < end; ++leaf) {
            const std::uint32_t* const begin = surfaces.data() + std::size_t{LeafBlock::lanes} * leaf;
            const std::uint32_t* const last = std::find(begin, begin + LeafBlock::lanes, WideTree::nothing);
            leaves_[leaf] = leaf_of(table_, begin, static_cast<unsigned>(last - begin), frame_);
        }
    });
}

Intersector::Intersector(const SurfaceList& surfaces, int threads)
    : Intersector(surfaces, *available_kernels()[0], threads)
{
}

Intersector::Intersector(const SurfaceList& surfaces, const FilterKernel& kernel, int threads)
    : core_(std::make_unique<const Core>(surfaces, kernel, threads))
{
}

Intersector::~Intersector() = default;
Intersector::Intersector(Intersector&&) noexcept = default;
Intersector& Intersector::operator=(Intersector&&) noexcept = default;

} // namespace multipath
