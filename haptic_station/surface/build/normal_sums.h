#pragma once

#include <cstddef>

namespace telepalp::surface {

/// Adds the normal equations of weighted least squares with eight unknowns: weights[i] · t tᵀ to `normal`, 8 × 8, and
/// values[i] · t to `by`, with t the eight terms at terms[8 i], in the order of i. Each value is already multiplied by
/// its weight. The result is bitwise equal on every processor.
void add_normal_equations(const double* terms, const double* weights, const double* values, std::size_t count,
                          double* normal, double* by) noexcept;

}  // namespace telepalp::surface
