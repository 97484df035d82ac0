// A reflectance map is kept, with a frame for each of its surfaces, so that every patch can have its own mean. An
// emission map is averaged at once over all surfaces of its material, which has a single emittance. Colours of vertices
// become a texture with a pixel for each colour.

#include "scene/obj/obj_textures.h"

#include "base/errors.h"
#include "base/file_bytes.h"
#include "base/text_format.h"
#include "scene/text/text_lines.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace multipath {

const TextureFiles::Loaded& TextureFiles::load(const TextureMap& map)
{
    const auto [entry, is_new] = known_.try_emplace({map.found, map.repeats});
    Loaded& loaded = entry->second;
    if (!is_new)
        return loaded;
    constexpr std::uintmax_t most_bytes = std::uintmax_t{1} << 28;
    try {
        if (map.found.empty())
            throw ImageError("not found");
        std::error_code error;
        if (std::filesystem::file_size(path_of(map.found), error) > most_bytes && !error)
            throw ImageError("is larger than 256 MB");
        loaded.texture = std::make_shared<const Texture>(path_of(map.found).filename().u8string(),
                                                         bytes_of_file(map.found), map.repeats);
    } catch (const ImageError& error) {
        loaded.problem = error.what();
    } catch (const InputError&) {
        loaded.problem = "cannot be read";
    }
    return loaded;
}

namespace {

/// Adds textures to a scene.
class ObjTextures
{
public:
    ObjTextures(const std::vector<MtlMaterial>& definitions, const MeshPieces& cut, const ObjMesh& mesh,
                TextureFiles& files, SceneFile& scene)
        : definitions_(definitions), cut_(cut), mesh_(mesh), files_(files), scene_(scene), areas_(definitions.size())
    {
        for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
            areas_[scene.material[s]] += scene.surfaces[s].area();
    }

    std::vector<std::string> add(double limit)
    {
        for (std::uint32_t m = 0; m < definitions_.size(); ++m) {
            if (!(areas_[m] > 0.0))
                continue;
            const std::size_t failures_before = failures_.size();
            if (const auto texture = load(m, definitions_[m].reflectance_map))
                apply_reflectance_map(m, texture, limit);
            if (const auto texture = load(m, definitions_[m].emission_map))
                apply_emission_map(m, *texture);
            load(m, definitions_[m].opacity_map);
            if (failures_.size() > failures_before)
                failed_area_ += areas_[m];
        }
        if (!cut_.colours.empty())
            apply_colours(limit);
        if (!scene_.textures.empty())
            fill_frames();
        return report_failures();
    }

private:
    /// The texture of a map; null if there is no map, or after noting a failure.
    std::shared_ptr<const Texture> load(std::uint32_t material, const TextureMap& map)
    {
        if (map.line == 0)
            return nullptr;
        const TextureFiles::Loaded& loaded = files_.load(map);
        if (!loaded.texture)
            failures_.push_back(in_quotes(scene_.materials[material].name) + " (" + map.file + ": " + loaded.problem +
                                ")");
        return loaded.texture;
    }

    /// The frame of a surface; unknown if a corner has no texture point.
    TextureFrame frame(std::size_t surface, const TextureMap& map) const
    {
        const Piece& piece = cut_.pieces[surface];
        if (!piece.has_texture_points())
            return {};
        const auto at = [&](ObjCorner corner) { return map.at(mesh_.texture_points[corner.point]); };
        const TexturePoint origin = at(piece.corners[0]);
        const TexturePoint u = at(piece.corners[1]);
        const TexturePoint v = at(piece.end_of_v());
        return {origin, {u.s - origin.s, u.t - origin.t}, {v.s - origin.s, v.t - origin.t}, true};
    }

    /// The area-weighted mean of a texture over all surfaces of a material.
    Rgb mean_of(std::uint32_t material, const TextureMap& map, const Texture& texture) const
    {
        Rgb sum;
        for (std::size_t s = 0; s < scene_.surfaces.size(); ++s) {
            if (scene_.material[s] != material)
                continue;
            std::vector<std::array<double, 2>> corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
            if (scene_.surfaces[s].shape == Shape::triangle)
                corners.erase(corners.begin() + 2);
            sum += scene_.surfaces[s].area() * texture_mean(texture, frame(s, map), corners);
        }
        return 1.0 / areas_[material] * sum;
    }

    /// The colour that multiplies a texture: 1 if it is 0. `line`: where a file gives it, or 0.
    Rgb beside_map(Rgb colour, const std::string& name, std::uint32_t line)
    {
        if (colour != Rgb{})
            return colour;
        if (line != 0)
            zeros_.push_back(name);
        return {1.0, 1.0, 1.0};
    }

    void apply_reflectance_map(std::uint32_t m, const std::shared_ptr<const Texture>& texture, double limit)
    {
        Material& material = scene_.materials[m];
        const Rgb kd = beside_map(material.reflectance, "Kd of " + in_quotes(material.name), definitions_[m].kd_line);
        material.texture_scale = by_channel([&](double r) { return std::min(r, limit); }, kd);
        material.reflectance = material.texture_scale * mean_of(m, definitions_[m].reflectance_map, *texture);
        material.texture = index_of(texture);
    }

    std::uint32_t index_of(const std::shared_ptr<const Texture>& texture)
    {
        const auto known = std::find(scene_.textures.begin(), scene_.textures.end(), texture);
        const auto index = static_cast<std::uint32_t>(known - scene_.textures.begin());
        if (known == scene_.textures.end())
            scene_.textures.push_back(texture);
        return index;
    }

    /// A texture with the colours of pieces, then white and grey 0.5 for pieces without a colour.
    std::shared_ptr<const Texture> palette() const
    {
        constexpr std::size_t width = 1024;
        const std::size_t count = cut_.colours.size() + 2;
        const std::size_t height = (count + width - 1) / width;
        std::string bytes = "P6 " + std::to_string(width) + " " + std::to_string(height) + " 255\n";
        for (const std::array<std::uint8_t, 3>& colour : cut_.colours)
            bytes.append(colour.begin(), colour.end());
        bytes.append(3, '\xff');
        bytes.append(3, '\xbc');
        bytes.resize(bytes.size() + 3 * (width * height - count));
        return std::make_shared<const Texture>("vertex_colours.ppm", std::move(bytes), false);
    }

    /// The frame of a surface whose material has the palette as its texture: a single point.
    TextureFrame frame_of_colour(std::size_t surface) const
    {
        const Bitmap& bitmap = palette_->bitmap();
        const std::uint32_t colour = cut_.pieces[surface].colour;
        const bool has_kd = definitions_[scene_.material[surface]].kd_line != 0;
        const std::size_t pixel = colour != Piece::no_colour ? colour : cut_.colours.size() + (has_kd ? 0 : 1);
        const std::size_t row = pixel / bitmap.width;
        const std::size_t column = pixel % bitmap.width;
        return {{(static_cast<double>(column) + 0.5) / bitmap.width,
                 1.0 - (static_cast<double>(row) + 0.5) / bitmap.height},
                {},
                {},
                true};
    }

    /// Multiplies Kd by the colours of the pieces of materials without a texture.
    void apply_colours(double limit)
    {
        palette_ = palette();
        const std::size_t count = definitions_.size();
        std::vector<Rgb> sums(count); // of area times colour
        std::vector<bool> is_coloured(count);
        for (std::size_t s = 0; s < scene_.surfaces.size(); ++s) {
            const std::uint32_t m = scene_.material[s];
            sums[m] += scene_.surfaces[s].area() * palette_->mean(TexturePolygon{frame_of_colour(s).origin});
            is_coloured[m] = is_coloured[m] || cut_.pieces[s].colour != Piece::no_colour;
        }
        for (std::size_t m = 0; m < count; ++m) {
            Material& material = scene_.materials[m];
            if (!is_coloured[m] || material.texture != Material::no_texture)
                continue;
            material.texture = index_of(palette_);
            material.texture_scale = definitions_[m].kd_line == 0 ? Rgb{limit, limit, limit} : material.reflectance;
            material.reflectance = material.texture_scale * (1.0 / areas_[m] * sums[m]);
        }
        scene_.warnings.push_back(scene_.path + ": the colours of vertices, decoded from sRGB, multiply Kd; a surface "
                                                "has the mean of its corners");
    }

    void apply_emission_map(std::uint32_t m, const Texture& texture)
    {
        Material& material = scene_.materials[m];
        const Rgb ke =
            beside_map(material.emittance, "Ke of " + in_quotes(material.name), definitions_[m].emission_line);
        material.emittance = ke * mean_of(m, definitions_[m].emission_map, texture);
    }

    void fill_frames()
    {
        scene_.texture_frames.resize(scene_.surfaces.size());
        for (std::size_t s = 0; s < scene_.surfaces.size(); ++s)
            if (const std::uint32_t texture = scene_.materials[scene_.material[s]].texture;
                texture != Material::no_texture)
                scene_.texture_frames[s] = scene_.textures[texture] == palette_
                                               ? frame_of_colour(s)
                                               : frame(s, definitions_[scene_.material[s]].reflectance_map);
    }

    /// Warns of what is wrong, and returns a text for each texture that was not read.
    std::vector<std::string> report_failures()
    {
        if (!zeros_.empty())
            scene_.warnings.push_back(scene_.path + ": 0 beside a texture, which counts alone: " + join(zeros_));
        const double share = failed_area_ / std::accumulate(areas_.begin(), areas_.end(), 0.0);
        if (!failures_.empty())
            scene_.warnings.push_back(scene_.path + ": " + counted(failures_.size(), "texture") +
                                      " not read, the colours of the materials (" + format("%.3g", 100.0 * share) +
                                      " % of the area) stand alone: " + first_of(failures_, 5));
        return std::move(failures_);
    }

    const std::vector<MtlMaterial>& definitions_;
    const MeshPieces& cut_;
    const ObjMesh& mesh_;
    TextureFiles& files_;
    SceneFile& scene_;
    std::vector<double> areas_;              ///< [m^2] per material
    double failed_area_ = 0.0;               ///< [m^2] of the materials of failures_
    std::vector<std::string> failures_;      ///< materials and what is wrong with their textures
    std::vector<std::string> zeros_;         ///< "Kd of `wood`"
    std::shared_ptr<const Texture> palette_; ///< null if no piece has a colour
};

} // namespace

std::vector<std::string> add_textures(const std::vector<MtlMaterial>& definitions, const MeshPieces& cut,
                                      const ObjMesh& mesh, TextureFiles& files, double limit, SceneFile& scene)
{
    return ObjTextures(definitions, cut, mesh, files, scene).add(limit);
}

} // namespace multipath
