// The phases before and after the filters, in double precision: lines are placed, and candidates decided. They are
// plain loops that the compiler vectorises for the instruction set. decide() does what SurfaceTable::decide does; where
// vectors hold four doubles, it evaluates the columns of a row as vectors, with the same operations in the same order.
// So the results are the same bit for bit. Included once for each instruction set.

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

/// Lines as a structure of arrays.
struct LineColumns
{
    static constexpr std::size_t most = 16; ///< so few that they stay in the first-level cache

    alignas(64) double origin[3][most];
    double direction[3][most];
    double t_max[most];

    Line line(std::size_t i) const
    {
        return {
            {origin[0][i], origin[1][i], origin[2][i]}, {direction[0][i], direction[1][i], direction[2][i]}, t_max[i]};
    }
};

KERNEL_CODE void to_columns(const Line* lines, std::size_t count, LineColumns& columns)
{
    for (std::size_t i = 0; i < count; ++i) {
        __builtin_prefetch(lines + i + 128);
        columns.origin[0][i] = lines[i].origin.x;
        columns.origin[1][i] = lines[i].origin.y;
        columns.origin[2][i] = lines[i].origin.z;
        columns.direction[0][i] = lines[i].direction.x;
        columns.direction[1][i] = lines[i].direction.y;
        columns.direction[2][i] = lines[i].direction.z;
        columns.t_max[i] = lines[i].t_max;
    }
}

/// FilterFrame::place for all columns, even unused ones: a loop of constant length needs no remainder loop.
KERNEL_CODE void place_columns(const FilterFrame& frame, const LineColumns& lines, std::size_t first, LineBatch& batch)
{
    for (std::size_t k = 0; k < LineColumns::most; ++k)
        frame.place(lines.line(k), first + k, batch);
}

KERNEL_ENTRY void place_lines(const FilterFrame& frame, const Line* lines, std::size_t count, LineBatch& batch)
{
    const FilterFrame local = frame; // a copy that cannot alias the output, which helps the vectoriser
    LineColumns columns{};
    for (std::size_t first = 0; first < count; first += LineColumns::most) {
        to_columns(lines + first, count - first < LineColumns::most ? count - first : LineColumns::most, columns);
        place_columns(local, columns, first, batch);
    }
}

/// SurfaceTable::decide for every candidate, in order.
KERNEL_ENTRY std::size_t decide_candidates(const SurfaceTable& table, const Line* lines,
                                           const LineCandidate* candidates, std::size_t count, Hit* hits,
                                           std::size_t* end_of_line)
{
    std::size_t end = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const LineCandidate candidate = candidates[i];
        end += decide(table, lines[candidate.line], candidate.surface, hits[end]);
        end_of_line[candidate.line] = end;
    }
    return end;
}

/// SurfaceTable::decide for one surface of each line.
KERNEL_ENTRY void decide_nearest(const SurfaceTable& table, const Line* lines, const std::uint32_t* surfaces,
                                 std::size_t count, Hit* hits, std::uint32_t* is_hit)
{
    for (std::size_t i = 0; i < count; ++i)
        is_hit[i] = decide(table, lines[i], surfaces[i], hits[i]);
}

} // namespace
} // namespace LANE_SET
} // namespace multipath
