#include "radiosity/paper/power_state.h"

#include "base/elementary.h"
#include "base/memory.h"

#include <algorithm>
#include <cmath>

namespace multipath {

double PowerBalance::relative_error() const
{
    const Rgb found = absorbed + unshot + escaped + behind;
    const auto channel = [](double sent, double arrived, double nominal) {
        const double scale = std::max(std::abs(sent), nominal);
        return scale == 0.0 ? std::abs(arrived) : std::abs(sent - arrived) / scale;
    };
    const Rgb error = by_channel(channel, emitted, found, source);
    return std::max({error.r, error.g, error.b});
}

PowerState::PowerState(const Scene& scene)
    : incident(vector_with_capacity<Rgb>(scene.patch_count())), unshot(vector_with_capacity<Rgb>(scene.patch_count()))
{
    incident.resize(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        incident[i] = scene.area(i) * scene.sunlight(i);
        unshot.push_back(scene.area(i) * scene.first_light(i));
        emitted += incident[i] + scene.area(i) * scene.emittance(i);
    }
}

PowerState PowerState::empty(const Scene& scene)
{
    PowerState state(scene);
    state.incident.assign(scene.patch_count(), Rgb{});
    state.unshot.assign(scene.patch_count(), Rgb{});
    state.emitted = {};
    return state;
}

void PowerState::visit(Archive& archive)
{
    archive.list<double>("incident", incident);
    archive.list<double>("unshot", unshot);
    archive.value<double>("emitted", emitted);
    archive.value<double>("escaped", escaped);
    archive.value<double>("behind", behind);
    archive.value<double>("surplus", surplus);
    archive.value<double>("emitted variance", emitted_variance);
}

void settle_losses(Rgb sources, Rgb absorbed, Rgb escaped, Rgb behind, PowerState& state)
{
    const Rgb found = absorbed + escaped + behind;
    const auto share = [](double source, double sum) { return sum > 0.0 ? source / sum : 0.0; };
    const auto rest = [](double source, double sum) { return sum > 0.0 ? 0.0 : source; };
    const Rgb factor = by_channel(share, sources, found);
    state.surplus += absorbed - factor * absorbed;
    state.escaped += factor * escaped;
    state.behind += factor * behind;
    state.unshot.front() += by_channel(rest, sources, found);
}

void add(const PowerBalance& part, double share, PowerBalance& sum)
{
    for (Rgb PowerBalance::*power : {&PowerBalance::emitted, &PowerBalance::absorbed, &PowerBalance::unshot,
                                     &PowerBalance::escaped, &PowerBalance::behind, &PowerBalance::source})
        sum.*power += share * part.*power;
    sum.emitted_error = elementary::hypot(sum.emitted_error, share * part.emitted_error);
}

PowerBalance power_balance(const Scene& scene, const PowerState& state)
{
    PowerBalance balance;
    balance.emitted = state.emitted;
    balance.emitted_error = std::sqrt(state.emitted_variance);
    balance.source = scene.source_power();
    balance.behind = state.behind;
    Rgb at_sky;
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i) {
        Rgb& where = scene.is_sky_patch(i) ? at_sky : balance.absorbed;
        where += (Rgb{1.0, 1.0, 1.0} - scene.reflectance(i)) * state.incident[i];
        balance.unshot += state.unshot[i];
    }
    Rgb noise = state.surplus; // of what arrives anywhere
    for (double Rgb::*c : {&Rgb::r, &Rgb::g, &Rgb::b})
        if (balance.unshot.*c < 0.0) { // the residual of a linear system
            noise.*c -= balance.unshot.*c;
            balance.unshot.*c = 0.0;
        }
    const Rgb share = at_sky == Rgb{} ? Rgb{1.0, 1.0, 1.0} : quotient(balance.absorbed, balance.absorbed + at_sky);
    balance.absorbed = balance.absorbed - share * noise;
    balance.escaped = state.escaped + at_sky - (Rgb{1.0, 1.0, 1.0} - share) * noise;
    for (double Rgb::*c : {&Rgb::r, &Rgb::g, &Rgb::b})
        if (const double lost = balance.escaped.*c + balance.behind.*c; balance.absorbed.*c < 0.0 && lost > 0.0) {
            // Few paths may end with more light of a colour than they absorb on the average.
            const double scale = std::max(0.0, 1.0 + balance.absorbed.*c / lost);
            balance.escaped.*c *= scale;
            balance.behind.*c *= scale;
            balance.absorbed.*c += (1.0 - scale) * lost;
        }
    return balance;
}

std::vector<Rgb> radiosity(const Scene& scene, const PowerState& state)
{
    std::vector<Rgb> result = vector_with_capacity<Rgb>(scene.patch_count());
    for (std::uint32_t i = 0; i < scene.patch_count(); ++i)
        result.push_back(scene.emittance(i) + (1.0 / scene.area(i)) * (scene.reflectance(i) * state.incident[i]));
    return result;
}

} // namespace multipath
