#pragma once

#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "sampling/sequence.h"
#include "transport/lines/global_lines.h"

#include <cstddef>
#include <cstdint>

namespace multipath {

/// What the counts may take of the memory that the user allows [bytes].
std::size_t count_bytes(std::uint32_t patches, double memory);

/// Lines below which they are not counted. The solution of (R1) is not linear in the counts and has a bias: with n
/// lines per patch the mean radiosity comes out high by the share 0.03 / (n (1 - R_ave)) or so, measured with 6 to 180
/// lines per patch in 4CHAIRS and in 5CUBES with most of its reflectances raised to 0.95. Enough is where that is 0.3
/// %.
double fewest_lines_to_count(const Scene& scene, const GlobalLines& lines);

/// True if so many lines are enough, all together and as many as the counts can hold at a time.
bool can_count(const Scene& scene, const GlobalLines& lines, std::uint64_t lines_cast, std::size_t byte_limit);

/// Distributes all unshot power of scenes with too many patches for a table of all pairs: global lines are counted
/// where they join patches, and the light is solved for (R1). When the counts fill `byte_limit` before all lines are
/// cast, they are solved for and the lines go on from nothing; the results are averaged by their lines. Returns how
/// many lines were cast: fewer if the run is stopped. A checkpoint must hold the state, too. Throws InputError if the
/// equations have no solution.
std::uint64_t reuse_counted_lines(const Scene& scene, const GlobalLines& lines, const Sequence& sequence,
                                  std::uint64_t first_item, std::uint64_t lines_cast, std::size_t byte_limit,
                                  const RunControl& run, PowerState& state);

} // namespace multipath
