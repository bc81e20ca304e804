#pragma once

#include <optional>
#include <string>

#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::wire {

/// How a message's depth was compressed, and the bound on its error against the camera's measurement.
struct DepthFidelity {
  std::string mode;                         ///< mode of the depth codec; empty: unknown
  bool moved = false;                       ///< true: near-lossless, depth may differ from the measurement
  std::optional<msg::DepthBound> within{};  ///< nullopt with `moved`: the bound is unknown
};

/// Reads the fidelity from a message. A bound that is negative, not finite, or above 1 m counts as unknown; `moved` is
/// kept.
[[nodiscard]] DepthFidelity depth_fidelity(const msg::DepthImage& image);
[[nodiscard]] DepthFidelity depth_fidelity(const msg::SurfaceReport& report);

/// The bound in the form that the depth encoder needs, for depth that is compressed again; nullopt: lossless.
[[nodiscard]] std::optional<DepthLoss> loss_of(const DepthFidelity& told) noexcept;

/// The fidelity with the looser bound; of two equal ones the newer.
[[nodiscard]] DepthFidelity less_exact(const DepthFidelity& older, const DepthFidelity& newer);

/// Text for reports: "as measured", "off by up to 2.85 mm at 1 m".
[[nodiscard]] std::string how_far(const DepthFidelity& told);

/// Text for reports with the mode first: "bounded, off by up to 2.85 mm at 1 m".
[[nodiscard]] std::string in_words(const DepthFidelity& told);

/// The bound on the error of a depth of 1 m [mm].
[[nodiscard]] double at_1_m_mm(const msg::DepthBound& bound) noexcept;

}  // namespace telepalp::wire
