#include "server/pipeline/video_stage.h"

namespace telepalp::pipeline {

void VideoStage::set_rate(int kbit_per_s) {
  kbit_per_s_ = kbit_per_s;
  if (encoder_) encoder_->set_rate(kbit_per_s);
}

void VideoStage::lost_frame() noexcept {
  if (encoder_) encoder_->request_key_frame();
}

std::optional<codec::EncodedVideo> VideoStage::encode(const RgbdFrame& frame) {
  if (frame.color.rgb.empty() || !codec::ColorVideoEncoder::can_encode(frame.color)) return std::nullopt;
  if (!encoder_) encoder_.emplace(codec::ColorVideoSettings{.kbit_per_s = kbit_per_s_});
  if (wire::key_frame_is_due(pacing_)) encoder_->request_key_frame();
  codec::EncodedVideo encoded = encoder_->encode(frame.color, frame.captured);
  pacing_ = wire::after_encoding(pacing_, encoded.key_frame);
  return encoded;
}

}  // namespace telepalp::pipeline
