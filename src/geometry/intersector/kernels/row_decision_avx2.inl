// SurfaceTable::decide by AVX2: the four numbers of a row's columns side by side, the same operations in the same order.
// Included once by the file of each instruction set that has it, after KERNEL_CODE, all static.

namespace multipath {
namespace {

KERNEL_CODE __m256d all_four(double value)
{
    return _mm256_set1_pd(value);
}

KERNEL_CODE __m256d times_columns(const SurfaceRow& row, Vec3 v)
{
    const __m256d x = _mm256_mul_pd(_mm256_load_pd(row.x.data()), all_four(v.x));
    const __m256d y = _mm256_mul_pd(_mm256_load_pd(row.y.data()), all_four(v.y));
    const __m256d z = _mm256_mul_pd(_mm256_load_pd(row.z.data()), all_four(v.z));
    return _mm256_add_pd(_mm256_add_pd(x, y), z);
}

KERNEL_CODE bool decide(const SurfaceTable& table, const Line& line, std::uint32_t surface, Hit& hit)
{
    const SurfaceRow& row = table.row(surface);
    const __m256d at_origin = times_columns(row, line.origin);
    const __m256d along = times_columns(row, line.direction);
    const double approach = _mm256_cvtsd_f64(along);
    const double t = (row.offset[0] - _mm256_cvtsd_f64(at_origin)) / approach;
    const __m256d places = _mm256_add_pd(_mm256_add_pd(at_origin, _mm256_load_pd(row.offset.data())),
                                         _mm256_mul_pd(all_four(t), along)); // second and third: u and v
    const __m256d uvuv = _mm256_permute4x64_pd(places, 0x99);
    const __m256d vuvu = _mm256_permute4x64_pd(places, 0x66);
    const __m256d rest =
        _mm256_sub_pd(_mm256_sub_pd(all_four(1.0), uvuv), _mm256_mul_pd(all_four(row.offset[3]), vuvu));
    const __m256d borders = _mm256_blend_pd(uvuv, rest, 0xc);
    const bool inside = _mm256_movemask_pd(_mm256_cmp_pd(borders, _mm256_setzero_pd(), _CMP_GE_OQ)) == 0xf;
    hit.t = t;
    hit.surface = surface;
    hit.u = _mm256_cvtsd_f64(uvuv);
    hit.v = _mm256_cvtsd_f64(vuvu);
    hit.front = approach < 0.0;
    return every(approach != 0.0, t >= 0.0, t <= line.t_max, inside);
}

} // namespace
} // namespace multipath
