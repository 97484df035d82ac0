// Included once by the file of each instruction set that has no way of its own, after KERNEL_CODE.

namespace multipath {
namespace {

KERNEL_CODE bool decide(const SurfaceTable& table, const Line& line, std::uint32_t surface, Hit& hit)
{
    return table.decide(line, surface, hit);
}

} // namespace
} // namespace multipath
