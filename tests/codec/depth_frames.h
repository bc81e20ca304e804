#pragma once

#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "proto/words/rgbd_frame.h"

namespace telepalp::codec {

/// A frame of a Kinect-class camera: a slanted floor, a sphere in front of it, a shadow without measurement, levels
/// 2.85 z² mm apart, and noise of one level. `shift` moves the sphere, for sequences.
inline DepthImage kinect_like(int width, int height, unsigned seed, int shift = 0) {
  std::mt19937 random(seed);
  DepthImage depth{.width = width, .height = height, .unit_m = 0.001, .samples = {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double dx = (x - shift) / static_cast<double>(width) - 0.4;
      const double dy = y / static_cast<double>(height) - 0.5;
      const bool on_sphere = dx * dx + dy * dy < 0.05;
      const bool in_shadow = !on_sphere && dx > 0.0 && dx < 0.3 && dy * dy < 0.04;
      const double z_m = on_sphere ? 0.8 - (0.05 - dx * dx - dy * dy) : 1.2 + 0.8 * (0.5 - dy);
      const int disparity = static_cast<int>(1000.0 / (2.85 * z_m)) + static_cast<int>(random() % 8 == 0);
      const bool flickers = random() % 50 == 0;
      depth.samples.push_back(in_shadow || flickers ? std::uint16_t{0}
                                                    : static_cast<std::uint16_t>(1000.0 * 1000.0 / 2.85 / disparity));
    }
  return depth;
}

inline DepthImage filled(int width, int height, std::uint16_t sample) {
  return {.width = width,
          .height = height,
          .unit_m = 0.001,
          .samples =
              std::vector<std::uint16_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), sample)};
}

inline DepthImage noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  DepthImage depth = filled(width, height, 0);
  for (std::uint16_t& sample : depth.samples) sample = static_cast<std::uint16_t>(random());
  return depth;
}

/// The three images of each golden sequence.
inline DepthImage golden_frame(unsigned i) {
  return i == 2 ? noise(24, 18, 9) : kinect_like(24, 18, i, static_cast<int>(i));
}

inline std::span<const std::byte> bytes_of(const std::string& packet) { return std::as_bytes(std::span(packet)); }

}  // namespace telepalp::codec
