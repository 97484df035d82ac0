// SurfaceTable::decide for one instruction set. If vectors hold four doubles, the columns of a row are evaluated as
// vectors, with the same operations in the same order, so that the results are the same bit for bit. Included once for
// each instruction set.

namespace multipath {
namespace LANE_SET {
namespace {

#if LANE_BYTES >= 32

typedef double RowVector __attribute__((vector_size(32)));

/// The dot products of v with normal, to_u and to_v.
KERNEL_CODE RowVector times_columns(const SurfaceRow& row, Vec3 v)
{
    RowVector x;
    RowVector y;
    RowVector z;
    std::memcpy(&x, __builtin_assume_aligned(row.x.data(), 32), 32);
    std::memcpy(&y, __builtin_assume_aligned(row.y.data(), 32), 32);
    std::memcpy(&z, __builtin_assume_aligned(row.z.data(), 32), 32);
    return x * v.x + y * v.y + z * v.z;
}

KERNEL_CODE bool decide(const SurfaceTable& table, const Line& line, std::uint32_t surface, Hit& hit)
{
    const SurfaceRow& row = table.row(surface);
    RowVector offset;
    std::memcpy(&offset, __builtin_assume_aligned(row.offset.data(), 32), 32);
    const RowVector at_origin = times_columns(row, line.origin);
    const RowVector along = times_columns(row, line.direction);
    const double approach = along[0];
    const double t = (row.offset[0] - at_origin[0]) / approach;
    const RowVector coordinates = at_origin + offset + t * along; // u and v are the second and third
    const RowVector uvuv = {coordinates[1], coordinates[2], coordinates[1], coordinates[2]};
    const RowVector vuvu = {coordinates[2], coordinates[1], coordinates[2], coordinates[1]};
    const RowVector rest = 1.0 - uvuv - row.offset[3] * vuvu;
    const RowVector borders = {uvuv[0], uvuv[1], rest[2], rest[3]};
    const bool inside = _mm256_movemask_pd(borders >= 0.0) == 0xf;
    hit.t = t;
    hit.surface = surface;
    hit.u = coordinates[1];
    hit.v = coordinates[2];
    hit.front = approach < 0.0;
    return every(approach != 0.0, t >= 0.0, t <= line.t_max, inside);
}

#else

KERNEL_CODE bool decide(const SurfaceTable& table, const Line& line, std::uint32_t surface, Hit& hit)
{
    return table.decide(line, surface, hit);
}

#endif

} // namespace
} // namespace LANE_SET
} // namespace multipath
