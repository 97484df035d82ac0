#include "radiosity/distribution.h"

#include <algorithm>

namespace multipath {

InputError no_solution(const Scene& scene)
{
    return InputError(scene.path() + ": the equations of line reuse do not converge with these lines; expected more "
                                     "--lines, or --method local");
}

std::vector<Rgb> reflectances(const Scene& scene)
{
    std::vector<Rgb> rho(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        rho[i] = scene.reflectance(i);
    return rho;
}

std::vector<Rgb> unshot_radiosity(const Scene& scene, const PowerState& state)
{
    std::vector<Rgb> unshot(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        unshot[i] = (1.0 / scene.area(i)) * state.unshot[i];
    return unshot;
}

void distribute(const Scene& scene, const Exchange& exchange, const std::vector<Rgb>& radiosity, double share,
                int threads, PowerState& state)
{
    const std::vector<Rgb> received = exchange.apply(radiosity, threads);
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        const double row = exchange.row_area(i);
        const double scale = row > 0.0 ? share * scene.area(i) / row : 0.0;
        const Rgb incident = scale * received[i];
        const Rgb escaped = (scale * exchange.escaping(i)) * radiosity[i];
        const Rgb behind = (scale * exchange.behind(i)) * radiosity[i];
        const Rgb sent = (share * scene.area(i)) * radiosity[i];
        state.incident[i] += incident;
        state.unshot[i] += scene.reflectance(i) * incident - sent;
        state.escaped += escaped;
        state.behind += behind;
        // Counted areas are right on the average only: what arrives everywhere is not quite what was sent.
        state.emitted += incident + escaped + behind - sent;
    }
}

namespace {

/// One channel of it. With H' = max(0, H - mu (1 - rho)) the power absorbed falls as mu grows, convex and piecewise
/// linear: Newton's iteration from mu = 0 comes to its root from below, one piece after another.
void remove_negative_light(const Scene& scene, double Rgb::*channel, PowerState& state)
{
    const auto patches = scene.patch_count();
    double wanted = 0.0; // [W] absorbed
    bool any = false;
    for (std::uint32_t i = 0; i < patches; ++i) {
        wanted += (1.0 - scene.reflectance(i).*channel) * state.incident[i].*channel;
        any = any || state.incident[i].*channel < 0.0;
    }
    if (!any)
        return;
    double mu = 0.0; // [W/m^2]
    constexpr int most_steps = 100;
    for (int step = 0; step < most_steps; ++step) {
        double absorbed = 0.0;
        double slope = 0.0;
        for (std::uint32_t i = 0; i < patches; ++i) {
            const double absorption = 1.0 - scene.reflectance(i).*channel;
            const double left = state.incident[i].*channel - mu * absorption * scene.area(i);
            if (left > 0.0) {
                absorbed += absorption * left;
                slope += absorption * absorption * scene.area(i);
            }
        }
        const double excess = absorbed - wanted;
        if (!(excess > 1e-15 * absorbed) || !(slope > 0.0))
            break;
        mu += excess / slope;
    }
    for (std::uint32_t i = 0; i < patches; ++i) {
        double& incident = state.incident[i].*channel;
        incident = std::max(0.0, incident - mu * (1.0 - scene.reflectance(i).*channel) * scene.area(i));
    }
}

} // namespace

void remove_negative_light(const Scene& scene, PowerState& state)
{
    for (double Rgb::*channel : {&Rgb::r, &Rgb::g, &Rgb::b})
        remove_negative_light(scene, channel, state);
}

} // namespace multipath
