#include "server/pipeline/window_stage.h"

namespace telepalp::pipeline {
namespace {

codec::DepthStreamSettings with_windows(codec::DepthStreamSettings depth) {
  const bool predicts = depth.mode == codec::DepthMode::Temporal || depth.mode == codec::DepthMode::Bounded;
  depth.mode = predicts ? codec::DepthMode::Temporal : codec::DepthMode::Intra;
  return depth;
}

std::optional<DepthWindow> window_in(const RgbdFrame& frame, const std::optional<DepthWindow>& wanted) {
  if (!wanted || frame.loss) return std::nullopt;
  const std::optional<PixelRect> exact = clipped(wanted->exact, frame.depth.width, frame.depth.height);
  if (!exact) return std::nullopt;
  return DepthWindow{.exact = *exact, .near = wanted->near, .border = wanted->border};
}

}  // namespace

WindowStage::WindowStage(const codec::DepthStreamSettings& depth) : settings_(with_windows(depth)) {}

void WindowStage::lost_frame() noexcept {
  if (encoder_) encoder_->request_key_frame();
}

codec::EncodedDepth WindowStage::encode(const RgbdFrame& frame, const std::optional<DepthWindow>& window) {
  if (!encoder_) encoder_.emplace(settings_);
  if (wire::key_frame_is_due(pacing_)) encoder_->request_key_frame();
  codec::EncodedDepth encoded = encoder_->encode(frame.depth, window_in(frame, window));
  pacing_ = wire::after_encoding(pacing_, encoded.key_frame);
  return encoded;
}

}  // namespace telepalp::pipeline
