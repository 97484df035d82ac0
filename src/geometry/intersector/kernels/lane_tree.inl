// The way through the hierarchy for one instruction set, on top of lane_filter.inl and like it: included once by the
// file of each instruction set, all static.

namespace multipath {
namespace LANE_SET {
namespace {

/// What the tests of boxes need of a line: where it meets the planes x = c is c * inverse.x + at_zero.x.
struct LaneSlabs
{
    LaneVector inverse, at_zero;
    bool negative[3]; ///< the line meets the high planes first
};

KERNEL_CODE LaneSlabs slabs_of(const FilterLine& line)
{
    LaneSlabs slabs;
    float inverse[3];
    float at_zero[3];
    const float least = 1e-12f * line.scale; // stands for 0 and moves nothing by more than that
    for (int i = 0; i < 3; ++i) {
        const float d = line.direction[i];
        slabs.negative[i] = d < 0.0f;
        const float away_from_zero = d < 0.0f ? (d > -least ? -least : d) : (d < least ? least : d);
        inverse[i] = 1.0f / away_from_zero;
        at_zero[i] = -line.middle[i] * inverse[i];
    }
    slabs.inverse = spread(inverse);
    slabs.at_zero = spread(at_zero);
    return slabs;
}

KERNEL_CODE Lanes planes(const WideNode& node, int axis, bool high, unsigned lane)
{
    return Lanes::load((high ? node.high : node.low)[axis] + lane);
}

/// The children whose boxes the line meets between its beginning and `limit`, and where it enters them.
KERNEL_CODE unsigned boxes_met(const WideNode& node, const LaneSlabs& slabs, float first, float limit, float* entry)
{
    unsigned met = 0;
    for (unsigned lane = 0; lane < WideNode::lanes; lane += Lanes::width) {
        const Lanes in_x = multiply_add(planes(node, 0, slabs.negative[0], lane), slabs.inverse.x, slabs.at_zero.x);
        const Lanes in_y = multiply_add(planes(node, 1, slabs.negative[1], lane), slabs.inverse.y, slabs.at_zero.y);
        const Lanes in_z = multiply_add(planes(node, 2, slabs.negative[2], lane), slabs.inverse.z, slabs.at_zero.z);
        const Lanes out_x = multiply_add(planes(node, 0, !slabs.negative[0], lane), slabs.inverse.x, slabs.at_zero.x);
        const Lanes out_y = multiply_add(planes(node, 1, !slabs.negative[1], lane), slabs.inverse.y, slabs.at_zero.y);
        const Lanes out_z = multiply_add(planes(node, 2, !slabs.negative[2], lane), slabs.inverse.z, slabs.at_zero.z);
        const Lanes in = larger(larger(in_x, in_y), larger(in_z, Lanes::all(first)));
        const Lanes out = smaller(smaller(out_x, out_y), smaller(out_z, Lanes::all(limit)));
        in.store(entry + lane);
        met |= bits(not_above(in, out)) << lane;
    }
    return met;
}

constexpr unsigned list_size = 256; ///< blocks that a line collects before they are tested

/// A child still to be looked at.
struct Pending
{
    float entry;
    std::uint32_t child;
};

/// Asks for the memory of a child that will be looked at soon. The processor itself goes on to the rest of a block.
KERNEL_CODE void prefetch_child(const WideNode* nodes, const SurfaceBlock* blocks, std::uint32_t child)
{
    const void* const start = child < WideNode::block_flag
                                  ? static_cast<const void*>(nodes + child)
                                  : static_cast<const void*>(blocks + (child - WideNode::block_flag));
    for (unsigned line = 0; line < sizeof(WideNode); line += 64)
        __builtin_prefetch(static_cast<const char*>(start) + line);
}

/// Puts the children that were met onto the stack, the nearest on top.
KERNEL_CODE Pending* push_children(Pending* top, unsigned met, const WideNode& node, const float* entry,
                                   const WideNode* nodes, const SurfaceBlock* blocks)
{
    Pending* const bottom = top;
    for (; met != 0; met &= met - 1) {
        const int i = __builtin_ctz(met);
        Pending* place = top++;
        for (; place > bottom && place[-1].entry < entry[i]; --place)
            *place = place[-1];
        *place = {entry[i], node.child[i]};
        prefetch_child(nodes, blocks, node.child[i]);
    }
    return top;
}

/// Tests the blocks of a list and hands over those with a surface that the line may meet.
KERNEL_CODE void visit_list(const SurfaceBlock* blocks, const std::uint32_t* list, unsigned count, const LaneLine& line,
                            VisitBlocks visit, void* context)
{
    BlockLanes found[list_size];
    unsigned found_count = 0;
    for (unsigned i = 0; i < count; ++i) {
        const std::uint32_t block = list[i] - WideNode::block_flag;
        const unsigned met = filter_block<false>(blocks[block], line);
        found[found_count] = {block, met};
        found_count += met != 0;
    }
    visit(context, found, found_count);
}

KERNEL_ENTRY void visit_all(const WideNode* nodes, const SurfaceBlock* blocks, const FilterLine& line,
                            VisitBlocks visit, void* context)
{
    const LaneSlabs slabs = slabs_of(line);
    const LaneLine lanes = spread_line(line);
    std::uint32_t stack[WideNode::stack_size];
    std::uint32_t list[list_size];
    unsigned list_count = 0;
    alignas(64) float entry[WideNode::lanes];
    stack[0] = 0;
    for (unsigned depth = 1; depth > 0;) {
        const WideNode& node = nodes[stack[--depth]];
        unsigned met = boxes_met(node, slabs, -line.half_length, line.half_length, entry);
        for (; met != 0; met &= met - 1) { // onto both piles, then only one grows: which one is hard to predict
            const std::uint32_t child = node.child[__builtin_ctz(met)];
            const unsigned is_block = child / WideNode::block_flag;
            prefetch_child(nodes, blocks, child);
            stack[depth] = list[list_count] = child;
            depth += 1 - is_block;
            list_count += is_block;
        }
        if (list_count > list_size - WideNode::lanes) {
            visit_list(blocks, list, list_count, lanes, visit, context);
            list_count = 0;
        }
    }
    visit_list(blocks, list, list_count, lanes, visit, context);
}

KERNEL_ENTRY void visit_nearest(const WideNode* nodes, const SurfaceBlock* blocks, const FilterLine& line,
                                VisitBlock visit, void* context)
{
    const LaneSlabs slabs = slabs_of(line);
    const LaneLine lanes = spread_line(line);
    float limit = line.half_length;
    Pending stack[WideNode::stack_size];
    alignas(64) float entry[WideNode::lanes];
    stack[0] = {-line.half_length, 0};
    for (Pending* top = stack + 1; top > stack;) {
        const Pending next = *--top;
        if (next.entry > limit)
            continue;
        if ((next.child & WideNode::block_flag) == 0) {
            const WideNode& node = nodes[next.child];
            const unsigned met = boxes_met(node, slabs, -line.half_length, limit, entry);
            top = push_children(top, met, node, entry, nodes, blocks);
            continue;
        }
        const std::uint32_t block = next.child - WideNode::block_flag;
        const unsigned met = filter_block<false>(blocks[block], lanes);
        if (met != 0)
            limit = visit(context, block, met);
    }
}

} // namespace
} // namespace LANE_SET
} // namespace multipath
