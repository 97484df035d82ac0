// One number at a time in plain C++, for any processor; what the functions of lanes do is said here.

namespace multipath {
namespace LANE_SET {
namespace {

/// Single precision numbers side by side. Multiplies may be fused with adds where a function says so.
struct Lanes
{
    static constexpr unsigned width = 1;
    static constexpr float reciprocal_error = 0x1p-23f;
    float x;

    static Lanes load(const float* from) { return {*from}; } ///< aligned to the size of all lanes, as in store()
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
/// a b + c, rounded once or twice.
KERNEL_CODE Lanes multiply_add(Lanes a, Lanes b, Lanes c)
{
    return {a.x * b.x + c.x};
}
/// c - a b, rounded once or twice.
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
/// -a where the sign is negative.
KERNEL_CODE Lanes with_sign_of(Lanes sign, Lanes a)
{
    return {sign.x < 0.0f ? -a.x : a.x};
}
KERNEL_CODE Lanes quotient(Lanes a, Lanes b)
{
    return {a.x / b.x};
}
/// About 1 / a, for 1e-30 <= a <= 1e30, wrong by no more than the share Lanes::reciprocal_error.
KERNEL_CODE Lanes reciprocal(Lanes a)
{
    return {1.0f / a.x};
}

/// A truth in each lane.
struct LaneMask
{
    bool x;
};

KERNEL_CODE LaneMask not_above(Lanes a, Lanes b)
{
    return {a.x <= b.x};
}
/// What `so_far` says, and a <= b.
KERNEL_CODE LaneMask not_above(LaneMask so_far, Lanes a, Lanes b)
{
    return {(static_cast<unsigned>(so_far.x) & static_cast<unsigned>(a.x <= b.x)) != 0};
}
/// What `so_far` says, and a != b.
KERNEL_CODE LaneMask different(LaneMask so_far, Lanes a, Lanes b)
{
    return {(static_cast<unsigned>(so_far.x) & static_cast<unsigned>(a.x != b.x)) != 0};
}
KERNEL_CODE Lanes where(LaneMask mask, Lanes yes, Lanes no)
{
    return mask.x ? yes : no;
}
/// Bit i: what is true in lane i.
KERNEL_CODE unsigned bits(LaneMask mask)
{
    return mask.x ? 1u : 0u;
}

/// 32 marks in each lane.
struct LaneMarks
{
    std::uint32_t x = 0;

    /// Sets a mark (one bit) where the mask says so.
    void mark(LaneMask mask, std::uint32_t bit) { x |= mask.x ? bit : 0u; }
    void store(std::uint32_t* to) const { *to = x; }
};

/// Double precision numbers side by side. No multiply is fused with an add, which would round differently.
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
KERNEL_CODE DoubleLanes operator-(DoubleLanes a, DoubleLanes b)
{
    return {a.x - b.x};
}
KERNEL_CODE DoubleLanes operator*(DoubleLanes a, DoubleLanes b)
{
    return {a.x * b.x};
}
KERNEL_CODE DoubleLanes square_root(DoubleLanes a)
{
    return {std::sqrt(a.x)};
}
/// a < b ? yes : no
KERNEL_CODE DoubleLanes choose_less(DoubleLanes a, DoubleLanes b, DoubleLanes yes, DoubleLanes no)
{
    return a.x < b.x ? yes : no;
}
KERNEL_CODE std::uint64_t bits_of(DoubleLanes a)
{
    std::uint64_t bits = 0;
    std::memcpy(&bits, &a.x, sizeof bits);
    return bits;
}
/// -0 where this bit of the number's representation is set, else 0.
template <int bit>
KERNEL_CODE DoubleLanes sign_from_bit(DoubleLanes a)
{
    return {(bits_of(a) >> bit & 1) != 0 ? -0.0 : 0.0};
}
/// yes where the sign is negative, also that of -0.
KERNEL_CODE DoubleLanes choose_by_sign(DoubleLanes sign, DoubleLanes yes, DoubleLanes no)
{
    return std::signbit(sign.x) ? yes : no;
}
/// -a where the sign is negative.
KERNEL_CODE DoubleLanes with_sign(DoubleLanes sign, DoubleLanes a)
{
    return {std::signbit(sign.x) ? -a.x : a.x};
}

} // namespace
} // namespace LANE_SET
} // namespace multipath
