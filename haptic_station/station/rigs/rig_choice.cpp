#include "haptic_station/station/rigs/rig_choice.h"

#include <utility>

#include "haptic_station/device/hand_driven_device.h"
#include "haptic_station/device/joined_rig.h"
#include "haptic_station/station/telemetry/say.h"
#include "haptic_station/tracking/grip_tracker.h"

namespace telepalp::station {
namespace {

constexpr double kRestHeight_m = 0.10;  // height above the skin, as for the simulated hand

/// The text after `word:`; empty when `text` is only `word`; nullopt for any other text.
std::optional<std::string> after(const std::string& text, const std::string& word) {
  if (text == word) return std::string();
  if (text.starts_with(word + ":")) return text.substr(word.size() + 1);
  return std::nullopt;
}

Error not_one_of(const std::string& text, const char* option, const char* words) {
  return {.what = "'" + text + "' is none of " + words, .where = option, .fix = "give one of them"};
}

}  // namespace

Result<DeviceChoice> read_device_choice(const std::string& text) {
  if (text == "simulated") return DeviceChoice{Simulated{}};
  if (const auto url = after(text, "haply")) {
    if (url->empty()) return DeviceChoice{Haply{.url = device::standard_haply_url()}};
    const auto read = device::parse_websocket_url(*url, device::standard_haply_url(), "--device haply");
    if (!read) return read.error();
    return DeviceChoice{Haply{.url = *read}};
  }
  if (const auto address = after(text, "udp"); address && !address->empty()) {
    const Result<program::Address> read = program::parse_address(*address, "--device udp");
    if (!read) return read.error();
    return DeviceChoice{*read};
  }
  return not_one_of(text, "--device", kDeviceWords);
}

Result<TrackerChoice> read_tracker_choice(const std::string& text) {
  if (text == "simulated") return TrackerChoice{Simulated{}};
  if (text == "held") return TrackerChoice{Held{}};
  if (text == "browser") return TrackerChoice{Browser{}};
  if (const auto url = after(text, "leap")) {
    if (url->empty()) return TrackerChoice{Leap{device::WebSocketUrl(tracking::standard_leap_url())}};
    const auto read = device::parse_websocket_url(*url, tracking::standard_leap_url(), "--tracker leap");
    if (!read) return read.error();
    return TrackerChoice{Leap{*read}};
  }
  return not_one_of(text, "--tracker", kTrackerWords);
}

Result<RigChoice> read_rig_choice(const std::string& device, const std::string& tracker) {
  const Result<DeviceChoice> chosen_device = read_device_choice(device);
  if (!chosen_device) return chosen_device.error();
  const Result<TrackerChoice> chosen_tracker = read_tracker_choice(tracker);
  if (!chosen_tracker) return chosen_tracker.error();
  const bool simulated = std::holds_alternative<Simulated>(*chosen_device);
  if (!simulated && std::holds_alternative<Simulated>(*chosen_tracker))
    return Error{.what = "a simulated tracker cannot see the real hand at the device " + device,
                 .where = "--tracker",
                 .fix = "give --tracker leap, or --tracker held when the hand holds the device's grip"};
  if (simulated && std::holds_alternative<Held>(*chosen_tracker))
    return Error{.what = "held is for a real device, which the hand grips, but --device is simulated",
                 .where = "--tracker",
                 .fix = "give --device haply or udp:HOST:PORT, or --tracker simulated, leap or browser"};
  if (!simulated && std::holds_alternative<Browser>(*chosen_tracker))
    return Error{.what = "a hand in a browser cannot touch the real device " + device,
                 .where = "--tracker",
                 .fix = "give --device simulated, or --tracker leap, or --tracker held"};
  return RigChoice{*chosen_device, *chosen_tracker};
}

Result<std::unique_ptr<ports::Device>> connect_device(const DeviceChoice& choice, std::chrono::milliseconds within) {
  if (const auto* haply = std::get_if<Haply>(&choice)) {
    auto made = std::make_unique<device::HaplyDevice>(haply->url, haply->origin, say);
    if (const Result<void> started = made->start(within); !started) return started.error();
    return std::unique_ptr<ports::Device>(std::move(made));
  }
  if (const auto* address = std::get_if<program::Address>(&choice)) {
    Result<std::unique_ptr<device::UdpDevice>> made = device::UdpDevice::open(*address);
    if (!made) return made.error();
    if (const Result<void> started = (*made)->start(within); !started) return started.error();
    return std::unique_ptr<ports::Device>(std::move(made).value());
  }
  return std::unique_ptr<ports::Device>(
      std::make_unique<device::HandDrivenDevice>(device::SimulatedDeviceSettings{}, device::SimulatedHandSettings{},
                                                 Point<HapticBase>{{0.0, kRestHeight_m, 0.0}}));
}

Result<std::unique_ptr<tracking::LeapTracker>> connect_leap(const Leap& choice, const scenes::Scene& scene,
                                                            std::chrono::milliseconds within) {
  auto made = std::make_unique<tracking::LeapTracker>(choice.url, scene.haptic_from_tracker, say);
  if (const Result<void> started = made->start(within); !started) return started.error();
  return made;
}

Result<ConnectedRig> connect_rig(const RigChoice& choice, const scenes::Scene& scene) {
  ConnectedRig connected;
  if (choice.is_simulated()) return connected;
  Result<std::unique_ptr<ports::Device>> device = connect_device(choice.device);
  if (!device) return device.error();
  if (auto* const udp = dynamic_cast<device::UdpDevice*>(device->get()))
    connected.device_refusals = [udp] { return udp->new_refusals(); };
  std::unique_ptr<ports::Tracker> tracker = std::make_unique<tracking::GripTracker>();
  if (const auto* leap = std::get_if<Leap>(&choice.tracker)) {
    Result<std::unique_ptr<tracking::LeapTracker>> made = connect_leap(*leap, scene);
    if (!made) return made.error();
    tracker = std::move(made).value();
    connected.haptic_from_tracker = scene.haptic_from_tracker;
  } else if (std::holds_alternative<Browser>(choice.tracker)) {
    auto made = std::make_unique<tracking::ViewerHandTracker>();
    connected.browser = made.get();
    tracker = std::move(made);
  }
  connected.rig = std::make_unique<device::JoinedRig>(std::move(device).value(), std::move(tracker));
  return connected;
}

}  // namespace telepalp::station
