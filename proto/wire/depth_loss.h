#pragma once

#include <optional>
#include <string>

#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::wire {

/// What a message tells of its depth: how it was compressed, and how far that took it from what the camera measured.
struct DepthFidelity {
  std::string mode;                         ///< of the codec; empty: not told
  bool moved = false;                       ///< whether depth may be other than measured
  std::optional<msg::DepthBound> within{};  ///< nullopt though moved: nobody tells by how much
};

/// A bound that is negative, not finite, or beyond a metre is as good as none; that depth was moved is believed all the
/// same.
[[nodiscard]] DepthFidelity depth_fidelity(const msg::DepthImage& image);
[[nodiscard]] DepthFidelity depth_fidelity(const msg::SurfaceReport& report);

/// The same for whoever compresses such depth again; nullopt: it is as measured.
[[nodiscard]] std::optional<DepthLoss> loss_of(const DepthFidelity& told) noexcept;

/// The one of which less may be expected; of two alike the newer one.
[[nodiscard]] DepthFidelity less_exact(const DepthFidelity& older, const DepthFidelity& newer);

/// For people: "as measured", "off by up to 2.85 mm at 1 m".
[[nodiscard]] std::string how_far(const DepthFidelity& told);

/// With the mode before it: "bounded, off by up to 2.85 mm at 1 m".
[[nodiscard]] std::string in_words(const DepthFidelity& told);

/// The furthest that depth at 1 m may be off [mm].
[[nodiscard]] double at_1_m_mm(const msg::DepthBound& bound) noexcept;

}  // namespace telepalp::wire
