#include "haptic_station/tracking/protocol/leap_tracker.h"

#include <utility>

namespace telepalp::tracking {

LeapTracker::LeapTracker(device::WebSocketUrl url, const Transform<HapticBase, HandTracker>& haptic_from_tracker,
                         Say say)
    : name_("tracker " + device::to_string(url)),
      say_(std::move(say)),
      line_(thread_.io(), std::move(url), {.most_text_bytes = leap::kMostTextBytes},
            {.on_open =
                 [this] {
                   spoke_ = false;
                   line_.send(std::string(leap::wish_for_background_frames()));
                 },
             .on_text = [this](std::string_view text) { on_text(text); },
             .on_lost =
                 [this](const std::string& why) {
                   thread_.obstacle(why);
                   if (std::exchange(line_is_up_, false))
                     say_(name_ + ": the connection is lost: " + why + "; the station tries to connect again");
                 }}),
      haptic_from_tracker_(haptic_from_tracker) {}

LeapTracker::~LeapTracker() { thread_.stop(); }

Result<void> LeapTracker::start(std::chrono::milliseconds limit) {
  boost::asio::post(thread_.io(), [this] { line_.start(); });
  thread_.run();
  if (thread_.wait_for_answer(limit)) return {};
  return Error{.what = "is not ready: " + thread_.obstacle(),
               .where = name_,
               .fix =
                   "start, at this address, a Leap service that speaks version 6 of the Leap protocol (/v6.json), and "
                   "allow WebSockets in its settings; or try the station without a tracker by --device simulated "
                   "--tracker simulated"};
}

void LeapTracker::refuse(const std::string& why) {
  if (refused_.fetch_add(1, std::memory_order_relaxed) == 0) say_(name_ + ": " + why);
  thread_.obstacle(why);
}

void LeapTracker::on_text(std::string_view text) {
  const Result<leap::Text> read = leap::parse_text(text);
  if (!read) {
    refuse(to_string(read.error()));
    return thread_.obstacle(read.error().what);  // without its fix, because start() gives one
  }
  if (const auto* hello = std::get_if<leap::Hello>(&*read)) on_hello(*hello);
  if (const auto* frame = std::get_if<leap::Frame>(&*read)) on_frame(*frame);
}

void LeapTracker::on_hello(const leap::Hello& hello) {
  spoke_ = hello.version == leap::kProtocolVersion;
  if (!spoke_)
    return refuse("the Leap service speaks version " + std::to_string(hello.version) +
                  " of the Leap protocol, not version 6, which telepalp needs");
  if (!std::exchange(line_is_up_, true))
    say_(name_ + ": the Leap service answers; its version: " + hello.service_version.substr(0, 64));
  thread_.answered();
}

void LeapTracker::on_frame(const leap::Frame& frame) {
  if (!spoke_) return;
  if (frame.refused > 0) refused_.fetch_add(frame.refused, std::memory_order_relaxed);
  const std::chrono::microseconds service_time(frame.timestamp_us);
  const auto at = service_clock_.map(service_time, Clock::now().time_since_epoch());
  if (const auto hand = followed_.choose(std::chrono::duration<double>(service_time).count(), frame.hands))
    latest_hand_.put(Clock::time_point(at), hand->palm, hand->attitude);
}

std::optional<ports::HandSample> LeapTracker::sample(SessionTime now, const ports::DeviceReading&) noexcept {
  const auto seen = latest_hand_.take(now);
  if (!seen) return std::nullopt;
  ports::HandSample sample{seen->at, haptic_from_tracker_ * seen->hand, std::nullopt};
  if (seen->attitude) sample.attitude = Eigen::Quaterniond(haptic_from_tracker_.iso.linear()) * *seen->attitude;
  return sample;
}

std::optional<Point<HandTracker>> LeapTracker::palm() noexcept {
  const auto seen = latest_hand_.take();
  return seen ? std::optional(seen->hand) : std::nullopt;
}

}  // namespace telepalp::tracking
