#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace telepalp::sensor {

/// Random bits as a pure function of (seed, instant, pixel), so pixels can be evaluated in any order, for the cost of a
/// few multiplications. The mixing function is a 32-bit finaliser with full avalanche. The key made from seed and
/// instant enters twice, so that the bits of two frames are not shifted copies of each other.
class PixelNoise {
 public:
  PixelNoise(std::uint64_t seed, std::int64_t instant) noexcept {
    std::uint64_t key = seed * 0x9E3779B97F4A7C15ULL + static_cast<std::uint64_t>(instant);
    key = (key ^ (key >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    key = (key ^ (key >> 27U)) * 0x94D049BB133111EBULL;
    key ^= key >> 31U;
    first_ = static_cast<std::uint32_t>(key);
    second_ = static_cast<std::uint32_t>(key >> 32U);
  }
  [[nodiscard]] std::uint32_t bits(std::uint32_t pixel) const noexcept {
    std::uint32_t x = pixel * 0x9E3779B9U + first_;
    x = (x ^ (x >> 16U)) * 0x21F0AAADU;
    x = ((x + second_) ^ (x >> 15U)) * 0xD35A2D97U;
    return x ^ (x >> 15U);
  }

 private:
  std::uint32_t first_;
  std::uint32_t second_;
};

/// A table that maps kGaussianBits uniform random bits to a standard normal variate, truncated at 3.7 sigma.
inline constexpr unsigned kGaussianBits = 12;
using GaussianTable = std::array<float, std::size_t{1} << kGaussianBits>;
[[nodiscard]] const GaussianTable& gaussian_table();

}  // namespace telepalp::sensor
