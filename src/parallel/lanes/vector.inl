// Lane types of LANE_BYTES, with the vector extensions of GCC and clang. plain.inl documents the functions. Intrinsics
// are used only for operations that the extensions lack or that compilers translate into better code.

namespace multipath {
namespace LANE_SET {
namespace {

typedef float FloatVector __attribute__((vector_size(LANE_BYTES)));
typedef float HalfFloatVector __attribute__((vector_size(LANE_BYTES / 2)));
typedef double DoubleVector __attribute__((vector_size(LANE_BYTES)));
typedef std::int32_t IntVector __attribute__((vector_size(LANE_BYTES)));

/// Reinterprets the bits as another type.
template <class To, class From>
KERNEL_CODE To bits_as(From from)
{
    static_assert(sizeof(To) == sizeof(From), "as many bits");
    return reinterpret_cast<To>(from);
}

struct Lanes
{
    static constexpr unsigned width = LANE_BYTES / sizeof(float);
#if defined(__x86_64__)
    static constexpr float reciprocal_error = LANE_BYTES == 64 ? 0x1p-14f : 0x1.8p-12f;
#else
    static constexpr float reciprocal_error = 0x1p-23f;
#endif
    FloatVector x;

    KERNEL_CODE static Lanes load(const float* from)
    {
        Lanes lanes;
        std::memcpy(&lanes.x, __builtin_assume_aligned(from, LANE_BYTES), LANE_BYTES);
        return lanes;
    }
    KERNEL_CODE static Lanes all(float value)
    {
        return {value - FloatVector{}};
    }
    KERNEL_CODE void store(float* to) const
    {
        std::memcpy(__builtin_assume_aligned(to, LANE_BYTES), &x, LANE_BYTES);
    }
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
KERNEL_CODE Lanes multiply_add(Lanes a, Lanes b, Lanes c)
{
#if LANE_BYTES == 32
    return {_mm256_fmadd_ps(a.x, b.x, c.x)};
#elif LANE_BYTES == 64
    return {_mm512_fmadd_ps(a.x, b.x, c.x)};
#elif defined(__aarch64__)
    return {vfmaq_f32(c.x, a.x, b.x)};
#else
    return {a.x * b.x + c.x};
#endif
}
KERNEL_CODE Lanes less_product(Lanes c, Lanes a, Lanes b)
{
#if LANE_BYTES == 32
    return {_mm256_fnmadd_ps(a.x, b.x, c.x)};
#elif LANE_BYTES == 64
    return {_mm512_fnmadd_ps(a.x, b.x, c.x)};
#elif defined(__aarch64__)
    return {vfmsq_f32(c.x, a.x, b.x)};
#else
    return {c.x - a.x * b.x};
#endif
}
KERNEL_CODE Lanes absolute(Lanes a)
{
    return {bits_as<FloatVector>(bits_as<IntVector>(a.x) & 0x7fffffff)};
}
KERNEL_CODE Lanes larger(Lanes a, Lanes b)
{
#if LANE_BYTES == 64 // for absolute values g++ 12 generates a comparison and a blend otherwise
    return {_mm512_maskz_max_ps(0xffff, a.x, b.x)};
#else
    return {a.x > b.x ? a.x : b.x};
#endif
}
KERNEL_CODE Lanes smaller(Lanes a, Lanes b)
{
    return {a.x < b.x ? a.x : b.x};
}
KERNEL_CODE Lanes with_sign_of(Lanes sign, Lanes a)
{
    const IntVector minus = bits_as<IntVector>(sign.x) & (-0x7fffffff - 1);
    return {bits_as<FloatVector>(bits_as<IntVector>(a.x) ^ minus)};
}
KERNEL_CODE Lanes quotient(Lanes a, Lanes b)
{
    return {a.x / b.x};
}
KERNEL_CODE Lanes reciprocal(Lanes a)
{
#if !defined(__x86_64__)
    return {1.0f / a.x};
#elif LANE_BYTES == 16
    return {_mm_rcp_ps(a.x)};
#elif LANE_BYTES == 32
    return {_mm256_rcp_ps(a.x)};
#else
    return {_mm512_maskz_rcp14_ps(0xffff, a.x)};
#endif
}

#if LANE_BYTES == 64 // mask registers; a vector of truth values would only be converted from them

struct LaneMask
{
    __mmask16 x;
};

KERNEL_CODE LaneMask not_above(Lanes a, Lanes b)
{
    return {_mm512_cmp_ps_mask(a.x, b.x, _CMP_LE_OQ)};
}
KERNEL_CODE LaneMask not_above(LaneMask so_far, Lanes a, Lanes b)
{
    return {_mm512_mask_cmp_ps_mask(so_far.x, a.x, b.x, _CMP_LE_OQ)};
}
KERNEL_CODE LaneMask different(LaneMask so_far, Lanes a, Lanes b)
{
    return {_mm512_mask_cmp_ps_mask(so_far.x, a.x, b.x, _CMP_NEQ_OQ)};
}
KERNEL_CODE LaneMask different(LaneMask so_far, const std::uint32_t* numbers, std::uint32_t other)
{
    return {_mm512_mask_cmpneq_epi32_mask(so_far.x, _mm512_load_si512(numbers),
                                          _mm512_set1_epi32(static_cast<int>(other)))};
}
KERNEL_CODE Lanes where(LaneMask mask, Lanes yes, Lanes no)
{
    return {_mm512_mask_mov_ps(no.x, mask.x, yes.x)};
}
KERNEL_CODE unsigned bits(LaneMask mask)
{
    return mask.x;
}
/// `bit` where the mask is true, else 0.
KERNEL_CODE IntVector where(LaneMask mask, std::uint32_t bit)
{
    return bits_as<IntVector>(_mm512_maskz_set1_epi32(mask.x, static_cast<int>(bit)));
}

#else

/// -1 in true lanes, else 0.
struct LaneMask
{
    IntVector x;
};

KERNEL_CODE LaneMask not_above(Lanes a, Lanes b)
{
    return {a.x <= b.x};
}
KERNEL_CODE LaneMask not_above(LaneMask so_far, Lanes a, Lanes b)
{
    return {so_far.x & (a.x <= b.x)};
}
KERNEL_CODE LaneMask different(LaneMask so_far, Lanes a, Lanes b)
{
    return {so_far.x & (a.x != b.x)};
}
KERNEL_CODE LaneMask different(LaneMask so_far, const std::uint32_t* numbers, std::uint32_t other)
{
    IntVector all;
    std::memcpy(&all, __builtin_assume_aligned(numbers, LANE_BYTES), LANE_BYTES);
    return {so_far.x & (all != static_cast<std::int32_t>(other))};
}
KERNEL_CODE Lanes where(LaneMask mask, Lanes yes, Lanes no)
{
    return {mask.x ? yes.x : no.x};
}
KERNEL_CODE unsigned bits(LaneMask mask)
{
#if defined(__x86_64__) && LANE_BYTES == 16
    return static_cast<unsigned>(_mm_movemask_ps(bits_as<FloatVector>(mask.x)));
#elif defined(__x86_64__) && LANE_BYTES == 32
    return static_cast<unsigned>(_mm256_movemask_ps(bits_as<FloatVector>(mask.x)));
#elif defined(__wasm_simd128__)
    return wasm_i32x4_bitmask(bits_as<v128_t>(mask.x));
#else
    constexpr IntVector bit_of_lane = {1, 2, 4, 8};
    const IntVector found = mask.x & bit_of_lane;
    return static_cast<unsigned>((found[0] | found[1]) | (found[2] | found[3]));
#endif
}

KERNEL_CODE IntVector where(LaneMask mask, std::uint32_t bit)
{
    return mask.x & static_cast<std::int32_t>(bit);
}

#endif

struct LaneMarks
{
    IntVector x;

    KERNEL_CODE LaneMarks() : x{} {}
    KERNEL_CODE void mark(LaneMask mask, std::uint32_t bit) { x |= where(mask, bit); }
    KERNEL_CODE void store(std::uint32_t* to) const
    {
        std::memcpy(__builtin_assume_aligned(to, LANE_BYTES), &x, LANE_BYTES);
    }
};

struct DoubleLanes
{
    static constexpr std::size_t width = LANE_BYTES / sizeof(double);
    DoubleVector x;

    KERNEL_CODE static DoubleLanes load(const double* from)
    {
        DoubleLanes lanes;
        std::memcpy(&lanes.x, from, LANE_BYTES);
        return lanes;
    }
    KERNEL_CODE static DoubleLanes load_floats(const float* from)
    {
        HalfFloatVector floats;
        std::memcpy(&floats, from, LANE_BYTES / 2);
        return {__builtin_convertvector(floats, DoubleVector)};
    }
    KERNEL_CODE static DoubleLanes all(double value) { return {value - DoubleVector{}}; }
    KERNEL_CODE void store(double* to) const { std::memcpy(to, &x, LANE_BYTES); }
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
