#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace telepalp::mixed {

/// A colour by hue [rad, from -pi to pi], saturation and intensity (0 to 1). Grey has hue 0, black has saturation 0.
struct Hsi {
  double hue_rad = 0.0;
  double saturation = 0.0;
  double intensity = 0.0;
};

using Rgb = std::array<std::uint8_t, 3>;

/// Source: paper S3 (docs/sources.md) 5.3, with the geometric hue atan2(sqrt(3) (G - B), 2 R - G - B).
[[nodiscard]] Hsi hsi_of(const Rgb& rgb) noexcept;

/// The colour of a hand or a glove: an elliptical Gaussian in HSI. Paper S3 eq. (3) and (4).
struct HandColour {
  Hsi key;
  double hue_deviation_rad = 0.2;
  double saturation_deviation = 0.12;
  double intensity_deviation = 0.2;
  double threshold = 3.0;  ///< largest Mahalanobis distance of a hand's pixel
};

/// Mahalanobis distance of a colour from the key colour. The hue's difference is an angle. A colour with little chroma
/// has an uncertain hue, so its hue counts less, and at saturation 0 not at all. A dark colour's saturation is
/// uncertain and counts less, too. S3 thresholds the density of eq. (3), which differs only in the threshold's unit.
[[nodiscard]] double mahalanobis(const HandColour& hand, const Hsi& colour) noexcept;

/// The mean colour and the deviations of at least one sample; deviations have a least size, so that a uniform glove
/// still tolerates the camera's noise.
[[nodiscard]] HandColour fit_hand_colour(std::span<const Rgb> samples);

/// States for each colour, with 6 bits a channel, whether it is the hand's. So a pixel costs one look-up.
class HandColourTable {
 public:
  explicit HandColourTable(const HandColour& hand);
  [[nodiscard]] bool contains(const std::uint8_t* rgb) const noexcept {
    return on_[static_cast<std::size_t>(rgb[0] >> 2) << 12U | static_cast<std::size_t>(rgb[1] >> 2) << 6U |
               static_cast<std::size_t>(rgb[2] >> 2)] != 0;
  }

 private:
  std::vector<std::uint8_t> on_;
};

}  // namespace telepalp::mixed
