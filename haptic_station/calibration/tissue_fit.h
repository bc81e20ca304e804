#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "haptic_station/effects/laws/skin_law.h"
#include "proto/words/result.h"

namespace telepalp::calibration {

/// One point of a compression test: the compression of the specimen and the load.
struct CompressionSample {
  double compression_m;
  double load_N;
};

/// Cylindrical specimen of a compression test.
struct Specimen {
  double diameter_m = 0.05;
  double height_m = 0.03;
};
/// Tissue under the examining hand.
struct TissueUnderHand {
  double contact_diameter_m = 0.03;  ///< diameter of the contact of two or three fingertips
  double thickness_m = 0.06;
};

/// Scales a compression test to tissue under a hand, at equal stress and strain.
[[nodiscard]] std::vector<CompressionSample> under_hand(std::span<const CompressionSample> test,
                                                        const Specimen& specimen, const TissueUnderHand& tissue);

struct TissueFit {
  effects::SkinLaw law;
  double rms_error_N = 0.0;
  double rms_error_share = 0.0;  ///< rms error / largest load
  std::size_t samples = 0;
};

/// Least-squares fit of the force k(d) d, with the stiffness k of SkinLaw at compression d, to the samples, with
/// coefficients >= 0.
/// Error: fewer than four or over a million samples, no load above zero, a load that falls as the compression grows, or
/// a number that is not finite.
[[nodiscard]] Result<TissueFit> fit_tissue(std::span<const CompressionSample> samples);

/// Reads `compression_mm,load_N` rows after a header row. Error: unreadable file, or a line that is not two numbers.
[[nodiscard]] Result<std::vector<CompressionSample>> read_compression_test(const std::filesystem::path& file);

}  // namespace telepalp::calibration
