#include "tools/study/protocol/hands/device_hand.h"

#include <atomic>
#include <utility>

#include "proto/words/latest_value.h"
#include "proto/words/spsc_ring.h"

namespace telepalp::study {
namespace {

constexpr int kTicksPerView = 10;

/// Ends with the thread no longer working on it.
class DeviceTrial final : public PersonTrial, private DeviceTask {
 public:
  DeviceTrial(DeviceThread& device, Prepared prepared, Condition condition)
      : device_(device), penetration_(std::move(prepared), condition), view_(penetration_.view()) {
    device_.work_on(this);
  }
  ~DeviceTrial() override { device_.work_on(nullptr); }

  void step(double, Ticks& ticks) override {
    if (views_.take()) view_ = views_.current();
    for (loop::TickSample tick; ticks_.try_pop(tick);) ticks.push_back(tick);
  }
  [[nodiscard]] TrialView view() const noexcept override { return view_; }
  [[nodiscard]] bool moves_by_itself() const noexcept override { return true; }
  [[nodiscard]] std::optional<Error> lost() const override {
    const auto lost = static_cast<DevicePenetration::Lost>(lost_.load(std::memory_order_acquire));
    if (lost == DevicePenetration::Lost::No) return std::nullopt;
    return Error{.what = lost == DevicePenetration::Lost::Silent
                             ? "the haptic device does not answer, so the penetration was broken off"
                             : "the haptic device gives impossible positions, so the penetration was broken off",
                 .where = "--device",
                 .fix = "check the device and its cable, then begin again"};
  }

 private:
  Force<HapticBase> feel(const loop::GatedReading& gated, const ports::DeviceReading& reading) noexcept override {
    return penetration_.step(gated, reading.age_s);
  }
  void held_up(double seconds) noexcept override { penetration_.held_up(seconds); }
  void given(const Force<HapticBase>& force) noexcept override {
    if (penetration_.moved()) (void)ticks_.try_push(penetration_.tick(force));  // full after 2 s: the file lacks ticks
    if (until_view_-- <= 0 || penetration_.over()) {
      until_view_ = kTicksPerView;
      views_.put(penetration_.view());
    }
    lost_.store(static_cast<std::uint8_t>(penetration_.lost()), std::memory_order_release);
  }

  DeviceThread& device_;
  DevicePenetration penetration_;           // owner: the device's thread
  int until_view_ = 0;                      // owner: the device's thread
  LatestValue<TrialView> views_;            // device's thread to network thread
  SpscRing<loop::TickSample, 4096> ticks_;  // device's thread to network thread; 2 s
  std::atomic<std::uint8_t> lost_{0};       // DevicePenetration::Lost
  TrialView view_;
};

}  // namespace

std::unique_ptr<PersonTrial> begin_at_device(DeviceThread& device, Prepared prepared, Condition condition) {
  return std::make_unique<DeviceTrial>(device, std::move(prepared), condition);
}

}  // namespace telepalp::study
