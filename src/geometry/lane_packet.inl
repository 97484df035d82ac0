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
KERNEL_CODE Lanes beyond_ends(const LinePacket& lines, Lanes size_a, Lanes h, float slack)
{
    return absolute(h) - multiply_add(size_a, lines.half_length, Lanes::all(slack));
}

/// Of one surface for some lines: by how much they fail its tests, the approach and the distance of its plane.
struct SurfaceTest
{
    Lanes outside, a, h;
};

template <bool whole, bool triangle>
KERNEL_CODE SurfaceTest test_surface(const SurfaceBlock& block, unsigned lane, const LinePacket& lines)
{
    SurfaceTest test;
    test.a = dot(spread_lane(block.normal, lane), lines.direction);
    test.outside = beside_surface<triangle>(block, lane, lines, test.a);
    if (whole)
        return test;
    test.h = plane_distance(block, lane, lines);
    const Lanes beyond = beyond_ends(lines, absolute(test.a), test.h, SurfaceBlock::distance_slack);
    test.outside = larger(test.outside, beyond);
    return test;
}

/// Components of lines along the axes of a frame.
struct FramedLines
{
    Lanes direction[3];
    Lanes middle[3];
    Lanes slack;
};

KERNEL_CODE FramedLines in_frame(const RectangleFrame& frame, const LinePacket& lines)
{
    FramedLines framed;
    for (unsigned k = 0; k < 3; ++k) {
        const LaneVector axis = {Lanes::all(frame.axis[k][0]), Lanes::all(frame.axis[k][1]),
                                 Lanes::all(frame.axis[k][2])};
        framed.direction[k] = dot(axis, lines.direction);
        framed.middle[k] = dot(axis, lines.middle);
    }
    framed.slack = Lanes::all(FrameRectangle::slack) * lines.scale;
    return framed;
}

/// The tests of RectangleFrame for a rectangle across axis k.
template <bool whole, unsigned k>
KERNEL_CODE SurfaceTest test_rectangle(const FrameRectangle& rectangle, const LinePacket& lines,
                                       const FramedLines& framed)
{
    constexpr unsigned i = (k + 1) % 3;
    constexpr unsigned j = (k + 2) % 3;
    SurfaceTest test;
    test.a = framed.direction[k];
    test.h = Lanes::all(rectangle.offset) - framed.middle[k];
    const Lanes size_a = absolute(test.a);
    const Lanes u =
        multiply_add(test.h, framed.direction[i], (framed.middle[i] - Lanes::all(rectangle.centre_u)) * test.a);
    const Lanes v =
        multiply_add(test.h, framed.direction[j], (framed.middle[j] - Lanes::all(rectangle.centre_v)) * test.a);
    const Lanes beside_u = absolute(u) - multiply_add(Lanes::all(rectangle.half_u), size_a, framed.slack);
    const Lanes beside_v = absolute(v) - multiply_add(Lanes::all(rectangle.half_v), size_a, framed.slack);
    test.outside = larger(beside_u, beside_v);
    if (!whole)
        test.outside = larger(test.outside, beyond_ends(lines, size_a, test.h, FrameRectangle::distance_slack));
    return test;
}

/// Calls visit(s, test, slack of its h) for the rectangles across axis k of a frame; returns where those across the
/// next axis begin.
template <bool whole, unsigned k, class Visit>
KERNEL_CODE unsigned test_across(const FlatSurfaces& surfaces, const RectangleFrame& frame, unsigned s,
                                 const LinePacket& lines, const FramedLines& framed, Visit& visit)
{
    const unsigned end = surfaces.others + frame.end[k];
    for (; s < end; ++s)
        visit.surface(s, test_rectangle<whole, k>(surfaces.rectangles[s - surfaces.others], lines, framed),
                      FrameRectangle::distance_slack);
    return s;
}

/// Tests all surfaces in the order of their numbers.
template <bool whole, class Visit>
KERNEL_CODE void test_all(const FlatSurfaces& surfaces, const LinePacket& lines, Visit& visit)
{
    unsigned s = 0;
    for (; s < surfaces.triangles; ++s)
        visit.surface(s, test_surface<whole, true>(surfaces.blocks[s / 16], s % 16, lines),
                      SurfaceBlock::distance_slack);
    for (; s < surfaces.others; ++s)
        visit.surface(s, test_surface<whole, false>(surfaces.blocks[s / 16], s % 16, lines),
                      SurfaceBlock::distance_slack);
    for (unsigned f = 0; f < surfaces.frame_count; ++f) {
        const RectangleFrame& frame = surfaces.frames[f];
        const FramedLines framed = in_frame(frame, lines);
        s = test_across<whole, 0>(surfaces, frame, s, lines, framed, visit);
        s = test_across<whole, 1>(surfaces, frame, s, lines, framed, visit);
        s = test_across<whole, 2>(surfaces, frame, s, lines, framed, visit);
    }
}

/// Marks what may be met, 32 surfaces to a word.
struct Marking
{
    FlatMarks& marks;
    std::size_t first_line;
    LaneMarks found = {};

    KERNEL_CODE void surface(unsigned s, const SurfaceTest& test, float)
    {
        found.mark(test.outside, Lanes::all(0.0f), 1u << s % 32);
        if (s % 32 == 31)
            store(s);
    }
    KERNEL_CODE void store(unsigned s)
    {
        found.store(marks.word[s / 32] + first_line);
        found = {};
    }
};

KERNEL_ENTRY void filter_flat(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count, bool whole,
                              FlatMarks& marks)
{
    for (std::size_t first = 0; first < count; first += Lanes::width) {
        const LinePacket lines = load_packet(batch, first);
        Marking marking{marks, first};
        if (whole)
            test_all<true>(surfaces, lines, marking);
        else
            test_all<false>(surfaces, lines, marking);
        if (surfaces.count % 32 != 0)
            marking.store(surfaces.count - 1);
    }
}

/// Keeps the nearest surface: where at the earliest the lines can meet it, and the same for the second nearest.
struct Nearing
{
    const float* plane;
    Lanes excluded; ///< plane
    Lanes first = Lanes::all(FlatSurfaces::never);
    Lanes second = Lanes::all(FlatSurfaces::never);
    Lanes number = Lanes::all(0.0f);

    KERNEL_CODE void surface(unsigned s, const SurfaceTest& test, float slack)
    {
        const Lanes zero = Lanes::all(0.0f);
        if (not_above(test.outside, zero) == 0) // most surfaces, for most packets
            return;
        const Lanes never = Lanes::all(FlatSurfaces::never);
        const Lanes least = Lanes::all(1e-30f); // of a divisor
        const Lanes about =
            (with_sign_of(test.a, test.h) - Lanes::all(slack)) * reciprocal(larger(absolute(test.a), least));
        const Lanes earliest = about - absolute(about) * Lanes::all(2.0f * Lanes::reciprocal_error);
        const Lanes met = where_not_above(test.outside, zero, earliest, never);
        const Lanes t = where_not_above(absolute(Lanes::all(plane[s]) - excluded), zero, never, met);
        second = smaller(second, larger(first, t));
        number = where_not_above(first, t, number, Lanes::all(static_cast<float>(s)));
        first = smaller(first, t);
    }
};

KERNEL_ENTRY void nearest_flat(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count,
                               const float* excluded_planes, NearestCandidates& found)
{
    for (std::size_t first = 0; first < count; first += Lanes::width) {
        Nearing nearing{surfaces.plane, Lanes::load(excluded_planes + first)};
        test_all<false>(surfaces, load_packet(batch, first), nearing);
        nearing.first.store(found.first + first);
        nearing.second.store(found.second + first);
        nearing.number.store(found.number + first);
    }
}

} // namespace
} // namespace multipath
