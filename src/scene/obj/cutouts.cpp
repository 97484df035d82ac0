// The opaque pixels below a piece are joined to rectangles, greedily: each as wide as possible, then as high. The
// piece, a convex polygon in the plane of the texture, is clipped against each rectangle (Sutherland and Hodgman 1974),
// and the parts are mapped back into space by the affine map between the two. So areas, lines and form factors need to
// know nothing of transparency.

#include "scene/obj/cutouts.h"

#include "base/lists.h"
#include "base/text_format.h"
#include "geometry/bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
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

    Mask(std::int64_t w, std::int64_t h, bool is_repeating, std::vector<char> pixels)
        : width(w),
          height(h),
          repeats(is_repeating),
          opaque(std::move(pixels)),
          is_uniform(std::count(opaque.begin(), opaque.end(), opaque[0]) == w * h)
    {
    }

    bool at(std::int64_t x, std::int64_t y) const
    {
        const auto within = [&](std::int64_t i, std::int64_t n) {
            return repeats ? ((i % n) + n) % n : std::clamp<std::int64_t>(i, 0, n - 1);
        };
        return opaque[static_cast<std::size_t>(within(y, height) * width + within(x, width))] != 0;
    }
};

/// The mask of an image; `of_opacity`: if it has no transparent pixel, its brightness is the opacity (`map_d`).
Mask mask_of(const Texture& texture, bool of_opacity)
{
    const Bitmap& bitmap = texture.bitmap();
    const auto is_transparent = [](std::uint8_t alpha) { return alpha < 128; };
    const bool by_alpha = std::any_of(bitmap.alpha.begin(), bitmap.alpha.end(), is_transparent);
    std::vector<char> opaque;
    opaque.reserve(std::size_t{bitmap.width} * bitmap.height);
    for (std::size_t y = bitmap.height; y-- > 0;)
        for (std::size_t x = 0; x < bitmap.width; ++x) {
            const std::size_t pixel = y * bitmap.width + x;
            const std::uint8_t* rgb = bitmap.rgb.data() + 3 * pixel;
            opaque.push_back(by_alpha ? !is_transparent(bitmap.alpha[pixel])
                                      : !of_opacity || rgb[0] + rgb[1] + rgb[2] >= 3 * 128);
        }
    return {bitmap.width, bitmap.height, texture.repeats(), std::move(opaque)};
}

/// The mask with pixels 2^level times as wide and high, as far as the size allows.
Mask coarser(const Mask& fine, unsigned level)
{
    const std::int64_t width = std::max<std::int64_t>(1, fine.width >> level);
    const std::int64_t height = std::max<std::int64_t>(1, fine.height >> level);
    std::vector<std::int64_t> balance(static_cast<std::size_t>(width * height)); // opaque minus others
    for (std::int64_t y = 0; y < fine.height; ++y)
        for (std::int64_t x = 0; x < fine.width; ++x)
            balance[static_cast<std::size_t>(y * height / fine.height * width + x * width / fine.width)] +=
                fine.at(x, y) ? 1 : -1;
    return {width, height, fine.repeats,
            mapped(balance, [](std::int64_t sum) { return sum >= 0 ? char{1} : char{0}; })};
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
    Bounds box;
    for (const TexturePoint p : polygon)
        box.include(Vec3{p.s, p.t, 0.0});
    const auto floor = [](double x) { return static_cast<std::int64_t>(std::floor(x)); };
    return {floor(box.low.x), floor(box.low.y), floor(box.high.x) + 1, floor(box.high.y) + 1};
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
        TexturePolygon whole;              ///< in pixels of the mask
        std::vector<TexturePolygon> parts; ///< in the same direction
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
            std::vector<TexturePolygon> parts = opaque_parts(whole, mask);
            const double opaque = sum_over(parts, [](const TexturePolygon& part) { return std::abs(area_of(part)); });
            if (opaque >= (1.0 - no_part) * std::abs(area_of(whole)))
                continue;
            count += parts.size();
            if (count > most_new_pieces)
                return std::nullopt;
            replacements.push_back({number, whole, std::move(parts)});
        }
        return replacements;
    }

    /// The pieces that take the place of a piece. Their corners are added to the mesh.
    LargeVector<Piece> pieces_of(const Replacement& replacement)
    {
        const Piece& piece = pieces_[replacement.piece];
        LargeVector<Piece> result;
        const auto add = [&](const std::array<ObjCorner, 4>& corners) {
            Piece added = piece;
            added.corners = corners;
            if (!scale_.is_degenerate(mesh_.at(corners[0]), mesh_.at(corners[1]), mesh_.at(added.end_of_v())))
                result.push_back(added);
        };
        for (const TexturePolygon& part : replacement.parts) {
            std::vector<ObjCorner> corners;
            for (const TexturePoint corner : part)
                corners.push_back(new_corner(piece, corner, replacement.whole));
            if (part.size() == 4 && is_parallelogram(mesh_.at(corners[0]), mesh_.at(corners[1]), mesh_.at(corners[2]),
                                                     mesh_.at(corners[3]), scale_))
                add({corners[0], corners[1], corners[2], corners[3]});
            else
                for (std::size_t i = 2; i < part.size(); ++i)
                    add({corners[0], corners[i - 1], corners[i]});
        }
        return result;
    }

private:
    /// The corners of a piece in pixels; nothing if it has no texture coordinates.
    TexturePolygon footprint(const Piece& piece, const Mask& mask) const
    {
        TexturePolygon polygon;
        for (std::size_t k = 0; k < piece.corner_count() && piece.has_texture_points(); ++k) {
            const TexturePoint p = map_.at(mesh_.texture_points[piece.corners[k].point]);
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
            if (part.size() >= 3 && std::abs(area_of(part)) > no_area)
                parts.push_back(std::move(part));
        }
        return parts;
    }

    /// Adds the vertex and the texture point of a piece at a point of its footprint.
    ObjCorner new_corner(const Piece& piece, TexturePoint p, const TexturePolygon& footprint)
    {
        const TexturePoint corner = footprint[0];
        const TexturePoint along_u = {footprint[1].s - corner.s, footprint[1].t - corner.t};
        const TexturePoint along_v = {footprint.back().s - corner.s, footprint.back().t - corner.t};
        const double determinant = along_u.s * along_v.t - along_u.t * along_v.s;
        const auto tidy = [](double x) { // exact at the corners and edges of the piece
            const double nearest = std::floor(x + 0.5);
            return std::abs(x - nearest) < 1e-12 ? nearest : x;
        };
        const double u = tidy(((p.s - corner.s) * along_v.t - (p.t - corner.t) * along_v.s) / determinant);
        const double v = tidy((along_u.s * (p.t - corner.t) - along_u.t * (p.s - corner.s)) / determinant);

        const Vec3 origin = mesh_.at(piece.corners[0]);
        mesh_.vertices.push_back(origin + u * (mesh_.at(piece.corners[1]) - origin) +
                                 v * (mesh_.at(piece.end_of_v()) - origin));
        const TexturePoint o = mesh_.texture_points[piece.corners[0].point];
        const TexturePoint a = mesh_.texture_points[piece.corners[1].point];
        const TexturePoint b = mesh_.texture_points[piece.end_of_v().point];
        mesh_.texture_points.push_back(
            {o.s + u * (a.s - o.s) + v * (b.s - o.s), o.t + u * (a.t - o.t) + v * (b.t - o.t)});
        return {static_cast<std::uint32_t>(mesh_.vertices.size() - 1),
                static_cast<std::uint32_t>(mesh_.texture_points.size() - 1)};
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

    std::map<std::uint32_t, LargeVector<Piece>> replaced;
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
        std::optional<std::vector<MaterialCutter::Replacement>> replacements;
        for (unsigned level = 0; !replacements; ++level) {
            mask = coarser(fine, level);
            replacements = cutter.cut(of_material[m], mask);
        }
        std::size_t parts = 0;
        for (const MaterialCutter::Replacement& replacement : *replacements) {
            LargeVector<Piece>& added = replaced[replacement.piece];
            added = cutter.pieces_of(replacement);
            parts += added.size();
        }
        const std::string subject =
            mesh.path + ": transparent parts of `" + definitions[m].material.name + "` (" + texture->name() + ") ";
        const auto whole = std::count_if(of_material[m].begin(), of_material[m].end(),
                                         [&](std::uint32_t k) { return !pieces[k].has_texture_points(); });
        if (whole > 0)
            messages.push_back(subject + "stay opaque for lack of texture coordinates: " +
                               counted(static_cast<std::size_t>(whole), "surface"));
        if (!replacements->empty())
            messages.push_back(subject + "are cut out: " + counted(parts, "surface") + " instead of " +
                               std::to_string(replacements->size()) +
                               (mask.opaque.size() < fine.opaque.size()
                                    ? ", by a coarser mask of " + std::to_string(mask.width) + " x " +
                                          std::to_string(mask.height) + " pixels"
                                    : ""));
    }

    if (replaced.empty())
        return messages;
    LargeVector<Piece> result;
    for (std::uint32_t k = 0; k < pieces.size(); ++k)
        if (const auto found = replaced.find(k); found != replaced.end())
            result.insert(result.end(), found->second.begin(), found->second.end());
        else
            result.push_back(pieces[k]);
    pieces = std::move(result);
    return messages;
}

} // namespace multipath
