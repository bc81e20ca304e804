#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "haptic_station/device/protocol/haply_device.h"
#include "haptic_station/device/protocol/udp_socket_device.h"
#include "haptic_station/device/protocol/websocket_line.h"
#include "haptic_station/ports/rig.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/tracking/protocol/leap_tracker.h"
#include "haptic_station/tracking/protocol/viewer_hand_tracker.h"
#include "support/program/address.h"

namespace telepalp::station {

struct Simulated {};
struct Haply {
  device::WebSocketUrl url;
  Point<device::haply::InverseBase> origin = device::middle_of_inverse3();  ///< this point becomes H's origin
};
struct Leap {
  device::WebSocketUrl url;
};
struct Held {};     ///< the person grips the end-effector: hand position = device position
struct Browser {};  ///< a person moves the hand in a viewer

using DeviceChoice = std::variant<Simulated, Haply, program::Address>;
using TrackerChoice = std::variant<Simulated, Held, Leap, Browser>;

struct RigChoice {
  DeviceChoice device;
  TrackerChoice tracker;
  [[nodiscard]] bool is_simulated() const noexcept {
    return std::holds_alternative<Simulated>(device) && std::holds_alternative<Simulated>(tracker);
  }
};

/// Values of `--device` and `--tracker`, for help texts.
inline constexpr const char* kDeviceWords = "simulated|haply[:URL]|udp:HOST:PORT";
inline constexpr const char* kTrackerWords = "simulated|held|leap[:URL]|browser";

[[nodiscard]] Result<DeviceChoice> read_device_choice(const std::string& text);
[[nodiscard]] Result<TrackerChoice> read_tracker_choice(const std::string& text);

/// Parses the values of `--device` and `--tracker`. Error: an unknown value, a simulated or a browser's hand with a
/// real device, or a held end-effector with a simulated device.
[[nodiscard]] Result<RigChoice> read_rig_choice(const std::string& device, const std::string& tracker);

/// Default time limit for the first answer of a device or tracker.
inline constexpr std::chrono::milliseconds kAnswerWithin{3000};

/// Connects to the device or tracker. Simulated gives a device that the tracked hand moves. Error: no answer in time.
[[nodiscard]] Result<std::unique_ptr<ports::Device>> connect_device(const DeviceChoice& choice,
                                                                    std::chrono::milliseconds within = kAnswerWithin);
[[nodiscard]] Result<std::unique_ptr<tracking::LeapTracker>> connect_leap(
    const Leap& choice, const scenes::Scene& scene, std::chrono::milliseconds within = kAnswerWithin);

/// A rig whose device and tracker have answered. `rig` is nullptr when device and tracker are both simulated: Station
/// then makes the scene's simulated rig.
struct ConnectedRig {
  std::unique_ptr<ports::Rig> rig;
  tracking::ViewerHandTracker* browser = nullptr;  ///< the rig's tracker if it follows a viewer's hand, else nullptr
  /// The calibration by which the rig's tracker transforms hands to H; nullopt: it needs none.
  std::optional<Transform<HapticBase, HandTracker>> haptic_from_tracker;
  /// The messages of the rig's device that were refused since the last call; returns nullopt if there are none. Empty:
  /// the device logs its refusals itself, or sends no messages. Network thread.
  std::function<std::optional<Error>()> device_refusals;
};

/// Connects the chosen rig. Error: the device or the tracker does not answer; the error names which, and a fix.
[[nodiscard]] Result<ConnectedRig> connect_rig(const RigChoice& choice, const scenes::Scene& scene);

}  // namespace telepalp::station
