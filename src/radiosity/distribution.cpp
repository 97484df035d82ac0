#include "radiosity/distribution.h"

namespace multipath {

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

} // namespace multipath
