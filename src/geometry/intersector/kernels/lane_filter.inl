// Test of a surface and a line in each lane. Searches in the hierarchy have the surfaces of a block in the lanes and
// the same line in all of them; filters of small scenes have it the other way round. Included once for each instruction
// set (see parallel/lanes/every_set.inl).

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

/// The vectors from `first` on of a structure of arrays.
template <std::size_t count>
KERNEL_CODE LaneVector load_columns(const float (&v)[3][count], std::size_t first)
{
    return {Lanes::load(v[0] + first), Lanes::load(v[1] + first), Lanes::load(v[2] + first)};
}

/// Vector `i` of a structure of arrays, in all lanes.
template <std::size_t count>
KERNEL_CODE LaneVector spread_column(const float (&v)[3][count], std::size_t i)
{
    return {Lanes::all(v[0][i]), Lanes::all(v[1][i]), Lanes::all(v[2][i])};
}

KERNEL_CODE Lanes dot(const LaneVector& a, const LaneVector& b)
{
    return multiply_add(a.z, b.z, multiply_add(a.y, b.y, a.x * b.x));
}

KERNEL_CODE LaneVector cross(const LaneVector& a, const LaneVector& b)
{
    return {less_product(a.y * b.z, a.z, b.y), less_product(a.z * b.x, a.x, b.z), less_product(a.x * b.y, a.y, b.x)};
}

/// A surface of a SurfaceBlock in each lane.
struct LaneSurface
{
    LaneVector corner, edge_u, edge_v;
    Lanes slack;
};

/// What SurfaceBlock compares, all of it multiplied by the sign of a.
struct PlaneCrossing
{
    Lanes a, u, v, t;
    Lanes sum;            ///< u + v for a triangle, else u
    Lanes slack;          ///< of u, v and sum
    Lanes distance_slack; ///< of t

    /// The lines that may pass through their surfaces between `first` and `last`.
    KERNEL_CODE LaneMask may_meet(Lanes first, Lanes last) const
    {
        const Lanes most = a + slack;
        LaneMask met = not_above(Lanes::all(0.0f) - slack, smaller(u, v));
        met = not_above(met, larger(u, v), most);
        met = not_above(met, sum, most);
        met = not_above(met, t, multiply_add(a, last, distance_slack));
        return not_above(met, a * first - distance_slack, t);
    }

    /// The lines that certainly do, farther from `first` than any surface in a plane around it.
    KERNEL_CODE LaneMask certainly_meets(Lanes first, Lanes last) const
    {
        const Lanes least = a - slack;
        LaneMask certain = not_above(slack, smaller(u, v));
        certain = not_above(certain, larger(u, v), least);
        certain = not_above(certain, sum, least);
        certain = not_above(certain, t, a * last - distance_slack);
        return not_above(certain, a * first + distance_slack * Lanes::all(SurfaceBlock::beyond_own_plane), t);
    }
};

/// The terms for lines with this `middle` and `direction`; `scale`: LineBatch::scale.
KERNEL_CODE PlaneCrossing cross_plane(const LaneSurface& surface, const LaneVector& middle, const LaneVector& direction,
                                      Lanes scale)
{
    const Lanes zero = Lanes::all(0.0f);
    const LaneVector& corner = surface.corner;
    const LaneVector to_corner = {corner.x - middle.x, corner.y - middle.y, corner.z - middle.z};
    const LaneVector normal = cross(surface.edge_u, surface.edge_v);
    const LaneVector across = cross(to_corner, direction);
    const Lanes a = dot(normal, direction);
    const Lanes u = with_sign_of(a, dot(across, surface.edge_v));
    const Lanes v = with_sign_of(a, zero - dot(across, surface.edge_u));
    const Lanes t = with_sign_of(a, dot(normal, to_corner));
    const Lanes distance_slack = absolute(surface.slack);
    return {absolute(a),          u, v, t, where(not_above(surface.slack, zero), u + v, u), distance_slack * scale,
            distance_slack};
}

} // namespace
} // namespace LANE_SET
} // namespace multipath
