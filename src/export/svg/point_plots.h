#pragma once

#include "sampling/discrepancy.h"

#include <string>
#include <vector>

// Plots of sequences as SVG documents. The comments go into the document's description.

namespace multipath {

/// Two dimensions of a sequence, numbered from 0.
struct DimensionPair
{
    int across;
    int up;
};

/// All pairs across < up, row by row of the lower triangle: 0,1; 0,2; 1,2; ...
std::vector<DimensionPair> all_pairs(int dimensions);

/// Scatter plots of projections, one per pair. If `pairs` are all_pairs() of the dimensions, the plots form a triangle
/// with one column per dimension across; otherwise they fill rows of three.
std::string scatter_plots(const PointSet& points, const std::vector<DimensionPair>& pairs, const std::string& title,
                          const std::vector<std::string>& comments);

/// Plots of the correlation of successive points, two per pair: arrows from each of the first hundred points to the
/// next, from dark to bright, and a lag plot of both coordinates of every point (across) against those of the next
/// (up), in which correlated points fall on a few lines. Needs at least two points.
std::string order_plots(const PointSet& points, const std::vector<DimensionPair>& pairs, const std::string& title,
                        const std::vector<std::string>& comments);

/// Figure 1 of the paper: random points of the square, and as many points of the Halton sequence with bases 2 and 3.
std::string paper_figure_1(std::uint64_t count, std::uint64_t seed, const std::vector<std::string>& comments);

/// Figure 2 of the paper: the first and second point of every line, drawn like order_plots(), for (a) the Halton
/// sequence with two 2-D items per line, (b) random numbers, (c) 4-D items of the Halton and (d) of the Sobol sequence.
/// In (a) the two points are far from each other by construction.
std::string paper_figure_2(std::uint64_t count, std::uint64_t seed, const std::vector<std::string>& comments);

} // namespace multipath
