#pragma once

#include <cstdint>

namespace telepalp::capture {

/// A random number, uniform in [least, most), as a pure function of (seed, event, which): any event of a motion can be
/// drawn without the events before it. `which` numbers the quantities of one event. The mixing function is
/// SplitMix64's.
[[nodiscard]] inline double seeded_draw(std::uint64_t seed, std::int64_t event, std::uint64_t which, double least,
                                        double most) noexcept {
  std::uint64_t z = seed * 0x9E3779B97F4A7C15ULL + static_cast<std::uint64_t>(event) * 0xD1B54A32D192ED03ULL +
                    which * 0x8CB92BA72F3D8DD7ULL + 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
  z ^= z >> 31U;
  return least + (most - least) * (static_cast<double>(z >> 11U) * 0x1.0p-53);
}

}  // namespace telepalp::capture
