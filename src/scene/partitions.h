#pragma once

#include "scene/scene_file.h"

#include <cstddef>

namespace multipath {

struct PartitionCuts
{
    std::size_t surfaces = 0; ///< number of surfaces that were cut
    std::size_t pieces = 0;   ///< number of surfaces that took their place
    bool complete = true; ///< false if the search was cut short or surfaces were left whole, see cut_at_partitions()
};

/// Cuts surfaces along the lines on which partitions (opaque surfaces that rise from them) stand or pass through them,
/// so that no patch lies on both sides of one: radiosity differs there. The pieces, parallelograms where possible and
/// else triangles, take the place of their surface in the file and keep its material, names, line and texture. To be
/// called before add_sky(). D is the diagonal of the scene. A surface, or part of one, is cut from border to border
/// along a line
/// - of which partitions cover at least D/20, and two fifths of the length that the part has along it, since light goes
///   round what is shorter, such as a cube;
/// - above which they rise by more than D/100 on the front of the surface (if `two_sided`, on either side), and to
/// which
///   they come closer than D/10,000;
/// - on both of whose sides the part is wider than D/500.
/// The largest surfaces come first: if more than 2^26 box tests were necessary, the others are not searched. None is
/// cut into more than 256 convex parts, or if there would be more than an eighth and 1024 surfaces more than before.
PartitionCuts cut_at_partitions(SceneFile& file, bool two_sided);

} // namespace multipath
