#pragma once

#include "scene/rgb.h"

#include <cstddef>
#include <vector>

// Conjugate gradients with a preconditioner (Hestenes and Stiefel 1952) for one system of equations, or for one in each
// channel of colour. Value: double or Rgb.

namespace multipath {

/// 0 where the divisor is.
inline double quotient(double a, double b)
{
    return b != 0.0 ? a / b : 0.0;
}

inline Rgb quotient(Rgb a, Rgb b)
{
    return {quotient(a.r, b.r), quotient(a.g, b.g), quotient(a.b, b.b)};
}

/// In all channels.
inline bool at_most(double a, double b)
{
    return a <= b;
}

inline bool at_most(Rgb a, Rgb b)
{
    return a.r <= b.r && a.g <= b.g && a.b <= b.b;
}

template <class Value>
Value dot(const std::vector<Value>& a, const std::vector<Value>& b)
{
    Value sum{};
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
    return sum;
}

/// Moves x towards the solution of matrix(x) = b, where matrix is symmetric and positive definite, and `residual` is b
/// - matrix(x). precondition(r): about the inverse of the matrix times r. Ends at done(r, r . precondition(r)), or
/// after most_steps. True if it was done, and the matrix not found to be indefinite.
template <class Value, class Matrix, class Precondition, class Done>
bool conjugate_gradients(const Matrix& matrix, const Precondition& precondition, std::vector<Value> residual,
                         int most_steps, const Done& done, std::vector<Value>& x)
{
    std::vector<Value> preconditioned = precondition(residual);
    std::vector<Value> direction = preconditioned;
    Value norm = dot(residual, preconditioned);
    bool positive = true;
    for (int step = 0; step < most_steps && positive && !done(residual, norm); ++step) {
        const std::vector<Value> image = matrix(direction);
        const Value curvature = dot(direction, image);
        positive = at_most(Value{}, curvature);
        const Value length = quotient(norm, curvature);
        for (std::size_t i = 0; i < x.size(); ++i) {
            x[i] += length * direction[i];
            residual[i] = residual[i] - length * image[i];
        }
        preconditioned = precondition(residual);
        const Value next = dot(residual, preconditioned);
        const Value turn = quotient(next, norm);
        for (std::size_t i = 0; i < x.size(); ++i)
            direction[i] = preconditioned[i] + turn * direction[i];
        norm = next;
    }
    return positive && done(residual, norm);
}

} // namespace multipath
