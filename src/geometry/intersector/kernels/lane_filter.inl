// Filter of one line against blocks of surfaces, vectorised over the surfaces of a block. Included once for each
// instruction set (see parallel/lanes/every_set.inl).

namespace multipath {
namespace LANE_SET {
namespace {

/// Three-dimensional vector in each lane.
struct LaneVector
{
    Lanes x, y, z;
};

/// The same vector in all lanes.
KERNEL_CODE LaneVector spread(const float (&v)[3])
{
    return {Lanes::all(v[0]), Lanes::all(v[1]), Lanes::all(v[2])};
}

/// dot(a, b) + c for the vectors a of the surfaces from `lane` on.
KERNEL_CODE Lanes dot_plus(const float (&a)[3][16], unsigned lane, const LaneVector& b, Lanes c)
{
    const Lanes xc = multiply_add(Lanes::load(a[0] + lane), b.x, c);
    return multiply_add(Lanes::load(a[2] + lane), b.z, multiply_add(Lanes::load(a[1] + lane), b.y, xc));
}

/// dot(a, b) for the same vectors a.
KERNEL_CODE Lanes dot_product(const float (&a)[3][16], unsigned lane, const LaneVector& b)
{
    const Lanes x = Lanes::load(a[0] + lane) * b.x;
    return multiply_add(Lanes::load(a[2] + lane), b.z, multiply_add(Lanes::load(a[1] + lane), b.y, x));
}

/// The data of a line that the tests need, in all lanes.
struct LaneLine
{
    LaneVector direction, moment, backwards; ///< backwards is -middle
    Lanes half_length, scale;
};

KERNEL_CODE LaneLine spread_line(const FilterLine& line)
{
    const float backwards[3] = {-line.middle[0], -line.middle[1], -line.middle[2]};
    return {spread(line.direction), spread(line.moment), spread(backwards), Lanes::all(line.half_length),
            Lanes::all(line.scale)};
}

/// Bits of the surfaces of the block that the line may meet: the tests of SurfaceBlock. `whole`: see FilterLine.
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
        LaneMask met = not_above(larger(absolute(u), absolute(v)), limit);
        if (triangles)
            met = not_above(met, with_sign_of(a, u + v), Lanes::load(block.diagonal + lane) * line.scale);
        if (!whole) {
            const Lanes h = dot_plus(block.normal, lane, line.backwards, Lanes::load(block.offset + lane));
            const Lanes within = multiply_add(absolute(a), line.half_length, Lanes::all(SurfaceBlock::distance_slack));
            met = not_above(met, absolute(h), within);
        }
        result |= bits(met) << lane;
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

} // namespace
} // namespace LANE_SET
} // namespace multipath
