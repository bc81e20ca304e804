#pragma once

#include <deque>
#include <map>
#include <vector>

#include "codec/depth_stream.h"
#include "proto/wire/key_frame_request.h"
#include "tools/replay/cell/camera_path.h"
#include "tools/replay/source/tape.h"

namespace telepalp::replay {

/// The server's side of a run: offers each frame to the path once its encoding is done. Frames that are predicted from
/// others are encoded here, because the losses of this run decide which are key frames.
class FrameSender {
 public:
  FrameSender(const Scenario& scenario, const TapeSettings& tape);

  void captured(std::shared_ptr<const TapeFrame> frame) { captured_.push_back(std::move(frame)); }
  /// Call each tick before exchange(). Offers the frames encoded by `now`; drops them while the server is down.
  void step(SessionTime now, CameraPath& path, Stopwatch& watch);

  /// The frame that was offered with `number`; nullptr: none, or offered so long ago that it can no longer arrive.
  [[nodiscard]] std::shared_ptr<const TapeFrame> sent(std::uint32_t number);
  /// Capture times of the frames that were offered, in order.
  [[nodiscard]] const std::vector<SessionTime>& offered() const noexcept { return offered_; }
  [[nodiscard]] std::uint64_t offered_B() const noexcept { return offered_B_; }

 private:
  void offer(const std::shared_ptr<const TapeFrame>& frame, CameraPath& path, Stopwatch& watch);
  [[nodiscard]] std::string encoded(const TapeFrame& frame, bool& key_frame);

  Scenario scenario_;
  TapeSettings tape_;
  codec::DepthEncoder encoder_;
  wire::KeyFramePacing pacing_;
  std::deque<std::shared_ptr<const TapeFrame>> captured_;
  std::map<std::uint32_t, std::shared_ptr<const TapeFrame>> sent_;  ///< by number; the frames that may still arrive
  std::vector<SessionTime> offered_;
  std::uint64_t offered_B_ = 0;
};

}  // namespace telepalp::replay
