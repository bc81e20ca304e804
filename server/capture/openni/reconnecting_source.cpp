#include "server/capture/openni/reconnecting_source.h"

#include <algorithm>
#include <utility>

#include "proto/words/counted.h"

namespace telepalp::capture {

ReconnectingSource::ReconnectingSource(std::unique_ptr<CameraDevice> device, SourceTime time)
    : device_(std::move(device)), time_(std::move(time)), last_sign_(time_.now()) {}

std::optional<RgbdFrame> ReconnectingSource::next(Nanoseconds patience) {
  const SessionTime until = time_.now() + patience;
  if (phase_ == CameraPhase::Lost) try_again(patience);
  if (phase_ == CameraPhase::Lost || phase_ == CameraPhase::Ended) {
    time_.sleep(std::max(until - time_.now(), Nanoseconds{0}));
    return std::nullopt;
  }
  CameraDevice::Read read = device_->read(until - time_.now());
  if (auto* frame = std::get_if<CameraDevice::Frame>(&read)) return stamped(std::move(*frame));
  if (const auto* gone = std::get_if<CameraDevice::Gone>(&read)) {
    lose(CameraEvent::WentAway, gone->why);
  } else if (std::holds_alternative<CameraDevice::Ended>(read)) {
    phase_ = capture::next(phase_, CameraEvent::RecordingEnded);
    device_->close();
  } else if (time_.now() - last_sign_ > kSilence) {
    lose(CameraEvent::FellSilent, "no frame arrived for 2 s");
  }
  return std::nullopt;
}

RgbdFrame ReconnectingSource::stamped(CameraDevice::Frame frame) {
  phase_ = capture::next(phase_, CameraEvent::FrameCame);
  last_sign_ = frame.arrival;
  frame.frame.captured = timestamps_.map(frame.driver_time, frame.arrival);
  frame.frame.sequence = sequence_++;
  return std::move(frame.frame);
}

void ReconnectingSource::lose(CameraEvent event, const std::string& why) {
  phase_ = capture::next(phase_, event);
  why_lost_ = why;
  last_try_ = time_.now();
  ++times_lost_;
  device_->close();
}

void ReconnectingSource::try_again(Nanoseconds patience) {
  const Nanoseconds wait = last_try_ + kRetry - time_.now();
  if (wait > patience) return;
  if (wait > Nanoseconds{0}) time_.sleep(wait);
  last_try_ = time_.now();
  const Result<void> opened = device_->open();
  if (!opened) return;
  if (wanted_) (void)device_->set_exposure(*wanted_);
  last_sign_ = time_.now();
  phase_ = capture::next(phase_, CameraEvent::CameBack);
}

std::optional<ExposureLimits> ReconnectingSource::exposure_limits() const {
  return phase_ == CameraPhase::Lost ? std::nullopt : device_->exposure_limits();
}

Exposure ReconnectingSource::exposure() const {
  if (wanted_) return *wanted_;
  return exposure_limits() ? device_->exposure() : Exposure{};
}

Result<void> ReconnectingSource::set_exposure(const Exposure& exposure) {
  if (!exposure_limits()) return CaptureSource::set_exposure(exposure);
  if (!device_->set_exposure(exposure))
    return Error{.what = "the camera's driver refuses this exposure or gain",
                 .where = device_->describe(),
                 .fix = "choose other values, or leave the exposure to the camera"};
  wanted_ = exposure;
  return {};
}

CaptureState ReconnectingSource::state() const {
  switch (phase_) {
    case CameraPhase::Waiting:
      return CaptureState::Waiting;
    case CameraPhase::Live:
      return CaptureState::Live;
    case CameraPhase::Lost:
      return CaptureState::Lost;
    case CameraPhase::Ended:
      return CaptureState::Ended;
  }
  return CaptureState::Waiting;
}

std::string ReconnectingSource::detail() const {
  if (phase_ == CameraPhase::Lost)
    return device_->describe() + " is lost: " + why_lost_ +
           ". fix: plug the camera in again; the server looks for it once a second";
  const std::string lost = times_lost_ == 0 ? "" : "; was lost " + counted(times_lost_, "time", "times");
  return device_->describe() + lost;
}

}  // namespace telepalp::capture
