#pragma once

#include "sampling/discrepancy.h"

#include <string>
#include <vector>

// Plots of sequences as SVG documents. The title is drawn; the comments go into the description of the document. "The
// paper" is Castro, Martinez, Sbert 1998.

namespace multipath {

/// Scatter plots of the projections of points of at least two dimensions to all pairs of dimensions, in a triangle: one
/// column for each dimension across, one row for each dimension up.
std::string scatter_plots(const PointSet& points, const std::string& title, const std::vector<std::string>& comments);

/// Two plots for each pair of dimensions that show how successive points are correlated. The first has arrows from each
/// of the first hundred points to the next, from dark to bright. The second is a lag plot: each coordinate of a point
/// (horizontal) against the same coordinate of the next point (vertical), in which correlated points fall on a few
/// lines. Needs at least two points of at least two dimensions.
std::string order_plots(const PointSet& points, const std::string& title, const std::vector<std::string>& comments);

/// Figure 1 of the paper: `count` random points of the unit square, and as many points of the Halton sequence with
/// bases 2 and 3. `seed`: of the random points.
std::string paper_figure_1(std::uint64_t count, std::uint64_t seed, const std::vector<std::string>& comments);

/// Figure 2 of the paper: for each of four sequences, arrows from the first to the second point of up to a hundred
/// lines, and a lag plot of the two points of all `count` lines. A line is made from (a) two successive 2-D points of
/// the Halton sequence, (b) four random numbers, (c) one 4-D point of the Halton sequence, or (d) one 4-D point of the
/// Sobol sequence. In (a) the two points of a line are far from each other by construction. `seed`: of the random
/// numbers.
std::string paper_figure_2(std::uint64_t count, std::uint64_t seed, const std::vector<std::string>& comments);

} // namespace multipath
