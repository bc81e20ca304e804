#include "tools/replay/cell/cell.h"

#include <algorithm>
#include <span>
#include <utility>

namespace telepalp::replay {
namespace {

constexpr std::size_t kMostRecent = 256;

const effects::SkinLaw* law_of(const scenes::Scene& scene) {
  return scene.skin() == nullptr ? nullptr : &scene.skin()->law;
}

/// The message of an arrived frame. Its image is known if the tape has decoded the same bytes.
core::ArrivedDepth depth_of(const link::Frame& frame, const std::shared_ptr<const TapeFrame>& taped, SessionTime now) {
  const auto bytes = std::as_bytes(std::span(taped->depth));
  const bool known = std::equal(bytes.begin(), bytes.end(), frame.bytes.begin(), frame.bytes.end());
  const auto payload = known ? std::shared_ptr<const std::string>(taped, &taped->depth)  // shared: the tape's own bytes
                             : std::make_shared<const std::string>(reinterpret_cast<const char*>(frame.bytes.data()),
                                                                   frame.bytes.size());
  return {.depth = {.topic = wire::kCameraDepth,
                    .published = frame.captured,
                    .payload = payload,
                    .key_frame = frame.key_frame},
          .camera = taped->frame.camera.depth,
          .received = now,
          .decoded = known ? std::shared_ptr<const DepthImage>(taped, &taped->frame.depth) : nullptr};
}

}  // namespace

Cell::Cell(const StationSetup& setup, const Scenario& scenario, const TapeSettings& tape, TruthAt truth,
           Publish publish, Wires wires)
    : setup_(setup),
      scenario_(scenario),
      truth_(std::move(truth)),
      watch_(tape.clock),
      sender_(scenario, tape),
      path_(scenario, std::move(wires)),
      station_(setup, scenario, std::move(publish)) {}

FrameCounts Cell::frames() const noexcept {
  const auto due = [this](const std::vector<SessionTime>& captured) {
    return static_cast<std::uint64_t>(std::count_if(
        captured.begin(), captured.end(), [this](SessionTime at) { return at + scenario_.deadline <= now_; }));
  };
  return {.offered = due(sender_.offered()),
          .in_time = due(in_time_),
          .touched = due(touched_),
          .undecodable = station_.undecodable(),
          .offered_B = sender_.offered_B()};
}

void Cell::count_complete(const link::Frame& frame, bool has_color, SessionTime now) {
  if (now - frame.captured > scenario_.deadline) return;
  int& complete = complete_[frame.number];
  if (++complete == (has_color ? 2 : 1)) in_time_.push_back(frame.captured);
  if (complete_.size() > kMostRecent) complete_.erase(complete_.begin());
}

void Cell::receive(const link::Frame& frame, SessionTime now) {
  const std::shared_ptr<const TapeFrame> taped = sender_.sent(frame.number);
  count_complete(frame, taped && !taped->color.empty(), now);
  if (frame.channel == kDepthChannel && frame.newest && taped) station_.arrived(depth_of(frame, taped, now));
}

TickRecord Cell::tick() {
  sender_.step(now_, path_, watch_);
  watch_.sample(Part::Link, [&] { path_.exchange(now_); });
  while (const auto frame = path_.take(now_)) receive(*frame, now_);
  const TickOutcome outcome = station_.tick(now_, watch_);
  if (station_.key_frame_wanted()) path_.request_key_frame(now_);
  if (auto times = station_.touchable()) {
    touched_.push_back(session_time(times->captured_ns));
    touchable_.push_back(*times);
  }
  return watch_.sample(Part::Judge, [&] {
    return judged(outcome, setup_.haptic_from_camera, truth_ ? std::optional(truth_(now_)) : std::nullopt,
                  law_of(setup_.scene), setup_.scene.control.limits.peak_N);
  });
}

void Cell::run_until(SessionTime until, const TapeFrames& frames, std::vector<TickRecord>& ticks) {
  touchable_.clear();
  for (const auto& frame : frames) sender_.captured(frame);
  for (; now_ < until; now_ += kTick) ticks.push_back(tick());
}

}  // namespace telepalp::replay
