#include "exam/agreement_questions.h"

#include "exam/method_questions.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace multipath {

namespace {

constexpr std::size_t most_materials = 4;
constexpr const char* sequence_name = "sobol-owen";
constexpr double finest_miss = 0.25; ///< [1] scenes may be hard; what is off by so much must be caught

using Channel = double Rgb::*;
struct NamedChannel
{
    const char* name;
    Channel channel;
};

/// Those that differ: one of a grey scene.
std::vector<NamedChannel> channels_of(const Scene& scene)
{
    const auto is_grey = [](Rgb c) { return c.r == c.g && c.g == c.b; };
    const std::vector<Material>& materials = scene.materials();
    if (std::all_of(materials.begin(), materials.end(),
                    [&](const Material& m) { return is_grey(m.reflectance) && is_grey(m.emittance); }))
        return {{"grey", &Rgb::g}};
    return {{"red", &Rgb::r}, {"green", &Rgb::g}, {"blue", &Rgb::b}};
}

/// The power that the patches of each material reflect [W].
std::vector<Rgb> reflected_power(const Scene& scene, const Solution& solution)
{
    std::vector<Rgb> power(scene.materials().size());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        power[scene.file().material[scene.surface_of(i)]] +=
            scene.area(i) * (solution.radiosity[i] - scene.emittance(i));
    return power;
}

/// Those that reflect most, so that their light tells most.
std::vector<std::size_t> brightest_materials(const Scene& scene, const std::vector<Solution>& runs)
{
    std::vector<Rgb> power(scene.materials().size());
    for (const Solution& run : runs) {
        const std::vector<Rgb> part = reflected_power(scene, run);
        for (std::size_t m = 0; m < power.size(); ++m)
            power[m] += part[m];
    }
    std::vector<std::size_t> order;
    for (std::size_t m = 0; m < power.size(); ++m)
        if (mean(power[m]) > 0.0)
            order.push_back(m);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return mean(power[a]) > mean(power[b]); });
    order.resize(std::min(order.size(), most_materials));
    return order;
}

/// What the light left unshot would still add to a material: as if it spread evenly over the scene, twice to be safe.
double missing_power(const Scene& scene, std::size_t material, double unshot, Channel channel)
{
    double area = 0.0;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        area += scene.file().material[scene.surface_of(i)] == material ? scene.area(i) : 0.0;
    const double absorbed = std::max(0.01, 1.0 - scene.average_reflectance().*channel);
    return 2.0 * unshot * scene.materials()[material].reflectance.*channel * area / scene.total_area() / absorbed;
}

ExamRow material_row(const Scene& scene, const NamedMethod& method, std::size_t material, const NamedChannel& colour,
                     const std::vector<Solution>& runs)
{
    std::vector<double> samples;
    for (const Solution& run : runs)
        samples.push_back(reflected_power(scene, run)[material].*colour.channel);
    ExamRow row = {"agreement", method.name, sequence_name,
                   scene.materials()[material].name + ", " + colour.name + " [W]"};
    row.allowance = missing_power(scene, material, mean_unshot(runs, method.method), colour.channel);
    return measured_by(row, samples);
}

/// No patch reflects less than nothing. Where noise makes the exchange of two patches negative, one run can say so; the
/// mean of all runs may, by up to 6 standard errors.
ExamRow reflected_row(const Scene& scene, const NamedMethod& method, const std::vector<Solution>& runs)
{
    double least = 0.0;
    double most = 0.0;
    std::vector<double> samples(runs.size());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        for (const NamedChannel& colour : channels_of(scene)) {
            for (std::size_t run = 0; run < runs.size(); ++run)
                samples[run] = (runs[run].radiosity[i] - scene.emittance(i)).*colour.channel;
            const ExamRow reflected = measured_by({"", "", sequence_name, ""}, samples);
            least = std::min(least, reflected.measured + 6.0 * reflected.standard_error);
            most = std::max(most, reflected.measured);
        }
    ExamRow row = {"power", method.name, sequence_name, "least B - E, or 0 [W/m^2]", 0.0, least};
    row.allowance = 1e-6 * most;
    row.resolution = row.allowance;
    return row;
}

ExamRow emitted_row(const Scene& scene, const NamedMethod& method, const std::vector<Solution>& runs)
{
    std::vector<double> samples;
    for (const Solution& run : runs)
        samples.push_back(mean(run.balance.emitted));
    ExamRow row = {"power", method.name, sequence_name, "emitted [W]", mean(scene.source_power())};
    row.allowance = 1e-9 * row.expected;
    row.resolution = finest_miss * row.expected;
    return measured_by(row, samples);
}

std::vector<ExamRow> examine_methods(const Scene& scene, const ExamSettings& settings)
{
    std::vector<ExamRow> rows;
    std::vector<std::size_t> materials;
    std::vector<ExamRow> local; // of all materials and channels
    for (const NamedMethod& method : exam_methods) {
        const std::vector<Solution> runs =
            solved_runs(scene, preparation_for(scene, method.method), method.method, sequence_name, settings);
        if (method.method == Method::local)
            materials = brightest_materials(scene, runs);
        std::vector<ExamRow> found;
        for (const std::size_t material : materials)
            for (const NamedChannel& colour : channels_of(scene))
                if (scene.materials()[material].reflectance.*colour.channel > 0.0)
                    found.push_back(material_row(scene, method, material, colour, runs));
        rows.push_back(balance_row("power", method.name, runs));
        rows.push_back(emitted_row(scene, method, runs));
        rows.push_back(reflected_row(scene, method, runs));
        if (method.method == Method::local)
            local = found;
        else
            for (std::size_t k = 0; k < found.size(); ++k) {
                found[k].resolution = finest_miss * local[k].measured;
                rows.push_back(compared_with(found[k], local[k]));
            }
    }
    return rows;
}

} // namespace

std::vector<ExamTask> agreement_tasks(const Scene& scene, const ExamSettings& settings)
{
    return {{"methods", [&scene, settings] { return examine_methods(scene, settings); }}};
}

} // namespace multipath
