#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "haptic_station/effects/skin_law.h"
#include "proto/words/result.h"

namespace telepalp::calibration {

/// One point of a compression test: how far the specimen was pressed and what it took.
struct CompressionSample {
  double compression_m;
  double load_N;
};

/// A specimen, and the tissue that the hand is to feel instead: the same stress at the same strain, under another area
/// and over another thickness.
struct Specimen {
  double diameter_m = 0.05;
  double height_m = 0.03;
};
struct TissueUnderHand {
  double contact_diameter_m = 0.03;  ///< of two or three fingertips
  double thickness_m = 0.06;
};

[[nodiscard]] std::vector<CompressionSample> under_hand(std::span<const CompressionSample> test,
                                                        const Specimen& specimen, const TissueUnderHand& tissue);

struct TissueFit {
  effects::SkinLaw law;
  double rms_error_N = 0.0;
  double rms_error_share = 0.0;  ///< of the largest load
  std::size_t samples = 0;
};

/// The law with coefficients that are not negative whose force k(d) d is nearest to the samples, by least squares.
/// Error: fewer than four samples, no load, or numbers that are not finite.
[[nodiscard]] Result<TissueFit> fit_tissue(std::span<const CompressionSample> samples);

/// Reads `compression_mm,load_N` rows after one header row. Damaged rows are an error with their line.
[[nodiscard]] Result<std::vector<CompressionSample>> read_compression_test(const std::filesystem::path& file);

}  // namespace telepalp::calibration
