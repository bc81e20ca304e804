#pragma once

#include <span>
#include <string>
#include <string_view>

#include "haptic_station/device/random.h"
#include "proto/words/error_line.h"

namespace telepalp::study {

/// A number that nobody knows exactly: it is drawn evenly from its range. The ranges were written down before the first
/// study was run, and no range was changed to meet a result.
template <class Owner>
struct Drawn {
  std::string_view name;
  std::string_view unit;
  double Owner::*value;
  double least;
  double most;
  std::string_view source;
};

/// One value of each range.
template <class Owner>
[[nodiscard]] Owner draw(std::span<const Drawn<Owner>> ranges, device::Random& random) noexcept {
  Owner out;
  for (const Drawn<Owner>& range : ranges) out.*range.value = random.uniform(range.least, range.most);
  return out;
}

/// Names and limits of the ranges, for the checksum in a study's identity.
template <class Owner>
[[nodiscard]] std::string ranges_text(std::span<const Drawn<Owner>> ranges) {
  std::string text;
  for (const Drawn<Owner>& range : ranges)
    text += std::string(range.name) + number_text(range.least) + number_text(range.most);
  return text;
}

/// The seed of one part of a study. Different parts of one study draw independent numbers.
[[nodiscard]] inline std::uint64_t seed_of(std::uint64_t seed, std::uint64_t part, std::uint64_t number) noexcept {
  device::Random mix(seed * 0x9E3779B97F4A7C15ULL + part * 0xD1B54A32D192ED03ULL + number);
  (void)mix.bits();
  return mix.bits();
}

}  // namespace telepalp::study
