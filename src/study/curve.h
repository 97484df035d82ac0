#pragma once

#include "radiosity/solve_options.h"
#include "study/power_law.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace multipath {

/// What a curve of a study is about: a way to solve, at any number of lines.
struct CurveKind
{
    std::string method;     ///< as --method names it
    std::string sequence;   ///< as --sequence names it
    std::string pairing;    ///< as --pairing names it
    std::string chords;     ///< as --chords names it; empty for a method without global lines
    std::string line_order; ///< as --line-order names it; empty for a method that does not walk along them
};

bool operator==(const CurveKind& a, const CurveKind& b);

/// The mean of some executions with the same number of lines.
struct CurvePoint
{
    std::uint64_t lines = 0;     ///< asked for, N_l + N_g
    double local_lines = 0.0;    ///< N_l, mean
    double global_lines = 0.0;   ///< N_g, mean
    double mean_square = 0.0;    ///< MSE (1) [W^2/m^4], mean
    double relative = 0.0;       ///< the same over the square of the reference's mean radiosity [1]
    double relative_error = 0.0; ///< standard error of `relative` [1]; 0 with one execution
    double seconds = 0.0;        ///< [s] processor time of one execution on one thread, preparation included, mean
    bool above_reference = true; ///< is the reference's own error small beside it? Otherwise it is left out of the fit
};

/// (2): `relative` against lines, through the points above the reference.
std::optional<PowerLaw> fit(const std::vector<CurvePoint>& points);

struct Curve
{
    CurveKind kind;
    std::vector<CurvePoint> points; ///< by increasing number of lines
    std::optional<PowerLaw> law;
};

/// All that a study found.
struct Study
{
    std::vector<Curve> curves;
    int executions = 1;                              ///< of which every point is the mean
    std::optional<double> reference_relative_square; ///< [1] relative MSE of the reference, estimated by itself
};

} // namespace multipath
