// The opaque pixels below a piece are joined to rectangles, greedily: each as wide as possible, then as high. The
// piece, a convex polygon in the plane of the texture, is clipped against each rectangle (Sutherland and Hodgman 1974),
// and the parts are mapped back into space by the affine map between the two. So areas, lines and form factors need to
// know nothing of transparency.

#include "scene/obj/cutouts.h"

#include "base/text_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace multipath {

namespace {

constexpr std::size_t most_new_pieces = std::size_t{1} << 15;
constexpr double most_pixels_visited = 1u << 25; // of all pieces of a material; about a second
constexpr double no_part = 1e-9;                 ///< [1] share of a piece that counts as nothing

/// Which pixels of an image are opaque, row by row from below.
struct Mask
{
    std::int64_t width = 0;
    std::int64_t height = 0;
    bool repeats = true;
    std::vector<char> opaque;
    bool is_uniform = false;

    bool at(std::int64_t x, std::int64_t y) const
    {
        const auto within = [&](std::int64_t i, std::int64_t n) {
            return repeats ? ((i % n) + n) % n : std::clamp<std::int64_t>(i, 0, n - 1);
        };
        return opaque[static_cast<std::size_t>(within(y, height) * width + within(x, width))] != 0;
    }
};

void note_uniformity(Mask& mask)
{
    mask.is_uniform = std::count(mask.opaque.begin(), mask.opaque.end(), mask.opaque[0]) == mask.width * mask.height;
}

/// The mask of an image; `of_opacity`: if it has no transparent pixel, its brightness is the opacity (`map_d`).
Mask mask_of(const Texture& texture, bool of_opacity)
{
    const Bitmap& bitmap = texture.bitmap();
    Mask mask{bitmap.width, bitmap.height, texture.repeats(), {}, true};
    const auto is_transparent = [](std::uint8_t alpha) { return alpha < 128; };
    const bool by_alpha = std::any_of(bitmap.alpha.begin(), bitmap.alpha.end(), is_transparent);
    mask.opaque.assign(std::size_t{bitmap.width} * bitmap.height, 1);
    if (!by_alpha && !of_opacity)
        return mask;
    auto opaque = mask.opaque.begin();
    for (std::size_t y = bitmap.height; y-- > 0;)
        for (std::size_t x = 0; x < bitmap.width; ++x, ++opaque) {
            const std::size_t pixel = y * bitmap.width + x;
            const std::uint8_t* rgb = bitmap.rgb.data() + 3 * pixel;
            *opaque = by_alpha ? !is_transparent(bitmap.alpha[pixel]) : rgb[0] + rgb[1] + rgb[2] >= 3 * 128;
        }
    note_uniformity(mask);
    return mask;
}

/// The mask with pixels 2^level times as wide and high, as far as the size allows.
Mask coarser(const Mask& fine, unsigned level)
{
    Mask mask{std::max<std::int64_t>(1, fine.width >> level),
              std::max<std::int64_t>(1, fine.height >> level),
              fine.repeats,
              {},
              false};
    std::vector<std::int64_t> balance(static_cast<std::size_t>(mask.width * mask.height)); // opaque minus others
    for (std::int64_t y = 0; y < fine.height; ++y)
        for (std::int64_t x = 0; x < fine.width; ++x)
            balance[static_cast<std::size_t>(y * mask.height / fine.height * mask.width +
                                             x * mask.width / fine.width)] += fine.at(x, y) ? 1 : -1;
    for (const std::int64_t sum : balance)
        mask.opaque.push_back(sum >= 0 ? 1 : 0);
    note_uniformity(mask);
    return mask;
}

/// The part of the polygon where sign * coordinate <= sign * border.
TexturePolygon clipped(const TexturePolygon& polygon, double TexturePoint::*coordinate, double border, double sign)
{
    TexturePolygon part;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const TexturePoint a = polygon[i];
        const TexturePoint b = polygon[(i + 1) % polygon.size()];
        const double from_a = sign * (border - a.*coordinate);
        const double from_b = sign * (border - b.*coordinate);
        if (from_a >= 0.0)
            part.push_back(a);
        if ((from_a > 0.0 && from_b < 0.0) || (from_a < 0.0 && from_b > 0.0)) {
            const double share = from_a / (from_a - from_b);
            TexturePoint crossing = {a.s + share * (b.s - a.s), a.t + share * (b.t - a.t)};
            crossing.*coordinate = border;
            part.push_back(crossing);
        }
    }
    return part;
}

/// Columns [x0, x1) and rows [y0, y1) of pixels.
struct PixelRectangle
{
    std::int64_t x0, y0, x1, y1;

    double pixels() const { return static_cast<double>(x1 - x0) * static_cast<double>(y1 - y0); }
};

PixelRectangle around(const TexturePolygon& polygon)
{
    const auto [left, right] =
        std::minmax_element(polygon.begin(), polygon.end(), [](TexturePoint a, TexturePoint b) { return a.s < b.s; });
    const auto [low, high] =
        std::minmax_element(polygon.begin(), polygon.end(), [](TexturePoint a, TexturePoint b) { return a.t < b.t; });
    const auto floor = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
    return {floor(left->s), floor(low->t), floor(right->s) + 1, floor(high->t) + 1};
}

/// The opaque pixels in a rectangle, joined to larger rectangles.
std::vector<PixelRectangle> opaque_rectangles(const Mask& mask, const PixelRectangle& bounds)
{
    const std::int64_t width = bounds.x1 - bounds.x0;
    std::vector<char> is_free(static_cast<std::size_t>(bounds.pixels()));
    const auto free_at = [&](std::int64_t x, std::int64_t y) -> char& {
        return is_free[static_cast<std::size_t>((y - bounds.y0) * width + x - bounds.x0)];
    };
    for (std::int64_t y = bounds.y0; y < bounds.y1; ++y)
        for (std::int64_t x = bounds.x0; x < bounds.x1; ++x)
            free_at(x, y) = mask.at(x, y) ? 1 : 0;
    std::vector<PixelRectangle> rectangles;
    for (std::int64_t y = bounds.y0; y < bounds.y1; ++y)
        for (std::int64_t x = bounds.x0; x < bounds.x1; ++x) {
            if (free_at(x, y) == 0)
                continue;
            PixelRectangle r = {x, y, x + 1, y + 1};
            while (r.x1 < bounds.x1 && free_at(r.x1, y) != 0)
                ++r.x1;
            const auto row = [&](std::int64_t at) { return &free_at(x, at); };
            while (r.y1 < bounds.y1 && std::count(row(r.y1), row(r.y1) + (r.x1 - x), 0) == 0)
                ++r.y1;
            for (std::int64_t taken = y; taken < r.y1; ++taken)
                std::fill(row(taken), row(taken) + (r.x1 - x), 0);
            rectangles.push_back(r);
        }
    return rectangles;
}

/// Cuts the pieces of one material.
class MaterialCutter
{
public:
    MaterialCutter(const TextureMap& map, const SceneScale& scale, const LargeVector<Piece>& pieces, ObjMesh& mesh)
        : map_(map), scale_(scale), pieces_(pieces), mesh_(mesh)
    {
    }

    /// What replaces a piece; nothing for one that stays.
    struct Replacement
    {
        std::uint32_t piece;
        std::vector<TexturePolygon> parts; ///< in pixels of the mask
    };

    /// The replacements of these pieces; nothing if they would be too many.
    std::optional<std::vector<Replacement>> cut(const std::vector<std::uint32_t>& numbers, const Mask& mask) const
    {
        std::vector<Replacement> replacements;
        double visited = 0.0;
        std::size_t count = 0;
        for (const std::uint32_t number : numbers) {
            const TexturePolygon whole = footprint(pieces_[number], mask);
            if (whole.empty())
                continue;
            visited += mask.is_uniform ? 0.0 : around(whole).pixels();
            if (visited > most_pixels_visited)
                return std::nullopt;
            const double area = std::abs(area_of(whole));
            std::vector<TexturePolygon> parts = opaque_parts(whole, mask);
            double opaque = 0.0;
            for (const TexturePolygon& part : parts)
                opaque += std::abs(area_of(part));
            if (opaque >= (1.0 - no_part) * area)
                continue;
            if (opaque <= no_part * area)
                parts.clear();
            count += parts.size();
            if (count > most_new_pieces)
                return std::nullopt;
            replacements.push_back({number, std::move(parts)});
        }
        return replacements;
    }

    /// Adds the parts of a piece to `pieces`, and their corners to the mesh.
    void add(const Replacement& replacement, const Mask& mask, LargeVector<Piece>& pieces)
    {
        const Piece& piece = pieces_[replacement.piece];
        const TexturePolygon whole = footprint(piece, mask);
        for (TexturePolygon part : replacement.parts) {
            if (area_of(whole) < 0.0) // the texture is mirrored
                std::reverse(part.begin(), part.end());
            std::vector<std::uint32_t> vertices;
            std::vector<std::uint32_t> points;
            for (const TexturePoint corner : part) {
                const auto [u, v] = place_of(corner, whole);
                add_corner(piece, u, v);
                vertices.push_back(static_cast<std::uint32_t>(mesh_.vertices.size() - 1));
                points.push_back(static_cast<std::uint32_t>(mesh_.texture_points.size() - 1));
            }
            const auto is_large = [&](std::size_t a, std::size_t b, std::size_t c) {
                const Vec3 corner = mesh_.vertices[vertices[a]];
                return 0.5 * length(cross(mesh_.vertices[vertices[b]] - corner, mesh_.vertices[vertices[c]] - corner)) >
                       scale_.smallest_area();
            };
            const auto add = [&](const std::array<std::uint32_t, 4>& corners, const std::array<std::uint32_t, 4>& at) {
                Piece added = piece;
                added.corners = corners;
                added.points = at;
                pieces.push_back(added);
            };
            if (is_parallelogram(part)) {
                if (is_large(0, 1, 3))
                    add({vertices[0], vertices[1], vertices[2], vertices[3]},
                        {points[0], points[1], points[2], points[3]});
                continue;
            }
            for (std::size_t i = 2; i < part.size(); ++i)
                if (is_large(0, i - 1, i))
                    add({vertices[0], vertices[i - 1], vertices[i], Piece::no_vertex},
                        {points[0], points[i - 1], points[i], ObjMesh::no_point});
        }
    }

private:
    /// The corners of a piece in pixels; nothing if it has no texture coordinates.
    TexturePolygon footprint(const Piece& piece, const Mask& mask) const
    {
        TexturePolygon polygon;
        for (std::size_t k = 0; k < (piece.is_triangle() ? 3 : 4) && has_texture_points(piece, mesh_); ++k) {
            const TexturePoint p = map_.at(mesh_.texture_points[piece.points[k]]);
            polygon.push_back({p.s * static_cast<double>(mask.width), p.t * static_cast<double>(mask.height)});
        }
        return polygon;
    }

    static std::vector<TexturePolygon> opaque_parts(const TexturePolygon& whole, const Mask& mask)
    {
        constexpr double no_area = 1e-9; // [pixels], as for the mean of a texture
        const bool is_point = std::abs(area_of(whole)) < no_area;
        if (is_point || mask.is_uniform) {
            const TexturePoint middle = middle_of(whole);
            const bool opaque = mask.at(static_cast<std::int64_t>(std::floor(middle.s)),
                                        static_cast<std::int64_t>(std::floor(middle.t)));
            return opaque ? std::vector<TexturePolygon>{whole} : std::vector<TexturePolygon>{};
        }
        std::vector<TexturePolygon> parts;
        for (const PixelRectangle& r : opaque_rectangles(mask, around(whole))) {
            TexturePolygon part = whole;
            part = clipped(part, &TexturePoint::s, static_cast<double>(r.x0), -1.0);
            part = clipped(part, &TexturePoint::s, static_cast<double>(r.x1), 1.0);
            part = clipped(part, &TexturePoint::t, static_cast<double>(r.y0), -1.0);
            part = clipped(part, &TexturePoint::t, static_cast<double>(r.y1), 1.0);
            // Area in either direction: clipping keeps the order of the corners.
            if (part.size() >= 3 && std::abs(area_of(part)) > no_area)
                parts.push_back(area_of(part) > 0.0 ? part : TexturePolygon(part.rbegin(), part.rend()));
        }
        return parts;
    }

    static bool is_parallelogram(const TexturePolygon& p)
    {
        constexpr double tolerance = 1e-9; // [pixels]
        return p.size() == 4 && std::abs(p[1].s - p[0].s - (p[2].s - p[3].s)) <= tolerance &&
               std::abs(p[1].t - p[0].t - (p[2].t - p[3].t)) <= tolerance;
    }

    /// The coordinates (u, v) on a piece of a point of its footprint. Those of its own corners and edges are exact.
    static std::pair<double, double> place_of(TexturePoint p, const TexturePolygon& whole)
    {
        const TexturePoint o = whole[0];
        const TexturePoint a = {whole[1].s - o.s, whole[1].t - o.t};
        const TexturePoint b = {whole.back().s - o.s, whole.back().t - o.t};
        const double determinant = a.s * b.t - a.t * b.s;
        const auto tidy = [](double x) {
            const double nearest = std::floor(x + 0.5);
            return std::abs(x - nearest) < 1e-12 ? nearest : x;
        };
        return {tidy(((p.s - o.s) * b.t - (p.t - o.t) * b.s) / determinant),
                tidy((a.s * (p.t - o.t) - a.t * (p.s - o.s)) / determinant)};
    }

    /// Adds the vertex and the texture point at (u, v) of a piece.
    void add_corner(const Piece& piece, double u, double v)
    {
        const std::size_t last = piece.is_triangle() ? 2 : 3;
        const Vec3 origin = mesh_.vertices[piece.corners[0]];
        mesh_.vertices.push_back(origin + u * (mesh_.vertices[piece.corners[1]] - origin) +
                                 v * (mesh_.vertices[piece.corners[last]] - origin));
        const TexturePoint o = mesh_.texture_points[piece.points[0]];
        const TexturePoint a = mesh_.texture_points[piece.points[1]];
        const TexturePoint b = mesh_.texture_points[piece.points[last]];
        mesh_.texture_points.push_back(
            {o.s + u * (a.s - o.s) + v * (b.s - o.s), o.t + u * (a.t - o.t) + v * (b.t - o.t)});
    }

    const TextureMap& map_;
    const SceneScale scale_;
    const LargeVector<Piece>& pieces_;
    ObjMesh& mesh_;
};

} // namespace

std::vector<std::string> cut_out(const std::vector<MtlMaterial>& definitions, const SceneScale& scale,
                                 TextureFiles& textures, ObjMesh& mesh, LargeVector<Piece>& pieces)
{
    std::vector<std::string> messages;
    std::vector<std::vector<std::uint32_t>> of_material(definitions.size());
    for (std::uint32_t k = 0; k < pieces.size(); ++k)
        of_material[mesh.faces[pieces[k].face].material].push_back(k);

    std::vector<std::pair<std::uint32_t, LargeVector<Piece>>> replaced;
    for (std::size_t m = 0; m < definitions.size(); ++m) {
        const bool of_opacity = textures.load(definitions[m].opacity_map).texture != nullptr;
        const TextureMap& map = of_opacity ? definitions[m].opacity_map : definitions[m].reflectance_map;
        const std::shared_ptr<const Texture> texture = textures.load(map).texture;
        if (!texture || of_material[m].empty())
            continue;
        const Mask fine = mask_of(*texture, of_opacity);
        if (fine.is_uniform && fine.at(0, 0))
            continue;
        MaterialCutter cutter(map, scale, pieces, mesh);
        Mask mask = fine;
        std::optional<std::vector<MaterialCutter::Replacement>> replacements = cutter.cut(of_material[m], mask);
        for (unsigned level = 1; !replacements; ++level) {
            mask = coarser(fine, level);
            replacements = cutter.cut(of_material[m], mask);
        }
        std::size_t left_out = 0;
        std::size_t parts = 0;
        for (const MaterialCutter::Replacement& replacement : *replacements) {
            LargeVector<Piece> added;
            cutter.add(replacement, mask, added);
            left_out += added.empty() ? 1 : 0;
            parts += added.size();
            replaced.emplace_back(replacement.piece, std::move(added));
        }
        const auto whole = std::count_if(of_material[m].begin(), of_material[m].end(),
                                         [&](std::uint32_t k) { return !has_texture_points(pieces[k], mesh); });
        if (whole > 0)
            messages.push_back(mesh.path + ": `" + definitions[m].material.name + "` has transparent parts (" +
                               texture->name() + "), but for lack of texture coordinates these stay opaque: " +
                               counted(static_cast<std::size_t>(whole), "surface"));
        if (replacements->empty())
            continue;
        std::string message = mesh.path + ": transparent parts of `" + definitions[m].material.name + "` (" +
                              texture->name() + ") are cut out: " + counted(parts, "surface") + " instead of " +
                              std::to_string(replacements->size());
        if (left_out > 0)
            message += ", " + std::to_string(left_out) + " entirely transparent";
        if (mask.width < fine.width || mask.height < fine.height)
            message += ", by a mask of " + std::to_string(mask.width) + " x " + std::to_string(mask.height) +
                       " instead of " + std::to_string(fine.width) + " x " + std::to_string(fine.height) + " pixels";
        messages.push_back(message);
    }
    if (replaced.empty())
        return messages;

    std::sort(replaced.begin(), replaced.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    LargeVector<Piece> result;
    auto next = replaced.begin();
    for (std::uint32_t k = 0; k < pieces.size(); ++k) {
        if (next == replaced.end() || next->first != k) {
            result.push_back(pieces[k]);
            continue;
        }
        result.insert(result.end(), next->second.begin(), next->second.end());
        ++next;
    }
    pieces = std::move(result);
    return messages;
}

} // namespace multipath
