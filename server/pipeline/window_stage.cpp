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

codec::EncodedDepth WindowStage::encode(const RgbdFrame& frame, const std::optional<DepthWindow>& window) {
  return encode_paced(settings_, frame.depth, window_in(frame, window));
}

}  // namespace telepalp::pipeline
