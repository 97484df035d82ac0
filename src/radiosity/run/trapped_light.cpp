// Particles from the sources are reflected again and again, without Russian roulette. A particle carries one bit per
// channel, which is cleared at the first patch that absorbs anything in this channel. A particle that still has a bit
// after very many reflections is trapped.

#include "radiosity/run/trapped_light.h"

#include "base/errors.h"
#include "sampling/random.h"
#include "transport/lines/line_segments.h"
#include "transport/lines/local_rays.h"

#include <algorithm>
#include <vector>

namespace multipath {

namespace {

constexpr std::uint64_t particle_key = random_key(RandomStream::trapped_light);
constexpr std::uint64_t endless_reflections =
    1u << 16; ///< number of reflections without a loss after which light counts as trapped

/// One bit per channel of `colour`, set if the channel is at least `least`.
unsigned channels_of(Rgb colour, double least)
{
    return (colour.r >= least ? 1u : 0u) | (colour.g >= least ? 2u : 0u) | (colour.b >= least ? 4u : 0u);
}

struct Particle
{
    std::uint64_t number;
    std::uint32_t at;  ///< patch
    unsigned channels; ///< bits of the channels in which nothing has been absorbed yet
};

/// Particles that start spread evenly over all source patches; none without sources.
std::vector<Particle> starting_particles(const Scene& scene)
{
    constexpr std::size_t particles = 4096;
    std::vector<std::uint32_t> sources;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        if (scene.first_light(i) != Rgb{})
            sources.push_back(i);
    std::vector<Particle> result;
    for (std::size_t k = 0; k < particles && !sources.empty(); ++k) {
        const std::uint32_t source = sources[k * sources.size() / particles];
        result.push_back({k, source, channels_of(scene.first_light(source), 1e-300)});
    }
    return result;
}

/// Traces one more reflection of every particle, and removes those that have lost light in all channels.
void reflect(const Scene& scene, std::uint64_t depth, RayBlock& rays, std::vector<Particle>& particles)
{
    rays.patches.clear();
    rays.items.clear();
    for (const Particle& particle : particles) {
        Item item;
        for (std::uint64_t i = 0; i < item.size(); ++i)
            item[i] = bits_to_unit(random_bits(random_bits(particle_key, particle.number), item.size() * depth + i));
        rays.patches.push_back(particle.at);
        rays.items.push_back(item);
    }
    rays.trace(scene);
    std::size_t left = 0;
    for (std::size_t k = 0; k < particles.size(); ++k) {
        const std::uint32_t where = rays.receivers[k];
        const unsigned channels =
            Segment::is_patch(where) ? particles[k].channels & channels_of(scene.reflectance(where), 1.0) : 0u;
        if (channels != 0u)
            particles[left++] = {particles[k].number, where, channels};
    }
    particles.resize(left);
}

/// Keeps every other particle, so that they stay evenly spread over the sources.
void halve(std::vector<Particle>& particles)
{
    for (std::size_t k = 0; 2 * k < particles.size(); ++k)
        particles[k] = particles[2 * k];
    particles.resize((particles.size() + 1) / 2);
}

} // namespace

std::optional<std::uint32_t> patch_of_trapped_light(const Scene& scene)
{
    const auto reflects_all = [](const Material& material) { return channels_of(material.reflectance, 1.0) != 0u; };
    if (std::none_of(scene.materials().begin(), scene.materials().end(), reflects_all))
        return std::nullopt;
    std::vector<Particle> particles = starting_particles(scene);
    RayBlock rays;
    for (std::uint64_t depth = 0; depth < endless_reflections && !particles.empty(); ++depth) {
        reflect(scene, depth, rays, particles);
        const bool is_power_of_two = (depth & (depth - 1)) == 0;
        if (depth >= 64 && is_power_of_two) // open spaces have lost most of the light by now
            halve(particles);
    }
    return particles.empty() ? std::nullopt : std::optional(particles.front().at);
}

void require_absorption(const Scene& scene)
{
    const std::optional<std::uint32_t> patch = patch_of_trapped_light(scene);
    if (!patch)
        return;
    throw InputError(scene.path() + ": light is trapped among surfaces that reflect all of it, such as `" +
                         scene.material_of(*patch).name + "`, and has no bound; expected Kd below 1 there",
                     {{Remedy::reflectance_limit, "0.9", "lowers it"}});
}

} // namespace multipath
