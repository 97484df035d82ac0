#pragma once

#include "geometry/surface.h"
#include "scene/scene_file.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace multipath {

/// Surfaces on which partitions (opaque surfaces that rise from them) stand or pass through them. Radiosity differs on
/// the two sides of a partition, so a patch that reaches across the line below it carries light from one side to the
/// other.
struct PartitionedSurfaces
{
    std::vector<std::uint32_t> surfaces; ///< indices, the largest surface first
    bool complete = true;                ///< false if the search was cut short, see find_partitioned_surfaces()
};

/// Finds the surfaces that partitions divide into two parts. D is the diagonal of the scene. A line below partitions
/// counts if
/// - its longest gapless contact is at least D/20 long, though several surfaces may contribute to it;
/// - the partition rises by more than D/1000 above the front of the surface (if `two_sided`, above either side), and
///   comes closer to it than D/10,000;
/// - it is not one side of a solid as wide as a quarter of the contact or wider: light goes round the foot of a cube
///   or cupboard;
/// - on both of its sides the surface is wider than D/500.
/// Of the two sides of a slim solid only one counts, and none if the solid covers the surface up to its border.
/// Surfaces smaller than D/64 across are not searched. The time is bounded: if the number of surfaces is so large that
/// 2^26 box tests do not suffice for all, only the largest surfaces are searched, and each for its 1024 longest
/// contacts.
PartitionedSurfaces find_partitioned_surfaces(const SurfaceList& surfaces, bool two_sided);

struct PartitionCuts
{
    std::size_t surfaces = 0; ///< number of surfaces that were cut
    std::size_t pieces = 0;   ///< number of surfaces that took their place
};

/// Cuts surfaces along the lines below partitions, so that no patch lies on both sides of one. The pieces,
/// parallelograms where possible and else triangles, take the place of their surface in the file and keep its material,
/// names, line and texture. A line cuts only the pieces that its contacts reach, but those from border to border. To be
/// called before add_sky(). The largest surfaces come first: none is cut into more than 256 convex parts, or if there
/// would be more than an eighth and 1024 surfaces more than before.
PartitionCuts cut_at_partitions(SceneFile& file, bool two_sided);

} // namespace multipath
