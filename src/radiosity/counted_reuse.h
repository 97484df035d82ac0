#pragma once

#include "parallel/run_control.h"
#include "radiosity/power_state.h"
#include "sampling/sequence.h"
#include "transport/line_sampling.h"

#include <cstddef>
#include <cstdint>

namespace multipath {

/// What the counts may take of the memory that the user allows [bytes].
std::size_t count_bytes(std::uint32_t patches, double memory);

/// Distributes all unshot power of scenes with too many patches for a table of all pairs: global lines are counted
/// where they join patches, and the light is solved for (R1). When the counts fill `byte_limit` before all lines are
/// cast, they are solved for and the lines go on from nothing; the results are averaged by their lines. Returns how
/// many lines were cast: fewer if the run is stopped. A checkpoint must hold the state, too.
std::uint64_t reuse_counted_lines(const Scene& scene, const GlobalLines& lines, const Sequence& sequence,
                                  std::uint64_t first_item, std::uint64_t lines_cast, std::size_t byte_limit,
                                  const RunControl& run, PowerState& state);

} // namespace multipath
