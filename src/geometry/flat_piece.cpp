#include "geometry/flat_piece.h"

#include <algorithm>

namespace multipath {

FlatPiece piece_of(const Surface& surface)
{
    const Vec3 u = surface.edge_u;
    const Vec3 v = surface.edge_v;
    FlatPiece piece;
    piece.surface = surface;
    piece.normal = surface.normal();
    piece.centre = surface.centre();
    piece.area = surface.area();
    if (surface.shape == Shape::parallelogram) {
        piece.radius = 0.5 * std::max(length(u + v), length(u - v));
        piece.spread_u = u;
        piece.spread_v = v;
    } else {
        piece.radius = std::max({length(u + v), length(2.0 * u - v), length(2.0 * v - u)}) / 3.0;
        // Covariance (u u^T + v v^T + (u - v)(u - v)^T) / 36, as a sum of two squares.
        piece.spread_u = (1.0 / std::sqrt(6.0)) * (u + v);
        piece.spread_v = (1.0 / std::sqrt(2.0)) * (u - v);
    }
    piece.squared_spread = dot(piece.spread_u, piece.spread_u) + dot(piece.spread_v, piece.spread_v);
    return piece;
}

} // namespace multipath
