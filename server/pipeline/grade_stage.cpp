#include "server/pipeline/grade_stage.h"

#include <algorithm>
#include <utility>

#include "proto/link/datagram_link.h"
#include "server/pipeline/camera_messages.h"

namespace telepalp::pipeline {
namespace {

/// Depth this coarse costs few bytes. It shows little more than which pixels were measured.
constexpr DepthErrorBound kCoarsest{.least_m = 0.25, .per_m = 0.25};
constexpr double kMostBound = 1.0;  ///< a window with larger bounds is not valid (DepthWindow)

DepthErrorBound times(double factor, const DepthErrorBound& bound) {
  return {.least_m = std::min(kMostBound, factor * bound.least_m), .per_m = std::min(kMostBound, factor * bound.per_m)};
}

DepthErrorBound coarsest(const DepthErrorBound& asked) {
  return {.least_m = std::max(asked.least_m, kCoarsest.least_m), .per_m = std::max(asked.per_m, kCoarsest.per_m)};
}

/// `asked` with the bounds around the window that image `number` of those with a window has.
DepthWindow made_coarser(DepthWindow asked, const plan::ImageSettings& settings, std::uint64_t number) {
  const bool is_coarsest = number % static_cast<std::uint64_t>(std::max(1, settings.outside_every)) != 0;
  for (DepthErrorBound* const bound : {&asked.near, &asked.border})
    *bound = is_coarsest ? coarsest(*bound) : times(settings.outside_factor, *bound);
  return asked;
}

}  // namespace

GradeStage::GradeStage(const EncodeOptions& asked, const wire::SessionClock& clock,
                       std::function<bool(wire::Message)> publish)
    : asked_(asked),
      options_(asked),
      clock_(clock),
      publish_(std::move(publish)),
      video_(asked.video_kbit_per_s),
      window_(asked.depth) {}

void GradeStage::want(const GradeWanted& wanted) {
  const plan::ImageSettings before = std::exchange(wanted_, wanted).settings;
  const plan::ImageSettings& now = wanted_.settings;
  if (before != now) {
    options_ = with(asked_, now);
    video_.set_rate(options_.video_kbit_per_s);
  }
  if (!wanted_.depth.whole || before.level != now.level || before.whole_factor != now.whole_factor) whole_.end();
  if (!wanted_.depth.window) window_.end();
  if (!wanted_.color.video) video_.end();
}

void GradeStage::request_key_frames(const RequestedKeyFrames& requested) noexcept {
  if (requested.whole) whole_.request_key_frame();
  if (requested.window) window_.request_key_frame();
  if (requested.video) video_.request_key_frame();
}

void GradeStage::forget_depth() noexcept {
  whole_.lost_frame();
  window_.lost_frame();
}

bool GradeStage::is_left_out_by_level(std::uint64_t number) const noexcept {
  return link::ContentLevel::leaves_out(wanted_.settings.level, number);
}

void GradeStage::publish_depth(const RgbdFrame& frame, std::uint64_t number, const std::optional<DepthWindow>& window) {
  if (!plan::sends(wanted_.settings.depth_share, number)) return;
  if (wanted_.depth.window) publish_window(frame, window);  // first: the hand waits for it
  if (wanted_.depth.whole && !is_left_out_by_level(number)) publish_whole(frame);
}

void GradeStage::publish_whole(const RgbdFrame& frame) {
  codec::EncodedDepth coded = whole_.encode_paced(options_.depth, frame.depth);
  if (!publish_depth_as(wire::kCameraDepth, frame, std::move(coded))) whole_.lost_frame();
}

void GradeStage::publish_window(const RgbdFrame& frame, const std::optional<DepthWindow>& window) {
  std::optional<DepthWindow> coarser = window;
  if (window) coarser = made_coarser(*window, wanted_.settings, windows_);
  ++windows_;
  codec::EncodedDepth coded = window_.encode(frame, coarser);
  if (!publish_depth_as(wire::kCameraDepthWindow, frame, std::move(coded))) window_.lost_frame();
}

/// False: the message was dropped. A dropped frame cannot be a reference, so the next one must be a key frame.
bool GradeStage::publish_depth_as(const wire::Topic& topic, const RgbdFrame& frame, codec::EncodedDepth coded) {
  const bool is_key = coded.key_frame;
  msg::DepthImage depth = depth_message(frame, std::move(coded));
  const SessionTime encoded = clock_.now();
  depth.set_encoded_ns(static_cast<std::uint64_t>(to_nanoseconds(encoded)));
  return publish_(wire::make_message(topic, encoded, depth, is_key));
}

void GradeStage::publish_color(const RgbdFrame& frame, std::uint64_t number) {
  if (frame.color.rgb.empty() || is_left_out_by_level(number)) return;
  if (!plan::sends(wanted_.settings.color_share, number)) return;
  if (wanted_.color.video) publish_video(frame);
  if (!wanted_.color.pictures) return;
  const foxglove::CompressedImage color = color_message(frame, options_.jpeg_quality);
  publish_(wire::make_message(wire::kCameraColor, clock_.now(), color));
}

void GradeStage::publish_video(const RgbdFrame& frame) {
  std::optional<codec::EncodedVideo> encoded = video_.encode(frame);
  if (!encoded) return;
  const bool is_key = encoded->key_frame;
  const foxglove::CompressedVideo color = video_message(frame, std::move(encoded->bytes));
  if (!publish_(wire::make_message(wire::kCameraColorVideo, clock_.now(), color, is_key))) video_.lost_frame();
}

}  // namespace telepalp::pipeline
