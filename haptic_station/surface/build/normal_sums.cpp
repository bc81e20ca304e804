#include "haptic_station/surface/build/normal_sums.h"

#include "proto/words/vectorised.h"

// Compiled for several instruction sets. This file must not use inline functions of headers that other files compile
// for another instruction set.

namespace telepalp::surface {
namespace {

using Half [[gnu::vector_size(32)]] = double;

/// Four columns of `normal`, whose sums stay in registers.
TELEPALP_VECTORISED
void add_columns(const double* terms, const double* weights, std::size_t count, std::size_t first, double* normal) {
  Half sums[4][2];
  __builtin_memcpy(&sums, normal + 8 * first, sizeof sums);
  for (std::size_t i = 0; i < count; ++i) {
    const double* t = terms + 8 * i;
    Half low, high;
    __builtin_memcpy(&low, t, sizeof low);
    __builtin_memcpy(&high, t + 4, sizeof high);
    low *= weights[i];
    high *= weights[i];
    for (std::size_t column = 0; column < 4; ++column) {
      sums[column][0] += t[first + column] * low;
      sums[column][1] += t[first + column] * high;
    }
  }
  __builtin_memcpy(normal + 8 * first, &sums, sizeof sums);
}

TELEPALP_VECTORISED
void add_weighted(const double* terms, const double* values, std::size_t count, double* by) {
  Half sums[2];
  __builtin_memcpy(&sums, by, sizeof sums);
  for (std::size_t i = 0; i < count; ++i) {
    Half low, high;
    __builtin_memcpy(&low, terms + 8 * i, sizeof low);
    __builtin_memcpy(&high, terms + 8 * i + 4, sizeof high);
    sums[0] += values[i] * low;
    sums[1] += values[i] * high;
  }
  __builtin_memcpy(by, &sums, sizeof sums);
}

}  // namespace

void add_normal_equations(const double* terms, const double* weights, const double* values, std::size_t count,
                          double* normal, double* by) noexcept {
  add_columns(terms, weights, count, 0, normal);
  add_columns(terms, weights, count, 4, normal);
  add_weighted(terms, values, count, by);
}

}  // namespace telepalp::surface
