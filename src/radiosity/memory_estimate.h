#pragma once

#include "scene/scene.h"

namespace multipath {

/// [bytes] Peak memory of a run with so many surfaces and patches, by any method but `reuse`. That method needs more:
/// reuse_bytes() in addition if it makes a table of all pairs of patches, otherwise at least min_balanced_bytes() in
/// total. An empirical formula. Takes real numbers, since estimated sizes may exceed the integer types.
double run_bytes(double surfaces, double patches);

/// [bytes] Peak memory for making an interactive page with so many surfaces and patches: all quantities that the page
/// can show, each as numbers and as text. An empirical formula.
double page_bytes(double surfaces, double patches);

/// [bytes] Part of `memory` [bytes] that a run can use for pairs of patches: what run_bytes() leaves, at least 0.
double bytes_for_pairs(double memory, const Scene& scene);

} // namespace multipath
