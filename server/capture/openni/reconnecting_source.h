#pragma once

#include <functional>
#include <memory>
#include <string>

#include "server/capture/capture_source.h"
#include "server/capture/openni/camera_device.h"
#include "server/capture/openni/camera_phase.h"
#include "server/capture/openni/timestamp_map.h"

namespace telepalp::server {

/// Time as the reconnecting source needs it: the session clock, or a test's.
struct SourceTime {
  std::function<SessionTime()> now;
  std::function<void(Nanoseconds)> sleep;
};

/// A camera that survives being unplugged: while it is lost, it is opened again once a second, and state() and
/// detail() say so. Driver timestamps become session times.
class ReconnectingSource final : public CaptureSource {
 public:
  static constexpr Nanoseconds kSilence{2'000'000'000};  ///< no frame for so long means lost
  static constexpr Nanoseconds kRetry{1'000'000'000};

  /// `device` is open already.
  ReconnectingSource(std::unique_ptr<CameraDevice> device, SourceTime time);

  std::optional<RgbdFrame> next(Nanoseconds patience) override;
  [[nodiscard]] CaptureState state() const override;
  [[nodiscard]] std::string detail() const override;

 private:
  void lose(CameraEvent event, const std::string& why);
  void try_again(Nanoseconds patience);
  RgbdFrame stamped(CameraDevice::Frame frame);

  std::unique_ptr<CameraDevice> device_;
  SourceTime time_;
  TimestampMap timestamps_;
  CameraPhase phase_ = CameraPhase::Waiting;
  SessionTime last_sign_;  // of life: a frame, or an opening
  SessionTime last_try_;
  std::string why_lost_;
  std::uint64_t sequence_ = 0;
  std::uint64_t times_lost_ = 0;
};

}  // namespace telepalp::server
