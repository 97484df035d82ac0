#pragma once

#include <cstdint>
#include <vector>

namespace multipath {

/// Shares a number of rays among pairs that have had some lines already: like water poured into vessels of different
/// depth, each gets what it lacks of level * importance, if anything.
class FillLevel
{
public:
    FillLevel();

    /// A pair of this importance (> 0) that is as well known as by so many lines.
    void add(double importance, double lines);
    void add(const FillLevel& others);

    /// The level to which the rays fill all vessels together, to a few percent.
    double level(double rays) const;

private:
    struct Vessels
    {
        double importance = 0.0;
        double lines = 0.0;
    };

    std::vector<Vessels> by_depth_; ///< by lines / importance, the level at which they begin to fill
};

} // namespace multipath
