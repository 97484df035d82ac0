// Lane types with a single lane, in plain C++ for any processor. Their functions are documented here for all lane
// types.

namespace multipath {
namespace LANE_SET {
namespace {

/// Vector of single-precision numbers. Only functions that say so may fuse a multiplication with an addition.
struct Lanes
{
    static constexpr unsigned width = 1;
    static constexpr float reciprocal_error = 0x1p-23f; ///< relative error of reciprocal()
    float x;

    /// Addresses in load() and store() must be aligned to the size of the vector.
    static Lanes load(const float* from) { return {*from}; }
    /// The same value in every lane.
    static Lanes all(float value) { return {value}; }
    void store(float* to) const { *to = x; }
};

KERNEL_CODE Lanes operator+(Lanes a, Lanes b)
{
    return {a.x + b.x};
}
KERNEL_CODE Lanes operator-(Lanes a, Lanes b)
{
    return {a.x - b.x};
}
KERNEL_CODE Lanes operator*(Lanes a, Lanes b)
{
    return {a.x * b.x};
}
/// a b + c, with one rounding or two.
KERNEL_CODE Lanes multiply_add(Lanes a, Lanes b, Lanes c)
{
    return {a.x * b.x + c.x};
}
/// c - a b, with one rounding or two.
KERNEL_CODE Lanes less_product(Lanes c, Lanes a, Lanes b)
{
    return {c.x - a.x * b.x};
}
KERNEL_CODE Lanes absolute(Lanes a)
{
    return {std::abs(a.x)};
}
KERNEL_CODE Lanes larger(Lanes a, Lanes b)
{
    return {a.x > b.x ? a.x : b.x};
}
KERNEL_CODE Lanes smaller(Lanes a, Lanes b)
{
    return {a.x < b.x ? a.x : b.x};
}
/// -a where the sign bit of `sign` is set, else a.
KERNEL_CODE Lanes with_sign_of(Lanes sign, Lanes a)
{
    return {std::signbit(sign.x) ? -a.x : a.x};
}
KERNEL_CODE Lanes quotient(Lanes a, Lanes b)
{
    return {a.x / b.x};
}
/// Approximation of 1 / a, with a relative error of at most Lanes::reciprocal_error for 1e-30 <= a <= 1e30.
KERNEL_CODE Lanes reciprocal(Lanes a)
{
    return {1.0f / a.x};
}

/// Truth value of each lane.
struct LaneMask
{
    bool x;
};

/// a <= b, false for NaN.
KERNEL_CODE LaneMask not_above(Lanes a, Lanes b)
{
    return {a.x <= b.x};
}
/// so_far && a <= b, false for NaN.
KERNEL_CODE LaneMask not_above(LaneMask so_far, Lanes a, Lanes b)
{
    return {(static_cast<unsigned>(so_far.x) & static_cast<unsigned>(a.x <= b.x)) != 0};
}
/// so_far && a != b
KERNEL_CODE LaneMask different(LaneMask so_far, Lanes a, Lanes b)
{
    return {(static_cast<unsigned>(so_far.x) & static_cast<unsigned>(a.x != b.x)) != 0};
}
/// so_far && number != other, for the numbers at `numbers`, an address as in load().
KERNEL_CODE LaneMask different(LaneMask so_far, const std::uint32_t* numbers, std::uint32_t other)
{
    return {(static_cast<unsigned>(so_far.x) & static_cast<unsigned>(*numbers != other)) != 0};
}
/// mask ? yes : no
KERNEL_CODE Lanes where(LaneMask mask, Lanes yes, Lanes no)
{
    return mask.x ? yes : no;
}
/// Bit i is set if lane i is true.
KERNEL_CODE unsigned bits(LaneMask mask)
{
    return mask.x ? 1u : 0u;
}

/// 32 bits in each lane.
struct LaneMarks
{
    std::uint32_t x = 0;

    /// Sets `bit` in the lanes where the mask is true.
    void mark(LaneMask mask, std::uint32_t bit) { x |= mask.x ? bit : 0u; }
    void store(std::uint32_t* to) const { *to = x; } ///< the address must be aligned to the size of the vector
};

/// Vector of double-precision numbers. Multiplications are never fused with additions, which would round differently.
/// Addresses in load(), load_floats() and store() need no alignment.
struct DoubleLanes
{
    static constexpr std::size_t width = 1;
    double x;

    static DoubleLanes load(const double* from) { return {*from}; }
    static DoubleLanes load_floats(const float* from) { return {static_cast<double>(*from)}; }
    static DoubleLanes all(double value) { return {value}; }
    void store(double* to) const { *to = x; }
};

KERNEL_CODE DoubleLanes operator+(DoubleLanes a, DoubleLanes b)
{
    return {a.x + b.x};
}
KERNEL_CODE DoubleLanes operator*(DoubleLanes a, DoubleLanes b)
{
    return {a.x * b.x};
}

} // namespace
} // namespace LANE_SET
} // namespace multipath
