#pragma once

#include <string_view>
#include <vector>

#include "proto/words/rgbd_frame.h"
#include "tests/bench/report.h"

namespace telepalp::bench {

/// The camera of all sections.
inline const Intrinsics kLens{1024, 768, 950, 950, 511.5, 383.5};

/// One group of rows of `telepalp-bench mixed`; `--part NAME` runs it alone.
struct MixedSection {
  std::string_view name;
  std::string_view purpose;
  std::vector<Row> (*run)();
};

/// The device's pose by clicks, under the paper's noise and three shapes of the gimbal's error.
[[nodiscard]] std::vector<Row> run_calibration_section();
/// Masks of device and hand against those of the renderer.
[[nodiscard]] std::vector<Row> run_labels_section();
/// The completed background against the true one.
[[nodiscard]] std::vector<Row> run_background_section();
/// The drawn hand against a hand at the tool, and the processor time of an image.
[[nodiscard]] std::vector<Row> run_hand_section();
/// A headset anchored by touches, and thresholds of ideal observers.
[[nodiscard]] std::vector<Row> run_anchor_section();

}  // namespace telepalp::bench
