#include "tools/replay/cell/surface_stage.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "messages/camera.pb.h"

namespace telepalp::replay {
namespace {

bool equals(const std::vector<std::byte>& bytes, const std::string& text) noexcept {
  return bytes.size() == text.size() && std::memcmp(bytes.data(), text.data(), bytes.size()) == 0;
}

}  // namespace

SurfaceStage::SurfaceStage(const StageTimes& stages, const surface::SurfaceSettings& settings,
                           const Transform<HapticBase, DepthCamera>& haptic_from_camera,
                           const effects::EffectBank& effects)
    : stages_(stages), haptic_from_camera_(haptic_from_camera), builder_(settings) {
  builder_.watch(loop::mark_lines(effects, haptic_from_camera.inverse()));
}

std::optional<BuiltSurface> SurfaceStage::step(SessionTime now, const Point<HapticBase>& device, Stopwatch& watch) {
  if (in_work_ && session_time(in_work_->times.touchable_ns) <= now) return std::exchange(in_work_, std::nullopt);
  if (!in_work_ && !waiting_.empty() && busy_until_ <= now) begin_newest(now, device, watch);
  return std::nullopt;
}

/// The depth of an arrived frame; nullptr: it cannot be decoded. Bytes that the tape has decoded before are not decoded
/// again.
const DepthImage* SurfaceStage::depth_of(const ArrivedDepth& frame, Stopwatch& watch) {
  if (frame.taped && equals(frame.bytes, frame.taped->depth)) return &frame.taped->frame.depth;
  return watch.time(Part::Decode, [&]() -> const DepthImage* {
    msg::DepthImage message;
    if (!message.ParseFromArray(frame.bytes.data(), static_cast<int>(frame.bytes.size()))) return nullptr;
    Result<codec::DecodedDepth> decoded = reader_.read(std::as_bytes(std::span(message.data())));
    if (!decoded) return nullptr;
    decoded_ = std::move(decoded->image);
    return &decoded_;
  });
}

void SurfaceStage::begin_newest(SessionTime now, const Point<HapticBase>& device, Stopwatch& watch) {
  for (; waiting_.size() > 1; waiting_.pop_front()) {
    msg::DepthImage message;
    const auto& bytes = waiting_.front().bytes;
    const bool independent = waiting_.front().taped && !waiting_.front().taped->depth.empty();
    if (!independent && message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
      reader_.skip(std::move(*message.mutable_data()));
  }
  const ArrivedDepth frame = std::move(waiting_.front());
  waiting_.pop_front();
  const SessionTime decoded = now + stages_.decode;
  busy_until_ = decoded;
  const DepthImage* depth = depth_of(frame, watch);
  if (depth == nullptr || !frame.taped) {
    ++undecodable_;
    return;
  }
  const TapeFrame& taped = *frame.taped;
  auto snapshot = watch.time(Part::Build, [&] {
    return builder_.add(*depth, taped.frame.camera.depth, taped.frame.captured,
                        surface::Reach{.centre = haptic_from_camera_.inverse() * device, .radius_m = surface::kReach_m});
  });
  if (!snapshot) return;
  busy_until_ = decoded + stages_.build;
  in_work_ = BuiltSurface{.surface = {std::move(snapshot), haptic_from_camera_},
                          .times = {.number = taped.number,
                                    .captured_ns = to_nanoseconds(taped.frame.captured),
                                    .encoded_ns = to_nanoseconds(taped.frame.captured + stages_.encode),
                                    .received_ns = to_nanoseconds(frame.received),
                                    .decoded_ns = to_nanoseconds(decoded),
                                    .touchable_ns = to_nanoseconds(busy_until_)},
                          .build_s = to_seconds(stages_.build)};
}

}  // namespace telepalp::replay
