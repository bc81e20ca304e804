#include "tools/study/device/device_thread.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "haptic_station/loop/tick.h"
#include "haptic_station/station/rigs/rig_choice.h"
#include "haptic_station/station/threads/realtime.h"
#include "tools/study/task/insertion.h"

namespace telepalp::study {
namespace {

constexpr double kFade_s = 0.03;
const double kFadeOfATick = std::exp(-kTick_s / kFade_s);

}  // namespace

DeviceThread::DeviceThread(std::unique_ptr<ports::Device> device)
    : device_(std::move(device)), thread_([this] {
        (void)station::enter_realtime(station::Realtime::Prefer);
        run();
      }) {}

DeviceThread::~DeviceThread() {
  running_ = false;
  thread_.join();
}

void DeviceThread::work_on(DeviceTask* task) noexcept {
  asked_.store(task, std::memory_order_release);
  while (worked_.load(std::memory_order_acquire) != task) std::this_thread::sleep_for(std::chrono::microseconds(200));
}

void DeviceThread::run() noexcept {
  station::TickTimer timer(station::TickTimer::Clock::now() + loop::kTickPeriod, loop::kTickPeriod);
  while (running_.load(std::memory_order_relaxed)) tick(timer.wait());
  device_->apply({}, {}, kTick_s);
}

void DeviceThread::tick(const station::TickTimer::Tick& due) noexcept {
  const double missed_s = static_cast<double>(due.missed) * kTick_s;
  if (due.missed > 0) device_->catch_up(missed_s);
  const ports::DeviceReading reading = device_->read();
  const loop::GatedReading gated = gate_.step(reading, kTick_s + missed_s);
  DeviceTask* const at = asked_.load(std::memory_order_acquire);
  fading_.N *= kFadeOfATick;
  if (at != nullptr) {
    at->held_up(missed_s);
    fading_ = at->feel(gated, reading);
  }
  limiter_.device_gives(reading.power);
  const Wrench<HapticBase> given = limiter_.limit({.force = fading_, .torque = {}}, kTick_s + missed_s);
  device_->apply(given, {}, kTick_s);
  if (at != nullptr) at->given(given.force);
  worked_.store(at, std::memory_order_release);
}

Result<std::unique_ptr<DeviceThread>> connect_device_thread(const std::string& device) {
  const Result<station::DeviceChoice> choice = station::read_device_choice(device);
  if (!choice) return choice.error();
  if (std::holds_alternative<station::Simulated>(*choice))
    return Error{.what = "a simulated device has no hand of a person",
                 .where = "--device",
                 .fix = "give haply[:URL] or udp:HOST:PORT, or leave --device out to work in the browser"};
  Result<std::unique_ptr<ports::Device>> connected = station::connect_device(*choice);
  if (!connected) return connected.error();
  return std::make_unique<DeviceThread>(std::move(*connected));
}

}  // namespace telepalp::study
