#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "haptic_station/effects/effect_bank.h"

namespace telepalp::ultrasound {

/// A linear probe on the skin, in the haptic base's frame H. Both directions are unit vectors, perpendicular to each
/// other.
struct ProbePose {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();           ///< middle of the probe's face [m]
  Eigen::Vector3d into_body = -Eigen::Vector3d::UnitY();  ///< direction of the scan lines
  Eigen::Vector3d across = Eigen::Vector3d::UnitX();      ///< from the image's left to its right
};

struct BModeSettings {
  int side_px = 256;
  double width_m = 0.06;
  double depth_m = 0.10;
  effects::Echo tissue{};  ///< echo properties around and between the layers
};

/// Brightness of each pixel, 0 (black) to 255: `side_px` rows of `side_px` pixels, from the skin down.
struct BModeImage {
  int side_px = 0;
  std::vector<std::uint8_t> gray;
};

/// A layer, and its displacement from its position in the scene, because the layer moves with the skin above it.
struct PlacedLayer {
  const effects::SolidLayer* layer = nullptr;
  Eigen::Vector3d moved_m = Eigen::Vector3d::Zero();  ///< displacement, in H
};

/// The B-mode image of the plane under the probe. Along each scan line: the echo of each boundary is ((Z1 - Z2) /
/// (Z1 + Z2))^2 with the impedances Z of both sides; each tissue attenuates, so bone casts a shadow; the gain over
/// depth compensates the attenuation of `tissue`. The speckle is Rayleigh-distributed and moves with its layer;
/// between the layers it moves by the mean displacement of all layers. Where layers overlap, the last one in
/// `layers` counts. Not modelled: refraction, reverberation, the beam's width. Pure: equal input gives an equal
/// image.
[[nodiscard]] BModeImage b_mode(std::span<const PlacedLayer> layers, const ProbePose& probe,
                                const BModeSettings& settings = {});

/// As above, with each layer at its position in the scene.
[[nodiscard]] BModeImage b_mode(std::span<const std::shared_ptr<const effects::SolidLayer>> layers,
                                const ProbePose& probe, const BModeSettings& settings = {});

}  // namespace telepalp::ultrasound
