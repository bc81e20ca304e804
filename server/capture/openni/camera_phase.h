#pragma once

#include <cstdint>

namespace telepalp::server {

/// States and events of a camera that may be unplugged.
enum class CameraPhase : std::uint8_t { Waiting, Live, Lost, Ended };
enum class CameraEvent : std::uint8_t { FrameCame, FellSilent, WentAway, CameBack, RecordingEnded };

struct CameraRow {
  CameraPhase from;
  CameraEvent on;
  CameraPhase to;
};

inline constexpr CameraRow kCameraTransitions[] = {
    {CameraPhase::Waiting, CameraEvent::FrameCame, CameraPhase::Live},
    {CameraPhase::Waiting, CameraEvent::FellSilent, CameraPhase::Lost},
    {CameraPhase::Waiting, CameraEvent::WentAway, CameraPhase::Lost},
    {CameraPhase::Waiting, CameraEvent::RecordingEnded, CameraPhase::Ended},
    {CameraPhase::Live, CameraEvent::FellSilent, CameraPhase::Lost},
    {CameraPhase::Live, CameraEvent::WentAway, CameraPhase::Lost},
    {CameraPhase::Live, CameraEvent::RecordingEnded, CameraPhase::Ended},
    {CameraPhase::Lost, CameraEvent::CameBack, CameraPhase::Waiting},
};

/// The next state; a pair that is not in the table leaves the state unchanged.
[[nodiscard]] constexpr CameraPhase next(CameraPhase phase, CameraEvent event) noexcept {
  for (const CameraRow& row : kCameraTransitions)
    if (row.from == phase && row.on == event) return row.to;
  return phase;
}

}  // namespace telepalp::server
