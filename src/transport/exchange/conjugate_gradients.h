#pragma once

#include "parallel/blocks.h"
#include "scene/rgb.h"

#include <cstddef>
#include <cstdint>
#include <vector>

// Preconditioned conjugate gradients (Hestenes and Stiefel 1952). Value is double for one system of linear equations,
// or Rgb for three that are solved side by side, one for each colour channel.

namespace multipath {

/// Inner product of two vectors of equal size; for colours, one in each channel.
template <class Value>
Value dot(const std::vector<Value>& a, const std::vector<Value>& b)
{
    Value sum{};
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
    return sum;
}

/// Improves x, a guess of the solution of A x = b, where A is symmetric and positive definite. `residual` must be
/// b - A x for this guess. matrix(x) returns A x, precondition(i, r_i) about r_i / A_ii. Stops when
/// done(residual, sum over i of r_i precondition(i, r_i)) returns true, after most_steps, or after a step which shows
/// that A is indefinite. Returns true if `done` is true in the end and A has not turned out to be indefinite; otherwise
/// x is no solution. The result has the same bits for any number of threads.
template <class Value, class Matrix, class Precondition, class Done>
bool conjugate_gradients(const Matrix& matrix, const Precondition& precondition, std::vector<Value> residual,
                         int most_steps, const Done& done, int threads, std::vector<Value>& x)
{
    const auto n = static_cast<std::uint32_t>(x.size());
    const auto sum = [&](const auto& term) { return parallel_sum<Value>(n, threads, term); };
    std::vector<Value> direction =
        parallel_list(n, threads, [&](std::uint32_t i) { return precondition(i, residual[i]); });
    Value norm = sum([&](std::uint32_t i) { return residual[i] * direction[i]; });
    bool positive = true;
    for (int step = 0; step < most_steps && positive && !done(residual, norm); ++step) {
        const std::vector<Value> image = matrix(direction);
        const Value curvature = sum([&](std::uint32_t i) { return direction[i] * image[i]; });
        positive = at_most(Value{}, curvature);
        const Value length = quotient(norm, curvature);
        const Value next = sum([&](std::uint32_t i) {
            x[i] += length * direction[i];
            residual[i] = residual[i] - length * image[i];
            return residual[i] * precondition(i, residual[i]);
        });
        const Value turn = quotient(next, norm);
        parallel_numbers(n, threads,
                         [&](std::uint32_t i) { direction[i] = precondition(i, residual[i]) + turn * direction[i]; });
        norm = next;
    }
    return positive && done(residual, norm);
}

} // namespace multipath
