#include "tools/replay/cell/frame_sender.h"

#include <span>

#include "server/pipeline/camera_messages.h"

namespace telepalp::replay {
namespace {

/// A frame may still arrive for this long after its capture.
Nanoseconds may_arrive_for(const Scenario& scenario) noexcept {
  constexpr Nanoseconds kBeyondDelay = std::chrono::seconds(3);
  return kBeyondDelay + scenario.down.delay + scenario.down.jitter + scenario.down.reorder_by;
}

std::vector<std::byte> bytes_of(const std::string& text) {
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

}  // namespace

FrameSender::FrameSender(const Scenario& scenario, const TapeSettings& tape)
    : scenario_(scenario), tape_(tape), encoder_(tape.depth) {}

/// A server that is away captures nothing, and begins with a key frame afterwards.
void FrameSender::step(SessionTime now, CameraPath& path, Stopwatch& watch) {
  if (path.key_frame_wanted(now)) pacing_.requested = true;
  while (!captured_.empty() && captured_.front()->frame.captured + scenario_.stages.encode <= now) {
    const std::shared_ptr<const TapeFrame> frame = captured_.front();
    captured_.pop_front();
    if (!path.server_is_away(now)) {
      offer(frame, path, watch);
      continue;
    }
    encoder_.request_key_frame();
  }
}

std::string FrameSender::encoded(const TapeFrame& frame, bool& key_frame) {
  if (key_frame_is_due(pacing_)) encoder_.request_key_frame();
  codec::EncodedDepth encoded = encoder_.encode(frame.frame.depth);
  key_frame = encoded.key_frame;
  pacing_ = after_encoding(pacing_, key_frame);
  msg::DepthImage message = pipeline::depth_message(frame.frame, std::move(encoded));
  message.set_encoded_ns(static_cast<std::uint64_t>(to_nanoseconds(frame.frame.captured + scenario_.stages.encode)));
  return message.SerializeAsString();
}

void FrameSender::offer(const std::shared_ptr<const TapeFrame>& frame, CameraPath& path, Stopwatch& watch) {
  bool key_frame = true;
  const std::string depth =
      frame->depth.empty() ? watch.time(Part::Encode, [&] { return encoded(*frame, key_frame); }) : frame->depth;
  offered_.push_back(frame->frame.captured);
  offered_B_ += depth.size() + frame->color.size();
  sent_.emplace(frame->number, frame);
  const SessionTime captured = frame->frame.captured;
  while (captured - sent_.begin()->second->frame.captured > may_arrive_for(scenario_)) sent_.erase(sent_.begin());
  // A replaced frame was never sent, so no later frame may be predicted from it.
  if (path.offer({.channel = kDepthChannel,
                  .number = frame->number,
                  .key_frame = key_frame,
                  .captured = captured,
                  .bytes = bytes_of(depth)}))
    encoder_.request_key_frame();
  if (!frame->color.empty())
    path.offer({.channel = kColorChannel,
                .number = frame->number,
                .key_frame = true,
                .captured = captured,
                .bytes = bytes_of(frame->color)});
}

std::shared_ptr<const TapeFrame> FrameSender::sent(std::uint32_t number) {
  const auto found = sent_.find(number);
  return found == sent_.end() ? nullptr : found->second;
}

}  // namespace telepalp::replay
