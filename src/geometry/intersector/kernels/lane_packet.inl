// Filters of small scenes for many lines, vectorised over the lines: a packet of as many lines as there are lanes is
// tested against one surface after the other. Included after lane_filter.inl, once for each instruction set.

namespace multipath {
namespace LANE_SET {
namespace {

/// The data of Lanes::width lines that the tests need.
struct LinePacket
{
    LaneVector direction, middle;
    Lanes half_length, scale;
};

KERNEL_CODE LinePacket load_packet(const LineBatch& batch, std::size_t first)
{
    return {load_columns(batch.direction, first), load_columns(batch.middle, first),
            Lanes::load(batch.half_length + first), Lanes::load(batch.scale + first)};
}

/// Result of the test of one surface: the lines that may meet the surface, and for each of them a lower bound of t at
/// the hit, counted from the middle of the line.
struct SurfaceTest
{
    LaneMask met;
    Lanes earliest;
};

/// The tests of SurfaceBlock for the surface in one lane.
KERNEL_CODE SurfaceTest test_surface(const SurfaceBlock& block, unsigned lane, const LinePacket& lines)
{
    const PlaneCrossing crossing =
        cross_plane({spread_column(block.corner, lane), spread_column(block.edge_u, lane),
                     spread_column(block.edge_v, lane), Lanes::all(block.slack[lane])},
                    lines.middle, lines.direction, lines.scale);
    const Lanes least = Lanes::all(1e-30f); // divisor for which reciprocal() is still valid
    const Lanes about = (crossing.t - crossing.distance_slack) * reciprocal(larger(crossing.a, least));
    return {crossing.may_meet(Lanes::all(0.0f) - lines.half_length, lines.half_length),
            about - absolute(about) * Lanes::all(2.0f * Lanes::reciprocal_error)};
}

/// Components of the lines along the three axes of a frame, with the tolerances of the tests: see RectangleFrame.
struct FramedLines
{
    Lanes direction[3];
    Lanes middle[3];
    Lanes inverse[3];        ///< reciprocal of the direction
    Lanes slack[3];          ///< FrameRectangle::slack for rectangles across axis k
    Lanes distance_slack[3]; ///< FrameRectangle::distance_slack for rectangles across axis k
    Lanes reach[3];          ///< half length plus distance_slack
};

/// Transforms the lines into a frame.
KERNEL_CODE FramedLines in_frame(const RectangleFrame& frame, const LinePacket& lines)
{
    const Lanes least = Lanes::all(FrameRectangle::least_approach) * lines.scale;
    const Lanes slack = Lanes::all(FrameRectangle::slack(Lanes::reciprocal_error)) * lines.scale;
    const Lanes distance_slack = Lanes::all(FrameRectangle::distance_slack(Lanes::reciprocal_error));
    FramedLines framed;
    for (unsigned k = 0; k < 3; ++k) {
        const LaneVector axis = spread(frame.axis[k]);
        const Lanes d = dot(axis, lines.direction);
        const Lanes m = dot(axis, lines.middle);
        const Lanes size = reciprocal(larger(absolute(d), least));
        framed.direction[k] = d;
        framed.middle[k] = m;
        framed.inverse[k] = with_sign_of(d, size);
        framed.slack[k] = slack * size;
        framed.distance_slack[k] = distance_slack * size;
        framed.reach[k] = lines.half_length + framed.distance_slack[k];
    }
    return framed;
}

/// The tests of RectangleFrame for a rectangle across axis k.
template <unsigned k>
KERNEL_CODE SurfaceTest test_rectangle(const FrameRectangle& rectangle, const FramedLines& lines)
{
    constexpr unsigned i = (k + 1) % 3;
    constexpr unsigned j = (k + 2) % 3;
    const Lanes t = (Lanes::all(rectangle.offset) - lines.middle[k]) * lines.inverse[k];
    const Lanes u = multiply_add(t, lines.direction[i], lines.middle[i] - Lanes::all(rectangle.centre_u));
    const Lanes v = multiply_add(t, lines.direction[j], lines.middle[j] - Lanes::all(rectangle.centre_v));
    LaneMask met = not_above(
        larger(absolute(u) - Lanes::all(rectangle.half_u), absolute(v) - Lanes::all(rectangle.half_v)), lines.slack[k]);
    met = not_above(met, absolute(t), lines.reach[k]);
    return {met, t - lines.distance_slack[k]};
}

/// Calls visit.surface(s, test) for the rectangles across axis k of a frame, which begin at number s. Returns the
/// number of the first rectangle across the next axis.
template <unsigned k, class Visit>
KERNEL_CODE unsigned test_across(const FlatSurfaces& surfaces, const RectangleFrame& frame, unsigned s,
                                 const FramedLines& lines, Visit& visit)
{
    const unsigned end = surfaces.others + frame.end[k];
    for (; s < end; ++s)
        visit.surface(s, test_rectangle<k>(surfaces.rectangles[s - surfaces.others], lines));
    return s;
}

/// Calls visit.surface(s, test) for all surfaces in the order of their numbers.
template <class Visit>
KERNEL_CODE void test_all(const FlatSurfaces& surfaces, const LinePacket& lines, Visit& visit)
{
    unsigned s = 0;
    for (; s < surfaces.others; ++s)
        visit.surface(s, test_surface(surfaces.blocks[s / 16], s % 16, lines));
    for (unsigned f = 0; f < surfaces.frame_count; ++f) {
        const RectangleFrame& frame = surfaces.frames[f];
        const FramedLines framed = in_frame(frame, lines);
        s = test_across<0>(surfaces, frame, s, framed, visit);
        s = test_across<1>(surfaces, frame, s, framed, visit);
        s = test_across<2>(surfaces, frame, s, framed, visit);
    }
}

/// Visitor that sets, for each line, the bits of the surfaces that the line may meet, 32 surfaces to a word.
struct Marking
{
    FlatMarks& marks;
    std::size_t first_line;
    LaneMarks found = {};

    KERNEL_CODE void surface(unsigned s, const SurfaceTest& test)
    {
        found.mark(test.met, 1u << s % 32);
        if (s % 32 == 31)
            store(s);
    }
    KERNEL_CODE void store(unsigned s)
    {
        found.store(marks.word[s / 32] + first_line);
        found = {};
    }
};

KERNEL_ENTRY void filter_flat(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count,
                              FlatMarks& marks)
{
    for (std::size_t first = 0; first < count; first += Lanes::width) {
        const LinePacket lines = load_packet(batch, first);
        Marking marking{marks, first};
        test_all(surfaces, lines, marking);
        if (surfaces.count % 32 != 0)
            marking.store(surfaces.count - 1);
    }
}

/// Visitor that keeps, for each line, the number of the surface with the smallest lower bound of t, this bound and the
/// second smallest one.
struct NearestTwo
{
    const FlatSurfaces& surfaces;
    Lanes excluded; ///< for each line, plane number of the surfaces to ignore
    Lanes first = Lanes::all(FlatSurfaces::never);
    Lanes second = Lanes::all(FlatSurfaces::never);
    Lanes number = Lanes::all(0.0f);

    // A branch pays only for narrow packets, which mostly miss; whether one of many lines hits is hard to predict.
    KERNEL_CODE void surface(unsigned s, const SurfaceTest& test)
    {
        if (Lanes::width <= 4 && bits(test.met) == 0)
            return;
        const LaneMask met = different(test.met, excluded, Lanes::all(surfaces.plane[s]));
        const Lanes t = where(met, test.earliest, Lanes::all(FlatSurfaces::never));
        const LaneMask later = not_above(first, t);
        second = smaller(second, larger(first, t));
        number = where(later, number, Lanes::all(static_cast<float>(s)));
        first = smaller(first, t);
    }
};

KERNEL_ENTRY void nearest_flat(const FlatSurfaces& surfaces, const LineBatch& batch, std::size_t count,
                               const float* excluded_planes, NearestCandidates& found)
{
    for (std::size_t first = 0; first < count; first += Lanes::width) {
        NearestTwo nearest{surfaces, Lanes::load(excluded_planes + first)};
        test_all(surfaces, load_packet(batch, first), nearest);
        nearest.first.store(found.first + first);
        nearest.second.store(found.second + first);
        nearest.number.store(found.number + first);
    }
}

} // namespace
} // namespace LANE_SET
} // namespace multipath
