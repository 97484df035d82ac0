#include "viewer/viewer_page.h"

#include "base/lists.h"
#include "base/little_endian.h"
#include "base/text_format.h"
#include "export/html_text.h"
#include "export/json.h"
#include "export/mesh/patch_mesh.h"
#include "image/colour_scale.h"
#include "image/png.h"
#include "image/shading/smooth_shading.h"
#include "image/tone_map.h"
#include "scene/scene_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <unordered_map>

namespace multipath {

namespace {

// Lists of numbers as the page holds them: the little-endian bytes of a JavaScript typed array, in base64.

/// A Uint8Array.
std::string packed_bytes(const std::vector<std::uint8_t>& values)
{
    return base64(std::string(values.begin(), values.end()));
}

/// A Uint32Array.
std::string packed_counts(const std::vector<std::uint32_t>& values)
{
    std::string bytes;
    for (const std::uint32_t value : values)
        append_little_endian(bytes, value);
    return base64(bytes);
}

/// A Float32Array.
std::string packed_numbers(const std::vector<double>& values)
{
    std::string bytes;
    for (const double value : values)
        append_little_endian(bytes, static_cast<float>(value));
    return base64(bytes);
}

/// Three numbers for each colour.
std::string packed_colours(const std::vector<Rgb>& values)
{
    std::vector<double> channels;
    for (const Rgb& value : values)
        channels.insert(channels.end(), {value.r, value.g, value.b});
    return packed_numbers(channels);
}

/// The bits of a number in [0, largest_half] as a float of 16 bits (IEEE 754), rounded. Times 2^-112 it has the same
/// exponent as a float of 32 bits, with 13 more digits.
std::uint16_t half_float(double value)
{
    const auto shifted = static_cast<float>(std::ldexp(value, -112));
    std::uint32_t bits = 0;
    std::memcpy(&bits, &shifted, sizeof bits);
    return static_cast<std::uint16_t>((bits + 0x1000u) >> 13);
}

} // namespace

PackedLight packed_light(const std::vector<Rgb>& values)
{
    double brightest = 0.0;
    for (const Rgb& value : values)
        brightest = std::max({brightest, value.r, value.g, value.b});
    PackedLight packed;
    if (brightest > 0.0)
        packed.unit = brightest / largest_half;
    std::string bytes;
    for (const Rgb& value : values)
        for (const double channel : {value.r, value.g, value.b}) {
            const std::uint16_t half = half_float(channel / packed.unit);
            bytes += {static_cast<char>(half & 0xffu), static_cast<char>(half >> 8)};
        }
    packed.halves = base64(bytes);
    return packed;
}

CornerValues corner_values(const Scene& scene, const std::vector<Rgb>& values_per_patch, int threads)
{
    const SmoothShading shading(scene, values_per_patch, threads);
    CornerValues result;
    std::vector<Rgb> own;
    std::unordered_map<std::uint64_t, std::size_t> numbers; // of the points of a side
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch) {
        if (patch == scene.first_patch(scene.surface_of(patch), scene.is_front(patch)))
            numbers.clear();
        const CellCorners corners = scene.corners(patch);
        for (std::uint32_t k = 0; k < corners.count; ++k) {
            const Rgb value = shading.at_corners(patch)[k];
            const GridPoint point = corners.points[k];
            const auto known = numbers.try_emplace(std::uint64_t{point.j} << 32 | point.i, result.values.size());
            if (known.second) {
                result.values.push_back(value);
            } else if (result.values[known.first->second] != value) {
                result.own_places.push_back(4 * patch + k);
                own.push_back(value);
            }
        }
    }
    result.values.insert(result.values.end(), own.begin(), own.end());
    return result;
}

// Comments of page.html are replaced by the head and by the data of the room, a JSON document, so that the result is
// one self-contained file. docs/builders/page.md describes the document.

namespace {

double six_digits(double value)
{
    return std::strtod(format("%.6g", value).c_str(), nullptr);
}

void append_point(std::vector<double>& numbers, Vec3 point)
{
    for (const double x : {point.x, point.y, point.z})
        numbers.push_back(six_digits(x));
}

Rgb six_digits(Rgb c)
{
    return by_channel([](double x) { return six_digits(x); }, c);
}

JsonObject transfer_json(const Scene& scene, const Transfer& transfer)
{
    const bool received = Segment::is_patch(transfer.to);
    JsonObject json;
    json.count("from", transfer.from);
    if (received)
        json.count("to", transfer.to);
    else
        json.null("to");
    json.numbers("forecast", six_digits(transfer.forecast));
    json.numbers("held", six_digits(transfer.held));
    const Rgb gain =
        received ? (1.0 / scene.area(transfer.to)) * (scene.reflectance(transfer.to) * transfer.counted) : Rgb{};
    return json.numbers("gain", six_digits(gain));
}

JsonObject line_json(const Scene& scene, const TracedLine& line)
{
    const Vec3 origin = mesh_origin(scene);
    std::vector<double> points;
    for (const Vec3 point : line.points)
        append_point(points, point - origin);
    std::vector<double> crossings;
    for (const Crossing& crossing : line.crossings)
        append_point(crossings, crossing.point - origin);
    const auto json_of = [&](const Transfer& transfer) { return transfer_json(scene, transfer); };
    return JsonObject()
        .numbers("points", points)
        .numbers("joins", {line.joins.begin(), line.joins.end()})
        .numbers("crossings", crossings)
        .objects("transfers", mapped(line.transfers, json_of));
}

/// A chapter of traced lines as the page reads it: every line is a polyline with the transfers of power along its
/// segments. Numbers have six digits: they are shown, not computed with.
JsonObject chapter_json(const Scene& scene, const StageTrace& chapter)
{
    const auto json_of = [&](const TracedLine& line) { return line_json(scene, line); };
    return JsonObject().text("note", join(chapter.context, " ")).objects("lines", mapped(chapter.lines, json_of));
}

/// The mapping of surfaces to their textures (TextureFrame), six numbers each; NaN for a surface without a texture.
/// Empty if the scene has no textures.
std::vector<double> texture_frames(const Scene& scene)
{
    std::vector<double> numbers;
    if (scene.file().textures.empty())
        return numbers;
    for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s) {
        const bool shown = scene.shows_texture(s);
        const TextureFrame frame = shown ? mesh_texture_frame(scene, s) : TextureFrame{};
        for (const TexturePoint& point : {frame.origin, frame.along_u, frame.along_v})
            for (const double x : {point.s, point.t})
                numbers.push_back(shown ? x : std::numeric_limits<double>::quiet_NaN());
    }
    return numbers;
}

JsonObject surfaces_json(const Scene& scene, int threads)
{
    std::vector<std::uint8_t> triangles;
    std::vector<double> geometry;
    std::vector<std::uint32_t> grids;
    std::vector<std::uint32_t> cells; // negative numbers as their two's complement
    std::vector<std::uint32_t> covered;
    const Vec3 origin = mesh_origin(scene);
    for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s) {
        const Surface& surface = scene.surfaces()[s];
        triangles.push_back(surface.shape == Shape::triangle ? 1 : 0);
        for (const Vec3& v : {surface.origin - origin, surface.edge_u, surface.edge_v})
            for (const double x : {v.x, v.y, v.z})
                geometry.push_back(x);
        const Tessellation& cut = scene.tessellation(s);
        grids.insert(grids.end(), {cut.grid_u(), cut.grid_v(), scene.first_patch(s)});
        for (std::uint32_t cell = 0; cell < cut.cell_count(); ++cell) {
            const CellCorners corners = cut.corners(cell);
            const GridPoint first = corners.points[0];
            cells.insert(cells.end(), {first.i, first.j, corners.points[1].i - first.i});
        }
    }
    const std::vector<bool> is_covered = covered_patches(scene, threads);
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        if (is_covered[patch] || scene.is_sky(scene.surface_of(patch))) // the page has its own background
            covered.push_back(patch);
    return JsonObject()
        .numbers("origin", origin)
        .number("size", scene.bounds().diagonal())
        .text("triangles", packed_bytes(triangles))
        .text("geometry", packed_numbers(geometry))
        .text("grids", packed_counts(grids))
        .text("cells", packed_counts(cells))
        .text("materials", packed_counts(scene.file().material))
        .text("groups", packed_counts(scene.file().group))
        .text("lines", packed_counts(scene.file().line))
        .text("texture_frames", packed_numbers(texture_frames(scene)))
        .text("covered", packed_counts(covered));
}

std::vector<JsonObject> materials_json(const Scene& scene)
{
    std::vector<JsonObject> result;
    for (const Material& material : scene.materials()) {
        JsonObject json;
        json.text("name", material.name);
        json.numbers("reflectance", material.reflectance);
        json.numbers("emittance", material.emittance);
        if (material.texture != Material::no_texture) {
            json.count("texture", material.texture);
            json.numbers("white", material.texture_scale);
        }
        result.push_back(json);
    }
    return result;
}

std::vector<JsonObject> textures_json(const Scene& scene)
{
    std::vector<JsonObject> result;
    for (const ImageFile& file : texture_files(scene)) {
        const bool repeats = scene.file().textures[result.size()]->repeats();
        result.push_back(
            JsonObject().text("type", file.type).boolean("repeats", repeats).text("data", base64(file.bytes)));
    }
    return result;
}

JsonObject camera_json(const Camera& camera)
{
    return JsonObject()
        .numbers("eye", camera.eye)
        .numbers("target", camera.target)
        .numbers("up", camera.up)
        .number("field_of_view", camera.field_of_view);
}

/// Tone operator, initial exposure, and the scale from radiosity to the tone curve.
JsonObject tone_json(const Scene& scene, const ViewerContent& content)
{
    const auto* const named =
        std::find_if(tone_operators.begin(), tone_operators.end(),
                     [&](const NamedToneOperator& tone) { return tone.tone == content.tone.tone; });
    return JsonObject()
        .text("curve", named->name)
        .number("scale", picture_scale(scene, content.quantities.front().values, content.camera, content.render,
                                       ToneMapOptions{content.tone.tone}))
        .number("exposure", content.tone.exposure);
}

/// The colour map in 256 steps of sRGB.
std::string packed_colour_map()
{
    std::vector<std::uint8_t> bytes;
    for (int step = 0; step < 256; ++step) {
        const Rgb colour = map_colour(step / 255.0);
        for (const double channel : {colour.r, colour.g, colour.b})
            bytes.push_back(screen_byte(channel));
    }
    return packed_bytes(bytes);
}

/// The legend of a quantity. Its scale reaches at least to the 99th percentile of the values of the patches.
JsonObject legend_json(const std::vector<double>& values)
{
    std::vector<double> sorted;
    std::copy_if(values.begin(), values.end(), std::back_inserter(sorted), [](double x) { return std::isfinite(x); });
    std::sort(sorted.begin(), sorted.end());
    const LegendScale scale = round_scale(sorted.empty() ? 0.0 : sorted[(sorted.size() - 1) * 99 / 100]);
    std::vector<std::string> numbers = serial_list(scale.steps + 1, [&](int step) { return scale.number(step); });
    if (!sorted.empty() && sorted.back() > scale.top())
        numbers.back() += "+";
    return JsonObject().number("top", scale.top()).texts("numbers", numbers);
}

/// [1] Reflectances of the patches, if the scene has textures; without them the materials suffice.
std::string packed_reflectances(const Scene& scene)
{
    std::vector<Rgb> reflectances;
    for (std::uint32_t patch = 0; !scene.file().textures.empty() && patch < scene.patch_count(); ++patch)
        reflectances.push_back(scene.reflectance(patch));
    return packed_colours(reflectances);
}

/// A quantity. Light at the corners of the patches is without the detail of textures.
JsonObject quantity_json(const Scene& scene, const ViewerQuantity& quantity, int threads)
{
    JsonObject json;
    json.text("key", quantity.key).text("title", quantity.title).text("unit", quantity.unit);
    if (quantity.is_light) {
        const CornerValues corners = corner_values(scene, without_texture(scene, quantity.values), threads);
        const PackedLight packed = packed_light(corners.values);
        json.text("values", packed_colours(quantity.values));
        json.text("corners", packed.halves).number("corners_unit", packed.unit);
        json.text("own_places", packed_counts(corners.own_places));
        return json;
    }
    const std::vector<double> means = mapped(quantity.values, [](Rgb value) { return mean(value); });
    json.text("values", packed_numbers(means));
    json.object("legend", legend_json(means));
    return json;
}

/// The JSON document of everything that the page shows (docs/builders/page.md).
std::string room_json(const Scene& scene, const ViewerContent& content)
{
    const auto of_quantity = [&](const ViewerQuantity& q) { return quantity_json(scene, q, content.render.threads); };
    const auto of_chapter = [&](const StageTrace& chapter) { return chapter_json(scene, chapter); };
    return JsonObject()
        .text("scene", scene.path())
        .texts("record", content.record)
        .text("power_unit", light_units(scene.file()).power)
        .boolean("two_sided", scene.two_sided())
        .count("patches", scene.patch_count())
        .object("surfaces", surfaces_json(scene, content.render.threads))
        .objects("materials", materials_json(scene))
        .objects("textures", textures_json(scene))
        .text("reflectances", packed_reflectances(scene))
        .texts("groups", scene.file().groups)
        .object("camera", camera_json(content.camera))
        .object("tone", tone_json(scene, content))
        .text("shading", content.render.shading == Shading::flat ? "flat" : "smooth")
        .text("colour_map", packed_colour_map())
        .objects("quantities", mapped(content.quantities, of_quantity))
        .count("shown", content.shown)
        .objects("trace", mapped(content.chapters, of_chapter))
        .document();
}

/// The lines of src/viewer/page/page.html, with the style sheet and the scripts that it names.
constexpr std::string_view page_lines[] = {
#include "viewer/page_files.inc"
};

/// The title, and one line for each entry of the record, as in a report.
std::string head_of(const Scene& scene, const ViewerContent& content)
{
    std::string text = "<title>" + html_escaped(scene.path()) + " - multipath</title>\n";
    for (const std::string& fact : content.record)
        text += html_record_line(fact);
    return text;
}

/// The element that holds the data. Every '<' is escaped, so that no name in the scene can end the element.
std::string room_element(const Scene& scene, const ViewerContent& content)
{
    std::string text = room_data_begin;
    for (const char c : room_json(scene, content))
        if (c == '<')
            text += "\\u003c";
        else
            text += c;
    return text + room_data_end + "\n";
}

} // namespace

std::string viewer_page(const Scene& scene, const ViewerContent& content)
{
    std::string page;
    for (const std::string_view line : page_lines)
        if (line == "<!-- head -->\n")
            page += head_of(scene, content);
        else if (line == "<!-- room -->\n")
            page += room_element(scene, content);
        else
            page += line;
    return page;
}

} // namespace multipath
