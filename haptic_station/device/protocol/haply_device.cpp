#include "haptic_station/device/protocol/haply_device.h"

#include <limits>
#include <utility>

namespace telepalp::device {
namespace {

constexpr std::chrono::microseconds kPace{400};
constexpr std::chrono::milliseconds kForceCountsFor{50};
constexpr std::chrono::milliseconds kHandleCountsFor{100};

}  // namespace

HaplyDevice::HaplyDevice(WebSocketUrl url, const Point<haply::InverseBase>& origin, Say say)
    : name_("device " + to_string(url)),
      say_(std::move(say)),
      haptic_from_inverse_(haply::haptic_from_inverse(origin)),
      inverse_from_haptic_(haptic_from_inverse_.inverse()),
      pace_(thread_.io()),
      line_(thread_.io(), std::move(url), {.most_text_bytes = haply::kMostTextBytes},
            {.on_open = [this] { thread_.obstacle("the Haply Inverse service lists no Inverse3"); },
             .on_text = [this](std::string_view text) { on_text(text); },
             .on_lost =
                 [this](const std::string& why) {
                   pace_.cancel();
                   if (thread_.obstacle().empty() || line_is_up_ || device_id_.empty()) thread_.obstacle(why);
                   if (std::exchange(line_is_up_, false))
                     say_(name_ + ": the connection is lost: " + why + "; the station tries to connect again");
                 }}) {}

HaplyDevice::~HaplyDevice() { thread_.stop(); }

Result<void> HaplyDevice::start(std::chrono::milliseconds limit) {
  boost::asio::post(thread_.io(), [this] { line_.start(); });
  thread_.run();
  if (thread_.wait_for_answer(limit)) return {};
  return Error{
      .what = "is not ready: " + thread_.obstacle(),
      .where = name_,
      .fix =
          "start the Haply Inverse service, 3.1 or later, at this address, with an Inverse3 plugged in, or try "
          "the station without a device by --device simulated"};
}

void HaplyDevice::on_text(std::string_view text) {
  const auto read = haply::parse_text(text, device_id_);
  if (!read) {
    if (refused_.fetch_add(1, std::memory_order_relaxed) == 0) say_(name_ + ": " + to_string(read.error()));
    thread_.obstacle(read.error().what);  // without its fix, because start() gives one
  } else if (*read) {
    const haply::State& state = **read;
    if (!std::exchange(line_is_up_, true))
      say_(name_ + ": the Haply Inverse service answers; device_id of its Inverse3: " + state.device_id);
    device_id_ = state.device_id;
    if (state.pressed) pressed_ = {Clock::now(), *state.pressed};
    if (state.attitude) attitude_ = {Clock::now(), haply::in_haptic_axes(*state.attitude)};
    readings_.put({Clock::now(),
                   {.at = haptic_from_inverse_ * state.cursor,
                    .velocity = haptic_from_inverse_ * state.velocity,
                    .attitude = newest_attitude(),
                    .pressed = pressed_.second && Clock::now() - pressed_.first < kHandleCountsFor},
                   answered_});
    thread_.answered();
  }
  answer();
}

/// A handle sends more slowly than the Inverse3, so not every text has its attitude.
std::optional<Eigen::Quaterniond> HaplyDevice::newest_attitude() const {
  if (!attitude_ || Clock::now() - attitude_->first > kHandleCountsFor) return std::nullopt;
  return attitude_->second;
}

/// The service sends one text for each text that it gets. Without this answer it would send no further state.
void HaplyDevice::answer() {
  if (device_id_.empty()) return;
  const Clock::time_point due = sent_ + kPace;
  if (due <= Clock::now()) return send_force();
  pace_.expires_at(due);
  pace_.async_wait([this](const boost::system::error_code& error) {
    if (!error) send_force();
  });
}

void HaplyDevice::send_force() {
  sent_ = Clock::now();
  (void)wanted_.take();
  const Wanted& wanted = wanted_.current();
  const bool counts = sent_ - wanted.at < kForceCountsFor;
  answered_ = counts ? std::optional(wanted.at) : std::nullopt;
  line_.send(haply::force_text(device_id_, counts ? inverse_from_haptic_ * wanted.force : Force<haply::InverseBase>{}));
}

ports::DeviceReading HaplyDevice::read() noexcept {
  if (readings_.take()) has_reading_ = true;
  ports::DeviceReading reading = readings_.current().reading;
  const Clock::time_point now = Clock::now();
  reading.age_s = has_reading_ ? std::chrono::duration<double>(now - readings_.current().at).count()
                               : std::numeric_limits<double>::infinity();
  if (const auto& echoes = readings_.current().echoes)
    reading.loop_s = std::chrono::duration<double>(now - *echoes).count();
  return reading;
}

void HaplyDevice::apply(const Wrench<HapticBase>& wrench, const ports::SurfaceContact&, double) noexcept {
  wanted_.put({Clock::now(), wrench.force});
}

}  // namespace telepalp::device
