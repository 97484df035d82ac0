#include "scene/scene_hash.h"

#include "parallel/mix_bits.h"

#include <cstring>

namespace multipath {

namespace {

class Hash
{
public:
    void add(std::uint64_t value) { state_ = mix_bits(state_ ^ value); }
    void add(double value)
    {
        const double without_sign_of_zero = value == 0.0 ? 0.0 : value;
        std::uint64_t bits = 0;
        std::memcpy(&bits, &without_sign_of_zero, sizeof bits);
        add(bits);
    }
    void add(Vec3 v)
    {
        add(v.x);
        add(v.y);
        add(v.z);
    }
    void add(Rgb c)
    {
        add(c.r);
        add(c.g);
        add(c.b);
    }
    std::uint64_t value() const { return state_; }

private:
    std::uint64_t state_ = 0xcbf29ce484222325u;
};

} // namespace

std::uint64_t scene_hash(const SceneFile& file, const std::vector<Tessellation>& tessellations, bool two_sided)
{
    Hash hash;
    hash.add(std::uint64_t{two_sided});
    for (std::size_t s = 0; s < file.surfaces.size(); ++s) {
        const Surface& surface = file.surfaces[s];
        const Material& material = file.materials[file.material[s]];
        hash.add(std::uint64_t{surface.shape == Shape::triangle});
        hash.add(surface.origin);
        hash.add(surface.edge_u);
        hash.add(surface.edge_v);
        hash.add(material.reflectance);
        hash.add(material.emittance);
        hash.add(std::uint64_t{tessellations[s].cells_u});
        hash.add(std::uint64_t{tessellations[s].cells_v});
    }
    return hash.value();
}

} // namespace multipath
