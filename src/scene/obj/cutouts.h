#pragma once

#include "scene/obj/mesh_pieces.h"
#include "scene/obj/mtl_reader.h"
#include "scene/obj/obj_textures.h"

#include <string>
#include <vector>

namespace multipath {

/// Cuts the transparent parts out of the pieces: pixels of `map_d`, or else of `map_Kd`, whose opacity is below one
/// half. Triangles and parallelograms over the opaque pixels replace a piece; an entirely opaque one stays as it is,
/// and so does one without texture coordinates; an entirely transparent one is left out. If a material would get more
/// than 32,768 new pieces, its mask is made coarser: a larger pixel is opaque if at least half of its pixels are.
///
/// `definitions` has one entry per material of the mesh, to which vertices and texture points are added. Returns
/// messages that name the materials.
std::vector<std::string> cut_out(const std::vector<MtlMaterial>& definitions, const SceneScale& scale,
                                 TextureFiles& textures, ObjMesh& mesh, LargeVector<Piece>& pieces);

} // namespace multipath
