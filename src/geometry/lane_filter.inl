// The filters for one instruction set. To be included once by the file of each instruction set, after
//   KERNEL_CODE   what functions must carry: the instruction set, for these functions alone, and to be expanded in
//   place KERNEL_ENTRY  the same for functions that are called Lanes         that many floats side by side, with the
//   functions used below
// All is static, so that no code for a special processor can be taken for that of the rest of the program.
//
// lane_filter_plain.cpp is the version to read first: one lane, ordinary arithmetic.

namespace multipath {
namespace {

/// Three numbers of a line, each in all lanes.
struct LaneVector
{
    Lanes x, y, z;
};

KERNEL_CODE LaneVector spread(const float (&v)[3])
{
    return {Lanes::all(v[0]), Lanes::all(v[1]), Lanes::all(v[2])};
}

/// dot(a, b) + c for vectors a of the lanes from `lane`.
KERNEL_CODE Lanes dot_plus(const float (&a)[3][16], unsigned lane, const LaneVector& b, Lanes c)
{
    const Lanes xc = multiply_add(Lanes::load(a[0] + lane), b.x, c);
    return multiply_add(Lanes::load(a[2] + lane), b.z, multiply_add(Lanes::load(a[1] + lane), b.y, xc));
}

KERNEL_CODE Lanes dot_product(const float (&a)[3][16], unsigned lane, const LaneVector& b)
{
    const Lanes x = Lanes::load(a[0] + lane) * b.x;
    return multiply_add(Lanes::load(a[2] + lane), b.z, multiply_add(Lanes::load(a[1] + lane), b.y, x));
}

/// What the tests of surfaces need of a line.
struct LaneLine
{
    LaneVector direction, moment, backwards; ///< backwards: -middle
    Lanes half_length, scale;
};

KERNEL_CODE LaneLine spread_line(const FilterLine& line)
{
    const float backwards[3] = {-line.middle[0], -line.middle[1], -line.middle[2]};
    return {spread(line.direction), spread(line.moment), spread(backwards), Lanes::all(line.half_length),
            Lanes::all(line.scale)};
}

/// The surfaces of the block that the line may meet: see SurfaceBlock for the tests. `whole`: the line's ends lie
/// outside of the scene.
template <bool whole, bool triangles>
KERNEL_CODE unsigned filter_surfaces(const SurfaceBlock& block, const LaneLine& line)
{
    unsigned result = 0;
    for (unsigned lane = 0; lane < SurfaceBlock::lanes; lane += Lanes::width) {
        const Lanes a = dot_product(block.normal, lane, line.direction);
        const Lanes u =
            dot_plus(block.u_direction, lane, line.direction, dot_product(block.u_moment, lane, line.moment));
        const Lanes v =
            dot_plus(block.v_direction, lane, line.direction, dot_product(block.v_moment, lane, line.moment));
        const Lanes limit = multiply_add(Lanes::load(block.slack + lane), line.scale, absolute(a));
        unsigned met = not_above(larger(absolute(u), absolute(v)), limit);
        if (triangles)
            met &= not_above(with_sign_of(a, u + v), Lanes::load(block.diagonal + lane) * line.scale);
        if (!whole) {
            const Lanes h = dot_plus(block.normal, lane, line.backwards, Lanes::load(block.offset + lane));
            const Lanes within = multiply_add(absolute(a), line.half_length, Lanes::all(SurfaceBlock::distance_slack));
            met &= not_above(absolute(h), within);
        }
        result |= met << lane;
    }
    return result;
}

template <bool whole>
KERNEL_CODE unsigned filter_block(const SurfaceBlock& block, const LaneLine& line)
{
    return block.diagonal[0] < SurfaceBlock::no_diagonal ? filter_surfaces<whole, true>(block, line)
                                                         : filter_surfaces<whole, false>(block, line);
}

template <bool whole>
KERNEL_CODE void filter_blocks(const SurfaceBlock* blocks, std::uint32_t block_count, const LaneLine& line,
                               std::uint64_t* masks)
{
    for (std::uint32_t first = 0; first < block_count; first += 4) {
        std::uint64_t mask = 0;
        for (std::uint32_t b = first; b < block_count && b < first + 4; ++b)
            mask |= std::uint64_t{filter_block<whole>(blocks[b], line)} << 16 * (b - first);
        *masks++ = mask;
    }
}

KERNEL_ENTRY void filter_line(const SurfaceBlock* blocks, std::uint32_t block_count, const FilterLine& line,
                              std::uint64_t* masks)
{
    if (line.whole)
        filter_blocks<true>(blocks, block_count, spread_line(line), masks);
    else
        filter_blocks<false>(blocks, block_count, spread_line(line), masks);
}

KERNEL_CODE LaneVector spread_column(const float (&v)[3][LineBatch::most], std::size_t i, float factor = 1.0f)
{
    return {Lanes::all(factor * v[0][i]), Lanes::all(factor * v[1][i]), Lanes::all(factor * v[2][i])};
}

KERNEL_ENTRY void filter_flat(const SurfaceBlock* blocks, std::uint32_t block_count, const LineBatch& batch,
                              const std::uint32_t* numbers, std::size_t count, std::uint64_t* masks)
{
    const std::size_t words = (block_count + 3) / 4;
    for (std::size_t n = 0; n < count; ++n) {
        const std::uint32_t i = numbers[n];
        const LaneLine line = {spread_column(batch.direction, i), spread_column(batch.moment, i),
                               spread_column(batch.middle, i, -1.0f), Lanes::all(batch.half_length[i]),
                               Lanes::all(batch.scale[i])};
        if (batch.whole[i] != 0)
            filter_blocks<true>(blocks, block_count, line, masks + words * n);
        else
            filter_blocks<false>(blocks, block_count, line, masks + words * n);
    }
}

/// FilterFrame::place in a loop that the compiler vectorises for the instruction set.
KERNEL_ENTRY void place_lines(const FilterFrame& frame, const Line* lines, std::size_t count, LineBatch& batch)
{
    const FilterFrame local = frame; // nothing that is written below can change it
    alignas(64) double origin[3][LineBatch::most];
    alignas(64) double direction[3][LineBatch::most];
    alignas(64) double t_max[LineBatch::most];
    for (std::size_t i = 0; i < count; ++i) {
        origin[0][i] = lines[i].origin.x;
        origin[1][i] = lines[i].origin.y;
        origin[2][i] = lines[i].origin.z;
        direction[0][i] = lines[i].direction.x;
        direction[1][i] = lines[i].direction.y;
        direction[2][i] = lines[i].direction.z;
        t_max[i] = lines[i].t_max;
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Line line = {
            {origin[0][i], origin[1][i], origin[2][i]}, {direction[0][i], direction[1][i], direction[2][i]}, t_max[i]};
        FilterLine placed;
        batch.course[i] = local.place(line, placed);
        batch.direction[0][i] = placed.direction[0];
        batch.direction[1][i] = placed.direction[1];
        batch.direction[2][i] = placed.direction[2];
        batch.moment[0][i] = placed.moment[0];
        batch.moment[1][i] = placed.moment[1];
        batch.moment[2][i] = placed.moment[2];
        batch.middle[0][i] = placed.middle[0];
        batch.middle[1][i] = placed.middle[1];
        batch.middle[2][i] = placed.middle[2];
        batch.half_length[i] = placed.half_length;
        batch.scale[i] = placed.scale;
        batch.whole[i] = placed.whole;
    }
}

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
        met |= not_above(in, out) << lane;
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

/// Asks for the memory of a child that will be looked at soon.
KERNEL_CODE void prefetch(const void* from, unsigned size)
{
    for (unsigned line = 0; line < size; line += 64)
        __builtin_prefetch(static_cast<const char*>(from) + line);
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
        if ((node.child[i] & WideNode::block_flag) != 0)
            prefetch(blocks + (node.child[i] - WideNode::block_flag), sizeof(SurfaceBlock));
        else
            prefetch(nodes + node.child[i], sizeof(WideNode));
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
            const void* const address =
                is_block != 0 ? static_cast<const void*>(blocks + (child - WideNode::block_flag)) : nodes + child;
            prefetch(address, sizeof(WideNode));
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
} // namespace multipath
