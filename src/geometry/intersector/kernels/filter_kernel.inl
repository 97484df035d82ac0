// All parts of a FilterKernel for one instruction set. Included by parallel/lanes/one_set.inl.

#include "geometry/intersector/kernels/lane_filter.inl"

#include "geometry/intersector/kernels/lane_packet.inl"

#include "geometry/intersector/kernels/lane_phases.inl"

#include "geometry/intersector/kernels/lane_tree.inl"

namespace multipath {
namespace LANE_SET {
namespace {

constexpr FilterKernel table = {LANE_SET_NAME,   place_lines,     filter_flat, nearest_flat,
                                fill_tree_lines, find_candidates, find_first,  decide_candidates, decide_nearest};

} // namespace
} // namespace LANE_SET
} // namespace multipath
