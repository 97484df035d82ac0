#include "image/shading/texture_detail.h"

namespace multipath {

namespace {

/// Below this reflectance the irradiance in a channel is unknown; without_texture() uses the mean of the other
/// channels.
constexpr double darkest_texture = 1e-6;

/// [W/m^2] Irradiance; 0 if it is unknown.
double light_on(double reflected, double reflectance)
{
    return reflectance > darkest_texture ? reflected / reflectance : 0.0;
}

} // namespace

std::vector<Rgb> without_texture(const Scene& scene, std::vector<Rgb> radiosity)
{
    if (scene.file().textures.empty())
        return radiosity;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        if (!scene.is_textured(scene.surface_of(i)))
            continue;
        const Rgb rho = scene.reflectance(i);
        const Rgb reflected = radiosity[i] - scene.emittance(i);
        Rgb light = {light_on(reflected.r, rho.r), light_on(reflected.g, rho.g), light_on(reflected.b, rho.b)};
        const double known = (rho.r > darkest_texture ? 1.0 : 0.0) + (rho.g > darkest_texture ? 1.0 : 0.0) +
                             (rho.b > darkest_texture ? 1.0 : 0.0);
        const double usual = known > 0.0 ? (light.r + light.g + light.b) / known : 0.0;
        light = {rho.r > darkest_texture ? light.r : usual, rho.g > darkest_texture ? light.g : usual,
                 rho.b > darkest_texture ? light.b : usual};
        radiosity[i] = scene.emittance(i) + scene.material_of(i).reflectance * light;
    }
    return radiosity;
}

Rgb with_texture(const Scene& scene, const Hit& hit, Rgb plain)
{
    if (scene.file().textures.empty() || !scene.is_textured(hit.surface))
        return plain;
    const Material& material = scene.surface_material(hit.surface);
    const Rgb emitted = hit.front ? material.emittance : Rgb{};
    const Rgb reflected = plain - emitted;
    const Rgb mean = material.reflectance;
    const Rgb light = {light_on(reflected.r, mean.r), light_on(reflected.g, mean.g), light_on(reflected.b, mean.b)};
    return emitted + scene.reflectance_at(hit.surface, hit.u, hit.v) * light;
}

} // namespace multipath
