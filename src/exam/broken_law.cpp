#include "exam/broken_law.h"

#include "scene/scene_builder.h"

#include <algorithm>
#include <utility>

namespace multipath {

namespace {

/// A sequence whose items are bent: point n of it is bend(n, item n).
class BentSequence final : public Sequence
{
public:
    using Bend = Item (*)(std::uint64_t n, Item item);

    BentSequence(std::unique_ptr<Sequence> base, Bend bend) : base_(std::move(base)), bend_(bend) {}

    std::string name() const override { return base_->name(); }
    int dimensions() const override { return base_->dimensions(); }
    std::uint64_t item_limit() const override { return base_->item_limit(); }
    double coordinate(std::uint64_t n, int dimension) const override
    {
        return bend_(n, base_->item(n))[static_cast<std::size_t>(dimension)];
    }

private:
    std::unique_ptr<Sequence> base_;
    Bend bend_;
};

/// The square of the sine becomes 1 - (1 - u)^2, so that the cosine is uniform, as it is over the hemisphere.
Item without_cosine(std::uint64_t, Item item)
{
    item[2] *= 2.0 - item[2];
    return item;
}

Item crowded_start(std::uint64_t, Item item)
{
    item[0] *= item[0];
    return item;
}

/// Chords of length zero meet nothing.
Item every_second(std::uint64_t n, Item item)
{
    return n % 2 == 0 ? item : Item{item[0], item[1], item[0], item[1]};
}

/// The first number of a point of the sphere tells how high it lies.
Item from_top_to_bottom(std::uint64_t, Item item)
{
    return item[0] <= item[2] ? item : Item{item[2], item[3], item[0], item[1]};
}

SceneFile without_screens(const SceneFile& file)
{
    SceneBuilder kept;
    for (const Material& material : file.materials)
        kept.material(material.name, material.reflectance, material.emittance);
    for (std::size_t s = 0; s < file.surfaces.size(); ++s)
        if (file.materials[file.material[s]].name != screen_material)
            kept.surface(file.surfaces[s], file.material[s]);
    return kept.file();
}

} // namespace

BrokenLaw broken_law_named(std::string_view name)
{
    const auto found = std::find(broken_law_names.begin(), broken_law_names.end(), name);
    return static_cast<BrokenLaw>(found - broken_law_names.begin());
}

SceneFile with_law_broken(SceneFile file, std::optional<BrokenLaw> broken)
{
    if (broken == BrokenLaw::visibility)
        return without_screens(file);
    if (broken == BrokenLaw::reflectance)
        for (Material& material : file.materials)
            material.reflectance = 0.9 * material.reflectance;
    return file;
}

std::unique_ptr<Sequence> items_of_rays(std::unique_ptr<Sequence> sequence, std::optional<BrokenLaw> broken)
{
    if (broken == BrokenLaw::cosine)
        return std::make_unique<BentSequence>(std::move(sequence), without_cosine);
    return sequence;
}

std::unique_ptr<Sequence> items_of_lines(std::unique_ptr<Sequence> sequence, std::optional<BrokenLaw> broken)
{
    if (broken == BrokenLaw::crossings)
        return std::make_unique<BentSequence>(std::move(sequence), crowded_start);
    if (broken == BrokenLaw::forecast)
        return std::make_unique<BentSequence>(std::move(sequence), every_second);
    if (broken == BrokenLaw::bidirectional)
        return std::make_unique<BentSequence>(std::move(sequence), from_top_to_bottom);
    return sequence;
}

} // namespace multipath
