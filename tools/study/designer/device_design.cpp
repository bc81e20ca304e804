#include "tools/study/designer/device_design.h"

#include <algorithm>
#include <atomic>
#include <vector>

#include "proto/words/latest_value.h"
#include "proto/words/spsc_ring.h"
#include "tools/study/designer/answers.h"

namespace telepalp::study {
namespace {

using Eigen::Vector3d;

constexpr double kRise_s = 0.1;     // the force rises from zero in this time
constexpr double kSilent_s = 0.05;  // a device that is silent, or impossibly fast, for this long feels nothing
constexpr int kTicksPerView = 10;

}  // namespace

class DeviceDesign::Task final : public DeviceTask {
 public:
  enum class Trouble : std::uint8_t { No, Silent, Implausible };

  Task(const LiveTool& tool, const std::optional<Vector3d>& shift_m) : tool_(tool), shift_m_(shift_m) {
    const Eigen::Vector2d end_m = tool_.frame().at.c_m;
    begin_m_ = Vector3d(end_m.x(), end_m.y() + kAboveHandle_m, 0.0);
    tool_.forget_hand();
  }

  Force<HapticBase> feel(const loop::GatedReading& gated, const ports::DeviceReading& reading) noexcept override {
    const bool implausible = std::max(gated.implausible_s, gated.unreadable_s) > kSilent_s;
    const Trouble trouble = !(reading.age_s <= kSilent_s) ? Trouble::Silent
                            : implausible                 ? Trouble::Implausible
                                                          : Trouble::No;
    trouble_.store(trouble, std::memory_order_relaxed);
    share_ = trouble == Trouble::No ? std::min(1.0, share_ + kTick_s / kRise_s) : 0.0;
    if (trouble != Trouble::No) {
      tool_.forget_hand();
      return {};
    }
    if (!shift_m_) shift_m_ = begin_m_ - gated.at.m;
    if (bars_.take()) tool_.change(bars_.current());
    const bool pressed = reading.pressed || pressed_.load(std::memory_order_relaxed);
    const Vector3d N = tool_.feel(gated.at.m + *shift_m_, pressed).N;
    if (until_view_-- <= 0) show();
    return {share_ * N};
  }

  void change(const mechanism::FourBar& bar) { bars_.put(bar); }
  void press(bool pressed) noexcept { pressed_.store(pressed, std::memory_order_relaxed); }
  [[nodiscard]] Trouble trouble() const noexcept { return trouble_.load(std::memory_order_relaxed); }
  /// The newest frame with the trace since the last one; nullopt: no new frame.
  [[nodiscard]] std::optional<std::string> frame() {
    if (!views_.take()) return std::nullopt;
    drawn_ = views_.current();
    std::vector<TracePoint> trace;
    for (TracePoint point; trace_.try_pop(point);) trace.push_back(point);
    return frame_json(drawn_, trace);
  }
  /// What frame() gave last.
  [[nodiscard]] const LiveFrame& drawn() const noexcept { return drawn_; }
  /// Where the tissue's frame is in the device's. Call it when the device's thread has left this task.
  [[nodiscard]] const std::optional<Vector3d>& shift_m() const noexcept { return shift_m_; }

 private:
  void show() noexcept {
    until_view_ = kTicksPerView;
    views_.put(tool_.frame());
    (void)trace_.try_push(tool_.trace_point());  // full after 2 s: the plot then lacks points
  }

  LiveTool tool_;                         // owner: the device's thread
  Vector3d begin_m_;                      // of the hand in the tissue's frame
  std::optional<Vector3d> shift_m_;       // owner: the device's thread; from the device's frame to the tissue's
  double share_ = 0.0;                    // owner: the device's thread; of the force, while it rises
  int until_view_ = 0;                    // owner: the device's thread
  LatestValue<LiveFrame> views_;          // device's thread to network thread
  LatestValue<mechanism::FourBar> bars_;  // network thread to device's thread
  LiveFrame drawn_;                       // owner: the network thread
  SpscRing<TracePoint, 512> trace_;       // device's thread to network thread
  std::atomic<bool> pressed_{false};
  std::atomic<Trouble> trouble_{Trouble::No};
};

DeviceDesign::~DeviceDesign() {
  if (ours()) device_.work_on(nullptr);
}

bool DeviceDesign::ours() const noexcept { return task_ && device_.task() == task_.get(); }

void DeviceDesign::give(const LiveTool& tool) {
  if (task_ && !ours()) return;
  device_.work_on(nullptr);
  task_ = std::make_unique<Task>(tool, task_ ? task_->shift_m() : std::nullopt);
  device_.work_on(task_.get());
}

void DeviceDesign::change(const mechanism::FourBar& bar) {
  if (ours()) task_->change(bar);
}

std::optional<LiveFrame> DeviceDesign::held() const {
  return ours() && task_->drawn().held ? std::optional(task_->drawn()) : std::nullopt;
}

void DeviceDesign::press(bool pressed) noexcept {
  if (task_) task_->press(pressed);
}

std::optional<std::string> DeviceDesign::step() {
  if (!task_) return std::nullopt;
  std::string_view trouble;
  if (!ours())
    trouble = "another page has the haptic device: load this page again to take it back";
  else if (task_->trouble() == Task::Trouble::Silent)
    trouble = "the haptic device does not answer: check the device and its cable";
  else if (task_->trouble() == Task::Trouble::Implausible)
    trouble = "the haptic device gives impossible positions: check the device and its cable";
  if (std::string now = device_json(ours(), trouble); now != told_) return told_ = std::move(now);
  if (!ours()) return std::nullopt;
  std::optional<std::string> frame = task_->frame();
  return frame ? frame : told_;
}

}  // namespace telepalp::study
