#pragma once

#include <optional>
#include <string>

#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::wire {

/// A message's statement about its depth: the codec's mode, and how far depth may be off the measurement.
struct DepthFidelity {
  std::string mode;                         ///< of the codec; empty: not stated
  bool moved = false;                       ///< true: depth may differ from the measurement
  std::optional<DepthErrorBound> within{};  ///< nullopt although moved: the amount is not stated
};

/// Reads the statement. A bound that is negative, not finite, or beyond one metre counts as not stated; `moved` stays
/// true.
[[nodiscard]] DepthFidelity depth_fidelity(const msg::DepthImage& image);
[[nodiscard]] DepthFidelity depth_fidelity(const msg::SurfaceReport& report);

/// The bound of depth that is about to be compressed again. nullopt: depth is as measured.
[[nodiscard]] std::optional<DepthErrorBound> loss_of(const DepthFidelity& fidelity) noexcept;

/// The one with the larger error bound; the newer one when both are equal. An unknown bound is larger than any other.
[[nodiscard]] DepthFidelity less_exact(const DepthFidelity& older, const DepthFidelity& newer);

/// For people: "as measured", "off by up to 2.85 mm at 1 m".
[[nodiscard]] std::string how_far(const DepthFidelity& fidelity);

/// The same after the mode: "bounded, off by up to 2.85 mm at 1 m".
[[nodiscard]] std::string in_words(const DepthFidelity& fidelity);

/// The bound's error at a depth of 1 m [mm].
[[nodiscard]] double at_1_m_mm(const DepthErrorBound& bound) noexcept;

}  // namespace telepalp::wire
