#include "base/lists.h"
#include "base/text_format.h"
#include "check/scene_check.h"
#include "check/scene_report.h"
#include "cli/files/standard_streams.h"
#include "cli/options/number_text.h"
#include "commands/commands.h"
#include "commands/options/scene_options.h"
#include "export/json.h"
#include "scene/scene_file.h"

#include <algorithm>

namespace multipath {

namespace {

/// The emission of a scene by one material.
struct Emitter
{
    const Material* material;
    double area = 0.0; ///< [m^2]

    Rgb power() const { return area * material->emittance; }
};

std::vector<Emitter> emitters(const Scene& scene)
{
    auto result = mapped(scene.materials(), [](const Material& material) { return Emitter{&material}; });
    for (std::size_t s = 0; s < scene.surfaces().size(); ++s)
        result[scene.file().material[s]].area += scene.surfaces()[s].area();
    const auto dark = [](const Emitter& e) { return e.material->emittance == Rgb{} || e.area == 0.0; };
    result.erase(std::remove_if(result.begin(), result.end(), dark), result.end());
    return result;
}

/// "27 W (28, 27, 26)"
std::string power_text(Rgb power, const SceneFile& scene, int digits)
{
    return format("%.*g %s ", digits, mean(power), light_units(scene).power) + triple(power.r, power.g, power.b, 4);
}

std::string materials_text(const Scene& scene)
{
    std::vector<double> area(scene.materials().size(), 0.0);
    for (std::uint32_t s = 0; s < scene.own_surfaces(); ++s)
        area[scene.file().material[s]] += scene.surfaces()[s].area();
    std::string text;
    for (std::size_t m = 0; m < area.size(); ++m) {
        const Rgb rho = scene.materials()[m].reflectance;
        if (area[m] > 0.0)
            text += format("  %-20s reflectance %-26s %10.4g m^2\n", scene.materials()[m].name.c_str(),
                           triple(rho.r, rho.g, rho.b, 4).c_str(), area[m]);
    }
    return text;
}

std::string emitters_text(const Scene& scene)
{
    std::string text;
    for (const Emitter& e : emitters(scene))
        text += format("  %-20s %s from %.4g m^2\n", e.material->name.c_str(),
                       power_text(e.power(), scene.file(), 5).c_str(), e.area);
    if (const std::optional<Sun>& sun = scene.file().sun)
        text += format("  %-20s %s arrive from ", "the sun", power_text(scene.sun_power(), scene.file(), 5).c_str()) +
                triple(sun->direction.x, sun->direction.y, sun->direction.z, 3) + "\n";
    return text;
}

std::string ratio_text(const std::optional<double>& ratio)
{
    return ratio ? format("%.4f", *ratio) : "-";
}

std::string figures_text(const Scene& scene, const SceneReport& r)
{
    std::string text;
    text += format("  R_ave  mean reflectance          %.4f\n", r.figures.average_reflectance);
    text += "  Phi_T  power of the sources      " + power_text(scene.source_power(), scene.file(), 6) + "\n";
    text += format("  n_int  crossings of a line       %.4f (measured %.4f)\n", r.figures.intersections,
                   r.intersections_measured);
    text += format("  f      share of the area lit     %.4f visible\n", r.direct.lit_fraction);
    text += format("  R_s'   reflectance of lit area   %.4f\n", r.direct.secondary_reflectance);
    text += "  (3)    N_l / N_g                 " + ratio_text(r.ratio_first_shot) + " first shot, " +
            ratio_text(r.ratio_extended) + " extended" +
            (r.ratio_first_shot ? "\n" : " (no light falls on reflecting surfaces: any ratio will do)\n");
    text += format("  (4)    threshold                 %.6g %s\n", r.threshold_radiosity,
                   light_units(scene.file()).per_area);
    if (!r.trapped)
        text += format("  power  in a trial run            %.4g %% escapes, %.4g %% is lost behind surfaces\n",
                       100.0 * mean(r.balance.escaped) / mean(r.balance.emitted),
                       100.0 * mean(r.balance.behind) / mean(r.balance.emitted));
    return text;
}

std::string report_text(const Scene& scene, const SceneReport& report, const std::vector<Finding>& findings)
{
    const Vec3 low = scene.own_bounds().low;
    const Vec3 high = scene.own_bounds().high;
    std::string text = scene.path() + ": " + scene.file().counts + "\n";
    const int digits = coordinate_digits(scene.own_bounds(), 5);
    text += format("\nsize: %.5g x %.5g x %.5g m from ", high.x - low.x, high.y - low.y, high.z - low.z) +
            triple(low.x, low.y, low.z, digits) + " to " + triple(high.x, high.y, high.z, digits) + "\n";
    text += format("area: %.6g m^2 in %s patches of at most %.4g; bounding box %.6g m^2\n", scene.own_area(),
                   grouped(scene.patch_count()).c_str(), scene.patch_size(), scene.own_bounds().area());
    text += "\nmaterials:\n" + materials_text(scene);
    text += "\nemitters:\n" + emitters_text(scene);
    text += "\nfigures:\n" + figures_text(scene, report);
    text += findings.empty() ? "\nnothing suspicious found\n" : "\nfindings:\n";
    for (const Finding& finding : findings)
        text += (finding.makes_wrong_result ? "  WRONG  " : "  note   ") + finding.place + ": " + finding.message +
                advice_text(finding.advice) + "\n";
    return text;
}

JsonObject report_json(const Scene& scene, const SceneReport& r, const std::vector<Finding>& findings)
{
    JsonObject json;
    json.text("scene", scene.path());
    json.count("surfaces", scene.own_surfaces());
    json.count("patches", scene.patch_count());
    json.number("patch_size", scene.patch_size());
    json.numbers("bounds_low", scene.own_bounds().low);
    json.numbers("bounds_high", scene.own_bounds().high);
    json.number("area_m2", scene.own_area());
    json.number("box_area_m2", scene.own_bounds().area());
    json.number("average_reflectance", r.figures.average_reflectance);
    json.numbers("average_reflectance_rgb", scene.average_reflectance());
    json.number("source_power_w", mean(scene.source_power()));
    json.numbers("source_power_rgb_w", scene.source_power());
    json.number("intersections", r.figures.intersections);
    json.number("intersections_measured", r.intersections_measured);
    json.number("lit_fraction", r.direct.lit_fraction);
    json.number("secondary_reflectance", r.direct.secondary_reflectance);
    json.number("ratio_first_shot", r.ratio_first_shot);
    json.number("ratio_extended", r.ratio_extended);
    json.number("threshold_radiosity", r.threshold_radiosity);
    json.number("escaped_share", mean(r.balance.escaped) / mean(r.balance.emitted));
    json.number("back_face_share", mean(r.balance.behind) / mean(r.balance.emitted));

    json.objects("emitters", mapped(emitters(scene), [](const Emitter& e) {
                     return JsonObject()
                         .text("material", e.material->name)
                         .number("power_w", mean(e.power()))
                         .numbers("power_rgb_w", e.power())
                         .number("area_m2", e.area);
                 }));
    json.objects("findings", mapped(findings, [](const Finding& finding) {
                     return JsonObject()
                         .text("kind", finding.kind)
                         .boolean("makes_wrong_result", finding.makes_wrong_result)
                         .text("place", finding.place)
                         .text("message", finding.message + advice_text(finding.advice))
                         .number("power_share", finding.power_share)
                         .number("area_share", finding.area_share);
                 }));
    return json;
}

int run_check(const CommandLine& line)
{
    const std::uint64_t lines = read_count("--lines", line.text("lines"), 1000, std::uint64_t{1} << 40);
    const int threads = thread_count(line);
    const Scene scene = read_scene(line, threads);
    const SceneReport report = report_on(scene, lines, threads);
    const std::vector<Finding> findings = findings_of(scene, report);
    const std::string text =
        line.has("json") ? report_json(scene, report, findings).document() : report_text(scene, report, findings);
    print(text);
    const bool wrong =
        std::any_of(findings.begin(), findings.end(), [](const Finding& f) { return f.makes_wrong_result; });
    return wrong ? 1 : 0;
}

} // namespace

Command check_command()
{
    return {{"check",
             "report the content of a scene, the paper's figures for it, and its faults",
             {"SCENE.obj", 1, 1},
             {{"Report",
               {{"json", 0, "", "", "Print the report as JSON on standard output."},
                {"lines", 'n', "N", "2^20",
                 "Number of lines for each measured figure; fewer are cast if they meet very many surfaces."},
                threads_option()}},
              scene_option_group()},
             "A finding is WRONG if it concerns at least 0.5 % of the power of the sources, or of the area, and a note "
             "otherwise, or if it does not make the result wrong. The most severe come first.\n\n"
             "Exit code 0: nothing is WRONG; 1: something is, or the scene cannot be read."},
            run_check};
}

} // namespace multipath
