#pragma once

#include <memory>
#include <optional>
#include <string>

#include "tools/study/designer/live/live_tool.h"
#include "tools/study/device/device_thread.h"

namespace telepalp::study {

/// The linkage of a page at a haptic device: the hand feels its parts, takes hold of one by the device's button or the
/// page's, and feels the tissue through it. The first place of the end-effector is kAboveHandle_m above the handle's
/// end; the axes of the tissue's frame are those of the device. The page that opened last has the device. Owner: the
/// network thread; the device's thread feels.
class DeviceDesign {
 public:
  static constexpr double kAboveHandle_m = 0.03;

  explicit DeviceDesign(DeviceThread& device) noexcept : device_(device) {}
  ~DeviceDesign();
  DeviceDesign(const DeviceDesign&) = delete;
  DeviceDesign& operator=(const DeviceDesign&) = delete;

  /// The hand has `tool` from now on, which nobody holds. Its place in the tissue's frame stays.
  void give(const LiveTool& tool);
  /// The linkage in the hand becomes `bar`, evenly, with the needle where it is: LiveTool::change().
  void change(const mechanism::FourBar& bar);
  /// The newest frame in which the hand holds the linkage; nullopt: it does not, or another page has the device.
  [[nodiscard]] std::optional<LiveFrame> held() const;
  void press(bool pressed) noexcept;
  /// What the page gets now: `frame`, or `device` if something about the device changed or it is silent; nullopt:
  /// nothing more comes, because another page has the device.
  [[nodiscard]] std::optional<std::string> step();

 private:
  class Task;
  [[nodiscard]] bool ours() const noexcept;

  DeviceThread& device_;
  std::unique_ptr<Task> task_;
  std::string told_;  // the last `device`
};

}  // namespace telepalp::study
