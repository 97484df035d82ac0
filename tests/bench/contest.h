#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace multipath {

/// One row of the table: some work, and how many pieces of it there are.
struct Contestant
{
    std::string name;
    std::string unit;            ///< of a piece
    std::function<double()> run; ///< returns the number of pieces done
    std::string rival = {};      ///< name of the one in the same group that it is compared with; empty: none
    std::size_t parts = 1;       ///< how often it runs in its turn
    std::function<void(std::size_t part)> prepare = {}; ///< what comes before each run, and does not count
    std::vector<double> rates = {};                     ///< [pieces / s] of processor time, round by round
};

/// Lets all take their turn in each of some rounds, and prints for each the median rate with the slowest and the
/// fastest, and the median over the rounds of the ratio to its rival: what the machine does besides hits both.
void compete(const std::string& title, std::vector<Contestant> contestants);

/// What is computed goes here, so that it must be computed.
void use(double value);

} // namespace multipath
