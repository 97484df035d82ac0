// The filters of few surfaces for many lines and one instruction set, on top of lane_filter.inl and like it: included
// once by the file of each instruction set, all static. Here lines stand side by side, and one surface after the other
// is tested against as many of them as there are lanes.

namespace multipath {
namespace {

/// What the tests of surfaces need of some lines.
struct LinePacket
{
    LaneVector direction, moment, middle;
    Lanes half_length, scale;
};

KERNEL_CODE LaneVector load_columns(const float (&v)[3][LineBatch::most], std::size_t first)
{
    return {Lanes::load(v[0] + first), Lanes::load(v[1] + first), Lanes::load(v[2] + first)};
}

KERNEL_CODE LinePacket load_packet(const LineBatch& batch, std::size_t first)
{
    return {load_columns(batch.direction, first), load_columns(batch.moment, first), load_columns(batch.middle, first),
            Lanes::load(batch.half_length + first), Lanes::load(batch.scale + first)};
}

/// The vector of one surface, for all lines.
KERNEL_CODE LaneVector spread_lane(const float (&v)[3][SurfaceBlock::lanes], unsigned lane)
{
    return {Lanes::all(v[0][lane]), Lanes::all(v[1][lane]), Lanes::all(v[2][lane])};
}

KERNEL_CODE Lanes dot(const LaneVector& a, const LaneVector& b)
{
    return multiply_add(a.z, b.z, multiply_add(a.y, b.y, a.x * b.x));
}

/// By how much the lines fail the tests of SurfaceBlock: they may meet the surface where this is not above 0. `a`: the
/// approach.
template <bool triangle>
KERNEL_CODE Lanes beside_surface(const SurfaceBlock& block, unsigned lane, const LinePacket& lines, Lanes a)
{
    const Lanes u = dot(spread_lane(block.u_direction, lane), lines.direction) +
                    dot(spread_lane(block.u_moment, lane), lines.moment);
    const Lanes v = dot(spread_lane(block.v_direction, lane), lines.direction) +
                    dot(spread_lane(block.v_moment, lane), lines.moment);
    const Lanes limit = multiply_add(Lanes::all(block.slack[lane]), lines.scale, absolute(a));
    const Lanes beside = larger(absolute(u), absolute(v)) - limit;
    if (!triangle)
        return beside;
    return larger(beside, with_sign_of(a, u + v) - Lanes::all(block.diagonal[lane]) * lines.scale);
}

/// Distance of the lines' middles from the plane of the surface, along its normal.
KERNEL_CODE Lanes plane_distance(const SurfaceBlock& block, unsigned lane, const LinePacket& lines)
{
    return Lanes::all(block.offset[lane]) - dot(spread_lane(block.normal, lane), lines.middle);
}

/// By how much the crossing `h` away lies beyond the ends of the lines.
KERNEL_CODE Lanes beyond_ends(const LinePacket& lines, Lanes a, Lanes h)
{
    const Lanes within = multiply_add(absolute(a), lines.half_length, Lanes::all(SurfaceBlock::distance_slack));
    return absolute(h) - within;
}

template <bool whole, bool triangle>
KERNEL_CODE void mark_lines(const SurfaceBlock& block, unsigned lane, const LinePacket& lines, std::uint32_t bit,
                            LaneMarks& marks)
{
    const Lanes a = dot(spread_lane(block.normal, lane), lines.direction);
    Lanes outside = beside_surface<triangle>(block, lane, lines, a);
    if (!whole)
        outside = larger(outside, beyond_ends(lines, a, plane_distance(block, lane, lines)));
    marks.mark(outside, Lanes::all(0.0f), bit);
}

template <bool whole>
KERNEL_CODE void filter_packet(const FlatSurfaces& surfaces, const LinePacket& lines, std::size_t first_line,
                               FlatMarks& marks)
{
    for (unsigned first = 0; first < surfaces.count; first += 32) {
        const unsigned end = first + 32 < surfaces.count ? first + 32 : surfaces.count;
        const unsigned triangles = surfaces.triangles < end ? surfaces.triangles : end;
        LaneMarks found;
        unsigned s = first;
        for (; s < triangles; ++s)
            mark_lines<whole, true>(surfaces.blocks[s / 16], s % 16, lines, 1u << s % 32, found);
        for (; s < end; ++s)
            mark_lines<whole, false>(surfaces.blocks[s / 16], s % 16, lines, 1u << s % 32, found);
        found.store(marks.word[first / 32] + first_line);
    }
}

KERNEL_ENTRY void filter_flat(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count, bool whole,
                              FlatMarks& marks)
{
    for (std::size_t first = 0; first < count; first += Lanes::width) {
        const LinePacket lines = load_packet(batch, first);
        if (whole)
            filter_packet<true>(surfaces, lines, first, marks);
        else
            filter_packet<false>(surfaces, lines, first, marks);
    }
}

/// The nearest surface so far: where at the earliest the lines can meet it, and the same for the second nearest.
struct NearestSoFar
{
    Lanes first, second, number;
};

template <bool triangle>
KERNEL_CODE void look_for_nearer(const FlatSurfaces& surfaces, unsigned s, const LinePacket& lines, Lanes excluded,
                                 NearestSoFar& nearest)
{
    const SurfaceBlock& block = surfaces.blocks[s / 16];
    const unsigned lane = s % 16;
    const Lanes zero = Lanes::all(0.0f);
    const Lanes a = dot(spread_lane(block.normal, lane), lines.direction);
    const Lanes h = plane_distance(block, lane, lines);
    const Lanes outside = larger(beside_surface<triangle>(block, lane, lines, a), beyond_ends(lines, a, h));
    if (not_above(outside, zero) == 0) // most surfaces, for most packets
        return;
    const Lanes never = Lanes::all(FlatSurfaces::never);
    const Lanes other_plane = absolute(Lanes::all(surfaces.plane[s]) - excluded);
    const Lanes least = Lanes::all(1e-30f); // of a divisor
    const Lanes earliest = (with_sign_of(a, h) - Lanes::all(SurfaceBlock::distance_slack)) / larger(absolute(a), least);
    const Lanes met = where_not_above(outside, zero, earliest, never);
    const Lanes t = where_not_above(other_plane, zero, never, met);
    nearest.second = smaller(nearest.second, larger(nearest.first, t));
    nearest.number = where_not_above(nearest.first, t, nearest.number, Lanes::all(static_cast<float>(s)));
    nearest.first = smaller(nearest.first, t);
}

KERNEL_ENTRY void nearest_flat(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count,
                               const float* excluded_planes, NearestCandidates& found)
{
    for (std::size_t first = 0; first < count; first += Lanes::width) {
        const LinePacket lines = load_packet(batch, first);
        const Lanes excluded = Lanes::load(excluded_planes + first);
        const Lanes never = Lanes::all(FlatSurfaces::never);
        NearestSoFar nearest = {never, never, Lanes::all(0.0f)};
        unsigned s = 0;
        for (; s < surfaces.triangles; ++s)
            look_for_nearer<true>(surfaces, s, lines, excluded, nearest);
        for (; s < surfaces.count; ++s)
            look_for_nearer<false>(surfaces, s, lines, excluded, nearest);
        nearest.first.store(found.first + first);
        nearest.second.store(found.second + first);
        nearest.number.store(found.number + first);
    }
}

} // namespace
} // namespace multipath
