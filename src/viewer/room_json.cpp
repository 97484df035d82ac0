#include "viewer/room_json.h"

#include "export/covered_patches.h"
#include "export/json.h"
#include "image/colour_map.h"
#include "image/legend.h"
#include "image/picture.h"
#include "image/srgb.h"
#include "viewer/corner_values.h"
#include "viewer/packed_values.h"
#include "viewer/story_json.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace multipath {

namespace {

std::vector<double> coordinates(Vec3 v)
{
    return {v.x, v.y, v.z};
}

std::vector<double> channels(Rgb c)
{
    return {c.r, c.g, c.b};
}

JsonObject surfaces_json(const Scene& scene, int threads)
{
    std::vector<std::uint8_t> triangles;
    std::vector<double> geometry;
    std::vector<std::uint32_t> cells;
    std::vector<std::uint32_t> covered;
    for (std::uint32_t s = 0; s < scene.surfaces().size(); ++s) {
        const Surface& surface = scene.surfaces()[s];
        triangles.push_back(surface.shape == Shape::triangle ? 1 : 0);
        for (const Vec3& v : {surface.origin, surface.edge_u, surface.edge_v})
            for (const double x : {v.x, v.y, v.z})
                geometry.push_back(x);
        cells.push_back(scene.tessellation(s).cells_u);
        cells.push_back(scene.tessellation(s).cells_v);
    }
    const std::vector<bool> is_covered = covered_patches(scene, threads);
    for (std::uint32_t patch = 0; patch < scene.patch_count(); ++patch)
        if (is_covered[patch])
            covered.push_back(patch);
    JsonObject json;
    json.text("triangles", packed_bytes(triangles));
    json.text("geometry", packed_numbers(geometry));
    json.text("cells", packed_counts(cells));
    json.text("materials", packed_counts(scene.file().material));
    json.text("groups", packed_counts(scene.file().group));
    json.text("lines", packed_counts(scene.file().line));
    json.text("covered", packed_counts(covered));
    return json;
}

std::vector<JsonObject> materials_json(const Scene& scene)
{
    std::vector<JsonObject> result;
    for (const Material& material : scene.materials()) {
        JsonObject json;
        json.text("name", material.name);
        json.numbers("reflectance", channels(material.reflectance));
        json.numbers("emittance", channels(material.emittance));
        result.push_back(json);
    }
    return result;
}

JsonObject camera_json(const Camera& camera)
{
    JsonObject json;
    json.numbers("eye", coordinates(camera.eye));
    json.numbers("target", coordinates(camera.target));
    json.numbers("up", coordinates(camera.up));
    json.number("field_of_view", camera.field_of_view);
    return json;
}

/// The exposure of the picture of the first view, for every operator.
JsonObject tone_json(const Scene& scene, const ViewerContent& content)
{
    JsonObject scales;
    JsonObject json;
    for (const NamedToneOperator& named : tone_operators) {
        scales.number(named.name, picture_scale(scene, content.quantities.front().values, content.camera,
                                                content.render, ToneMapOptions{named.tone}));
        if (named.tone == content.tone.tone)
            json.text("first", named.name);
    }
    json.object("scales", scales);
    json.number("exposure", content.tone.exposure);
    return json;
}

/// The colour map in 256 steps, as a screen shows it.
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

/// Reaches to the 99th percentile of the patches, as false-colour pictures do of what they show.
JsonObject legend_json(const std::vector<double>& values)
{
    std::vector<double> sorted;
    std::copy_if(values.begin(), values.end(), std::back_inserter(sorted), [](double x) { return std::isfinite(x); });
    std::sort(sorted.begin(), sorted.end());
    const LegendScale scale = round_scale(sorted.empty() ? 0.0 : sorted[(sorted.size() - 1) * 99 / 100]);
    std::vector<std::string> numbers;
    for (int step = 0; step <= scale.steps; ++step)
        numbers.push_back(scale.number(step));
    if (!sorted.empty() && sorted.back() > scale.top())
        numbers.back() += "+";
    JsonObject json;
    json.number("top", scale.top());
    json.texts("numbers", numbers);
    return json;
}

/// Coarse light, as good as a screen.
void add_light(JsonObject& json, const std::string& key, const std::vector<Rgb>& values)
{
    const PackedLight packed = packed_light(values);
    json.text(key, packed.words);
    json.number(key + "_unit", packed.unit);
}

/// At the corners of the patches; own values stand behind the shared ones, so that they have one unit.
void add_corners(JsonObject& json, const Scene& scene, const std::vector<Rgb>& values, int threads)
{
    CornerValues corners = corner_values(scene, values, threads);
    corners.shared.insert(corners.shared.end(), corners.own.begin(), corners.own.end());
    add_light(json, "corners", corners.shared);
    json.text("own_places", packed_counts(corners.places));
}

/// The values of the first quantity are the result itself, and given in full.
JsonObject quantity_json(const Scene& scene, const ViewerQuantity& quantity, bool first, int threads)
{
    JsonObject json;
    json.text("key", quantity.key);
    json.text("title", quantity.title);
    json.text("unit", quantity.unit);
    if (quantity.colours == ViewerColours::light) {
        if (first)
            json.text("values", packed_colours(quantity.values));
        else
            add_light(json, "light", quantity.values);
        add_corners(json, scene, quantity.values, threads);
        return json;
    }
    std::vector<double> means;
    for (const Rgb& value : quantity.values)
        means.push_back(mean(value));
    json.text("means", packed_numbers(means));
    json.object("legend", legend_json(means));
    return json;
}

std::vector<JsonObject> stages_json(const Scene& scene, const ViewerContent& content)
{
    std::vector<JsonObject> result;
    for (const ViewerStage& stage : content.stages) {
        JsonObject json;
        json.count("lines", stage.lines);
        add_light(json, "light", stage.radiosity);
        add_corners(json, scene, stage.radiosity, content.render.threads);
        result.push_back(json);
    }
    return result;
}

} // namespace

std::string room_json(const Scene& scene, const ViewerContent& content)
{
    std::vector<JsonObject> quantities;
    for (const ViewerQuantity& quantity : content.quantities)
        quantities.push_back(quantity_json(scene, quantity, quantities.empty(), content.render.threads));
    std::vector<JsonObject> chapters;
    for (const ViewerChapter& chapter : content.chapters)
        chapters.push_back(story_json(chapter));
    JsonObject json;
    json.text("scene", scene.path());
    json.texts("record", content.record);
    json.boolean("two_sided", scene.two_sided());
    json.count("patches", scene.patch_count());
    json.object("surfaces", surfaces_json(scene, content.render.threads));
    json.objects("materials", materials_json(scene));
    json.texts("groups", scene.file().groups);
    json.object("camera", camera_json(content.camera));
    json.object("tone", tone_json(scene, content));
    json.text("shading", content.render.shading == Shading::flat ? "flat" : "smooth");
    json.text("colour_map", packed_colour_map());
    json.objects("quantities", quantities);
    json.count("shown", content.shown);
    json.count("lines", content.lines);
    json.objects("stages", stages_json(scene, content));
    json.objects("story", chapters);
    return json.document();
}

} // namespace multipath
