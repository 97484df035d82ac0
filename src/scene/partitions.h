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
/// else triangles, take the place of their surface in the file and keep its material, names, line and texture. A line
/// cuts only the pieces that its contacts reach, but those from border to border. To be called before add_sky(). D is
/// the diagonal of the scene. A line below partitions counts if
/// - its longest gapless contact is at least D/20 long, though several surfaces may contribute to it;
/// - the partition rises by more than D/1000 above the front of the surface (if `two_sided`, above either side), and
///   comes closer to it than D/10,000;
/// - it is not one side of a solid as wide as a quarter of the contact or wider: light goes round the foot of a cube
///   or cupboard;
/// - on both of its sides the surface is wider than D/500.
/// Of the two sides of a slim solid only one counts, and none if the solid covers the surface up to its border.
/// Surfaces smaller than D/64 across are not searched. The largest come first: if 2^26 box tests do not suffice for
/// all, the others are left whole, each is searched for its 1024 longest contacts, and none is cut into more than 256
/// convex parts, or if there would be more than an eighth and 1024 surfaces more than before.
PartitionCuts cut_at_partitions(SceneFile& file, bool two_sided);

} // namespace multipath
