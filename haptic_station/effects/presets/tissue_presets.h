#pragma once

#include <array>
#include <string_view>

#include "haptic_station/effects/laws/skin_law.h"

namespace telepalp::effects {

/// A skin law fitted to a compression test of tissue-mimicking silicone. The test is scaled to a contact of 30 mm
/// diameter over 60 mm of tissue, with equal stress at equal strain, and fitted up to half the thickness (0.03 m).
/// Deeper, real tissue hardens more than the law. The unit tests repeat the fits from tests/data/tissue.
struct TissuePreset {
  std::string_view name;
  std::string_view material;  ///< name in the database that tests/data/tissue/README.md cites
  SkinLaw law;
  double rms_error_share;  ///< root-mean-square error / largest load
};

inline constexpr std::array kTissuePresets = std::to_array<TissuePreset>({
    {"soft_fat", "EF10_100T", {60.42, 0.0, 1.508e5}, 0.0233},
    {"relaxed_belly", "EF10_50T", {150.9, 0.0, 2.675e5}, 0.0192},
    {"tensed_belly", "EF30_50T", {339.0, 0.0, 4.878e5}, 0.0136},
    {"muscle", "EF10_0T", {565.2, 0.0, 8.422e5}, 0.0187},
    {"hard_mass", "EF50_12_5T", {1334.0, 0.0, 1.488e6}, 0.0139},
});

/// The preset of this name; nullptr when there is none.
[[nodiscard]] constexpr const TissuePreset* find_tissue(std::string_view name) noexcept {
  for (const TissuePreset& preset : kTissuePresets)
    if (preset.name == name) return &preset;
  return nullptr;
}

}  // namespace telepalp::effects
