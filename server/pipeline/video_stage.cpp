#include "server/pipeline/video_stage.h"

namespace telepalp::pipeline {

void VideoStage::set_rate(int kbit_per_s) {
  kbit_per_s_ = kbit_per_s;
  if (encoder()) encoder()->set_rate(kbit_per_s);
}

std::optional<codec::EncodedVideo> VideoStage::encode(const RgbdFrame& frame) {
  if (frame.color.rgb.empty() || !codec::ColorVideoEncoder::can_encode(frame.color)) return std::nullopt;
  return encode_paced(codec::ColorVideoSettings{.kbit_per_s = kbit_per_s_}, frame.color, frame.captured);
}

}  // namespace telepalp::pipeline
