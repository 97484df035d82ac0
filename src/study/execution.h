#pragma once

#include <cstdint>
#include <string>

namespace multipath {

/// Which run of a study: the curve it belongs to, its lines, and its number among those of the same lines.
struct ExecutionKey
{
    std::string curve; ///< a name without tabs and line ends
    std::uint64_t lines = 0;
    int number = 0;
};

/// What one run of a study gave.
struct Execution
{
    std::uint64_t local_lines = 0;  ///< N_l
    std::uint64_t global_lines = 0; ///< N_g
    double mean_square = 0.0;       ///< MSE (1) [W^2/m^4]
    double relative = 0.0;          ///< relative MSE [1]
    double seconds = 0.0;           ///< [s] processor time on one thread
};

} // namespace multipath
