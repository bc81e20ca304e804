#include "tools/study/protocol/hands/device_hand.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "haptic_station/loop/tick.h"
#include "haptic_station/station/rigs/rig_choice.h"
#include "haptic_station/station/threads/realtime.h"

namespace telepalp::study {
namespace {

constexpr double kFade_s = 0.03;
constexpr int kTicksPerView = 10;
const double kFadeOfATick = std::exp(-kTick_s / kFade_s);

}  // namespace

/// Ends with the thread no longer working on its penetration.
class DeviceHand::Trial final : public PersonTrial {
 public:
  Trial(DeviceHand& hand, Prepared prepared, Condition condition)
      : hand_(hand), penetration_(std::move(prepared), condition), view_(penetration_.view()) {
    loop::TickSample old;
    while (hand_.ticks_.try_pop(old)) {
    }
    (void)hand_.views_.take();
    hand_.lost_ = 0;
    hand_.work_on(&penetration_);
  }
  ~Trial() override { hand_.work_on(nullptr); }

  void step(double, Ticks& ticks) override {
    if (hand_.views_.take()) view_ = hand_.views_.current();
    for (loop::TickSample tick; hand_.ticks_.try_pop(tick);) ticks.push_back(tick);
  }
  [[nodiscard]] TrialView view() const noexcept override { return view_; }
  [[nodiscard]] bool moves_by_itself() const noexcept override { return true; }
  [[nodiscard]] std::optional<Error> lost() const override {
    const auto lost = static_cast<DevicePenetration::Lost>(hand_.lost_.load(std::memory_order_acquire));
    if (lost == DevicePenetration::Lost::No) return std::nullopt;
    return Error{.what = lost == DevicePenetration::Lost::Silent
                             ? "the haptic device does not answer, so the penetration was broken off"
                             : "the haptic device gives impossible positions, so the penetration was broken off",
                 .where = "--device",
                 .fix = "check the device and its cable, then begin again"};
  }

 private:
  DeviceHand& hand_;
  DevicePenetration penetration_;
  TrialView view_;
};

DeviceHand::DeviceHand(std::unique_ptr<ports::Device> device)
    : device_(std::move(device)), thread_([this] {
        (void)station::enter_realtime(station::Realtime::Prefer);
        run();
      }) {}

DeviceHand::~DeviceHand() {
  running_ = false;
  thread_.join();
}

std::unique_ptr<PersonTrial> DeviceHand::begin(Prepared prepared, Condition condition) {
  return std::make_unique<Trial>(*this, std::move(prepared), condition);
}

void DeviceHand::work_on(DevicePenetration* penetration) noexcept {
  asked_.store(penetration, std::memory_order_release);
  while (worked_.load(std::memory_order_acquire) != penetration)
    std::this_thread::sleep_for(std::chrono::microseconds(200));
}

void DeviceHand::run() noexcept {
  station::TickTimer timer(station::TickTimer::Clock::now() + loop::kTickPeriod, loop::kTickPeriod);
  while (running_.load(std::memory_order_relaxed)) tick(timer.wait());
  device_->apply({}, {}, kTick_s);
}

void DeviceHand::tick(const station::TickTimer::Tick& due) noexcept {
  const double missed_s = static_cast<double>(due.missed) * kTick_s;
  if (due.missed > 0) device_->catch_up(missed_s);
  const ports::DeviceReading reading = device_->read();
  const loop::GatedReading gated = gate_.step(reading, kTick_s + missed_s);
  DevicePenetration* const at = asked_.load(std::memory_order_acquire);
  fading_.N *= kFadeOfATick;
  if (at != nullptr) {
    at->held_up(missed_s);
    fading_ = at->step(gated, reading.age_s);
  }
  limiter_.device_gives(reading.power);
  const Wrench<HapticBase> given = limiter_.limit({.force = fading_, .torque = {}}, kTick_s + missed_s);
  device_->apply(given, {}, kTick_s);
  if (at != nullptr) {
    if (at->moved()) (void)ticks_.try_push(at->tick(given.force));  // full after 2 s: the file then lacks ticks
    if (until_view_-- <= 0 || at->over()) {
      until_view_ = kTicksPerView;
      views_.put(at->view());
    }
    lost_.store(static_cast<std::uint8_t>(at->lost()), std::memory_order_release);
  }
  worked_.store(at, std::memory_order_release);
}

Result<std::unique_ptr<DeviceHand>> connect_hand(const std::string& device) {
  const Result<station::DeviceChoice> choice = station::read_device_choice(device);
  if (!choice) return choice.error();
  if (std::holds_alternative<station::Simulated>(*choice))
    return Error{.what = "a simulated device has no hand of a person",
                 .where = "--device",
                 .fix = "give haply[:URL] or udp:HOST:PORT, or leave --device out to work in the browser"};
  Result<std::unique_ptr<ports::Device>> connected = station::connect_device(*choice);
  if (!connected) return connected.error();
  return std::make_unique<DeviceHand>(std::move(*connected));
}

}  // namespace telepalp::study
