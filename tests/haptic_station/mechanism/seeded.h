#pragma once

#include <cstdint>
#include <random>

namespace telepalp::mechanism {

/// Uniform random numbers, the same in every run.
class Seeded {
 public:
  explicit Seeded(std::uint64_t seed) : bits_(seed) {}
  double operator()(double least, double most) { return std::uniform_real_distribution<>(least, most)(bits_); }

 private:
  std::mt19937_64 bits_;
};

}  // namespace telepalp::mechanism
