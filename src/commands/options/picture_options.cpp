#include "commands/options/picture_options.h"

#include "base/errors.h"
#include "base/file_bytes.h"
#include "base/text_format.h"
#include "cli/options/number_text.h"
#include "image/automatic_camera.h"
#include "image/camera_file.h"
#include "image/false_colour.h"
#include "radiosity/reuse/gathered_light.h"

#include <array>

namespace multipath {

namespace {

constexpr std::array<NamedValue<Shading>, 3> shading_choices = {
    {{"smooth", Shading::smooth}, {"flat", Shading::flat}, {"gather", Shading::gather}}};

constexpr std::array known_quantities = {
    ShownQuantity{"radiosity", "the room as an eye would see it", ShownAs::room, "radiosity", true, false, false,
                  [](const Scene&, const Solution& solution, int) { return solution.radiosity; }},
    ShownQuantity{"direct", "the same with light that was reflected only once", ShownAs::directly_lit_room,
                  "direct radiosity", true, false, false,
                  [](const Scene& scene, const Solution&, int threads) { return direct_radiosity(scene, threads); }},
    ShownQuantity{
        "irradiance", "in false colours with a legend and lines of equal values", ShownAs::false_colours, "irradiance",
        true, false, true,
        [](const Scene& scene, const Solution& solution, int) { return irradiance(scene, solution.radiosity); }},
    ShownQuantity{"error",
                  "in false colours, the standard error of the radiosity, which needs --replicates or --tolerance",
                  ShownAs::false_colours, "standard error of the radiosity", true, true, false,
                  [](const Scene&, const Solution& solution, int) { return solution.standard_error; }},
    ShownQuantity{"unshot", "in false colours, the radiosity that has not been sent on", ShownAs::false_colours,
                  "unshot radiosity", false, false, false,
                  [](const Scene&, const Solution& solution, int) { return magnitudes(solution.unshot); }},
    ShownQuantity{"patches", "each in its own colour", ShownAs::light_of_screen, "patches", false, false, false,
                  [](const Scene& scene, const Solution&, int) { return patch_colours(scene.patch_count()); }},
    ShownQuantity{"normals", "0.5 + 0.5 n as red, green and blue", ShownAs::light_of_screen, "normals", false, false,
                  false, [](const Scene& scene, const Solution&, int) { return normal_colours(scene); }}};

std::string help_of_shown()
{
    std::string text;
    for (const ShownQuantity& shown : known_quantities)
        text.append(text.empty() ? "Content of pictures: " : "; ").append(shown.name).append(", ").append(shown.help);
    return text + ". A PFM holds the values. Meshes always hold the radiosity.";
}

ShownQuantity read_shown(const CommandLine& line)
{
    const ShownQuantity shown = line.choice("show", known_quantities);
    for (const std::string option : {"shading", "exposure", "tone-map"})
        if (!shown.is_room() && line.has(option) && line.text(option) != "flat")
            throw UsageError("--" + option + " has no effect with --show " + std::string(shown.name));
    return shown;
}

std::vector<View> read_views(const CommandLine& line)
{
    for (const char* other : {"eye", "target", "up", "fov"})
        if (line.has(other))
            throw UsageError("--camera and --" + std::string(other) + " exclude each other; expected one of them");
    std::vector<View> views;
    for (const std::string& path : line.all("camera")) {
        const Camera camera = read_camera_file(path);
        const std::string name = path_of(path).stem().u8string();
        for (const View& other : views)
            if (other.name == name)
                throw UsageError("--camera: two views are called '" + name + "'; expected files of different names");
        views.push_back({name, camera.eye, camera.target, camera.field_of_view, camera.up});
    }
    return views;
}

/// Reads "HEIGHT,STEP", such as "0.85,0.5".
GridPlan read_grid(const std::string& text, Vec3 up)
{
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos)
        throw UsageError("--grid: expected a height and a step such as 0.85,0.5, got " + quoted_argument(text));
    return {read_real("--grid, height", text.substr(0, comma), -1e9, 1e9),
            read_positive("--grid, step", text.substr(comma + 1)), up};
}

} // namespace

std::vector<ShownQuantity> shown_quantities()
{
    return {known_quantities.begin(), known_quantities.end()};
}

OptionGroup picture_option_group()
{
    return {
        "Picture",
        {{"show", 0, "WHAT", known_quantities.front().name, help_of_shown(), false, names_of(known_quantities)},
         {"size", 0, "WxH", "800x600", "Width and height in pixels."},
         {"samples", 0, "N", "9", "Rays per pixel for smooth edges, rounded up to a square number."},
         {"shading", 0, "HOW", "smooth",
          "Interpolate between patches, show each in one colour, or compute the last reflection for every pixel "
          "(gather): slow, but with sharp shadows.",
          false, names_of(shading_choices)},
         {"gather-rays", 0, "N", "64",
          "For --shading gather: rays per pixel in all directions, and half as many as to the sources."},
         {"camera", 0, "FILE.json", "",
          "View that the page has saved. Several give several pictures: room-door.png for door.json.", true},
         {"eye", 0, "X,Y,Z", "", "Position of the camera; by default it shows most of the lit parts of the room."},
         {"target", 0, "X,Y,Z", "", "Point that the camera looks at; by default the centre, or chosen with the eye."},
         {"up", 0, "X,Y,Z", "0,1,0", "Upward direction."},
         {"fov", 0, "DEGREES", "", "Vertical field of view; by default 60, or chosen with the eye."},
         {"grid", 0, "HEIGHT,STEP", "",
          "Write into .csv files the irradiance from above on a horizontal grid, at a height above the lowest point of "
          "the scene, with a distance between its points, in metres. Also prints its statistics."},
         {"exposure", 0, "STOPS", "0", "Brighter (1 = twice) or darker (-1 = half) than the automatic exposure."},
         {"tone-map", 0, "HOW", "reinhard", "Tone curve from radiosity to screen brightness.", false,
          names_of(tone_operators)}}};
}

PictureOptions read_picture_options(const CommandLine& line, int threads)
{
    PictureOptions options;
    options.shown = read_shown(line);
    const PixelSize size = read_pixel_size("--size", line.text("size"), largest_picture_side);
    options.render.width = size.width;
    options.render.height = size.height;
    options.render.samples_per_pixel = static_cast<int>(read_count("--samples", line.text("samples"), 1, 4096));
    const Shading shading = line.choice("shading", shading_choices).value;
    options.render.shading = options.shown.is_room() ? shading : Shading::flat;
    options.render.indirect = options.shown.as != ShownAs::directly_lit_room;
    options.mesh_shading = shading == Shading::flat ? Shading::flat : Shading::smooth;
    if (line.text("gather-rays") != line.default_text("gather-rays") && options.render.shading != Shading::gather)
        throw UsageError("--gather-rays has no effect without --shading gather; expected both");
    options.render.gather_rays = static_cast<int>(read_count("--gather-rays", line.text("gather-rays"), 1, 1 << 20));
    options.render.threads = threads;
    options.tone.tone = line.choice("tone-map", tone_operators).tone;
    options.tone.exposure = read_real("--exposure", line.text("exposure"), -60.0, 60.0);
    View& view = options.views.front();
    view.up = read_direction("--up", line.text("up"));
    if (line.has("eye"))
        view.eye = read_vec3("--eye", line.text("eye"));
    if (line.has("target"))
        view.target = read_vec3("--target", line.text("target"));
    if (line.has("fov"))
        view.field_of_view = read_real("--fov", line.text("fov"), 1.0, 179.0);
    if (line.has("grid"))
        options.grid = read_grid(line.text("grid"), view.up);
    if (line.has("camera"))
        options.views = read_views(line);
    return options;
}

void require_view(const Scene& scene, const PictureOptions& options)
{
    for (const View& view : options.views)
        if (view.eye || view.target)
            PixelRays(camera_for(scene, options, view), options.render.width, options.render.height);
}

Camera camera_for(const Scene& scene, const PictureOptions& options, const View& view,
                  const std::vector<Rgb>& radiosity)
{
    Camera camera;
    if (view.eye) {
        camera.eye = *view.eye;
        camera.target = scene.own_bounds().centre();
        camera.up = view.up;
    } else {
        const double aspect = static_cast<double>(options.render.width) / options.render.height;
        camera = automatic_camera(scene, aspect, view.up, radiosity);
    }
    camera.target = view.target.value_or(camera.target);
    camera.field_of_view = view.field_of_view.value_or(camera.field_of_view);
    return camera;
}

PictureOptions with_camera(PictureOptions options, const Scene& scene, const std::vector<Rgb>& radiosity)
{
    for (View& view : options.views) {
        const Camera camera = camera_for(scene, options, view, radiosity);
        view = {view.name, camera.eye, camera.target, camera.field_of_view, view.up};
    }
    return options;
}

} // namespace multipath
