#pragma once

#include <optional>
#include <string>

#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::wire {

/// What a message states about its depth: the codec's mode, and the bound on the difference from the measurement.
struct DepthFidelity {
  std::string mode;                         ///< of the codec; empty: not stated
  bool moved = false;                       ///< true: depth may differ from the measurement
  std::optional<DepthErrorBound> within{};  ///< nullopt while `moved`: the bound is not stated
};

/// Reads what the message states. A bound counts as not stated if its least_m or per_m is not in 0 … 1; `moved` stays
/// true.
[[nodiscard]] DepthFidelity depth_fidelity(const msg::DepthImage& image);
[[nodiscard]] DepthFidelity depth_fidelity(const msg::SurfaceReport& report);

/// The bound of depth that is about to be compressed again; DepthErrorBound::unknown() if it is not stated. nullopt:
/// depth is as measured.
[[nodiscard]] std::optional<DepthErrorBound> loss_of(const DepthFidelity& fidelity) noexcept;

/// Returns the argument with the larger error at a depth of 1 m; `newer` if both errors are equal. The order of errors,
/// the smallest first: depth without a stated mode, depth as measured, depth with a stated bound, near-lossless depth
/// without a stated bound.
[[nodiscard]] DepthFidelity less_exact(const DepthFidelity& older, const DepthFidelity& newer);

/// Describes the error for people: "lossless", "off by up to 2.85 mm at 1 m", "off by an unknown amount", "not
/// stated".
[[nodiscard]] std::string how_far(const DepthFidelity& fidelity);

/// The codec's mode and how_far(): "bounded, off by up to 2.85 mm at 1 m".
[[nodiscard]] std::string in_words(const DepthFidelity& fidelity);

/// The bound's error at a depth of 1 m [mm].
[[nodiscard]] double at_1_m_mm(const DepthErrorBound& bound) noexcept;

}  // namespace telepalp::wire
