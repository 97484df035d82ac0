#pragma once

#include "sampling/discrepancy.h"

#include <string>
#include <vector>

// Drawings of sequences, as SVG documents. The comments go into the document's description.

namespace multipath {

/// Two dimensions of a sequence, numbered from 0.
struct DimensionPair
{
    int across;
    int up;
};

/// All pairs across < up, row by row of the lower triangle: 0,1; 0,2; 1,2; ...
std::vector<DimensionPair> all_pairs(int dimensions);

/// One plot per pair. All pairs of the dimensions form a triangle, in which every column shares its dimension across;
/// any other choice fills rows of three.
std::string scatter_plots(const PointSet& points, const std::vector<DimensionPair>& pairs, const std::string& title,
                          const std::vector<std::string>& comments);

/// Two plots per pair: arrows from each of the first hundred points to the next, dark to bright; and below, both
/// coordinates of every point (across) against those of the next (up). Where successive points are correlated the dots
/// fall on a few lines. Needs two points or more.
std::string order_plots(const PointSet& points, const std::vector<DimensionPair>& pairs, const std::string& title,
                        const std::vector<std::string>& comments);

/// The paper's Figure 1: random points of the square beside as many of Halton's for the bases 2 and 3.
std::string paper_figure_1(std::uint64_t count, std::uint64_t seed, const std::vector<std::string>& comments);

/// The paper's Figure 2: the first and the second point of every line in (a) Halton's sequence taken two items a line,
/// (b) random numbers, (c) 4-D items of Halton's and (d) of Sobol's sequence; drawn as in order_plots(). In (a) the two
/// points are far from each other by construction.
std::string paper_figure_2(std::uint64_t count, std::uint64_t seed, const std::vector<std::string>& comments);

} // namespace multipath
