#include "haptic_station/device/protocol/haply_inverse.h"

#include <google/protobuf/util/json_util.h>

#include <array>
#include <charconv>
#include <cmath>

#include "messages/haply_inverse.pb.h"

namespace telepalp::device::haply {
namespace {

namespace json = google::protobuf::util;

constexpr double kFurthest_m = 2.0;
constexpr double kFastest_m_per_s = 50.0;
constexpr std::size_t kMostIdBytes = 64;
constexpr int kMostDevices = 16;

Error refused(std::string what) {
  return {
      .what = std::move(what),
      .where = "message of the Inverse service",
      .fix = "check that Haply's Inverse service is 3.1 or later, and writes its numbers with a point (1.5, not 1,5)"};
}

bool is_id_letter(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_' || c == ':';
}

bool is_id(std::string_view id) {
  if (id.empty() || id.size() > kMostIdBytes) return false;
  for (const char c : id)
    if (!is_id_letter(c)) return false;
  return true;
}

std::optional<Eigen::Vector3d> all_three(const haply_inverse::Axes& axes, double most) {
  if (!axes.has_x() || !axes.has_y() || !axes.has_z()) return std::nullopt;
  const Eigen::Vector3d v(axes.x(), axes.y(), axes.z());
  if (!v.allFinite() || v.cwiseAbs().maxCoeff() > most) return std::nullopt;
  return v;
}

/// The attitude of the first handle: a wireless one, or else one on a cable. A handle without one is none.
std::optional<Eigen::Quaterniond> attitude_of(const haply_inverse::Text& message) {
  for (const auto* handles : {&message.wireless_verse_grip(), &message.verse_grip()})
    for (const haply_inverse::Handle& one : *handles) {
      const haply_inverse::Orientation& q = one.state().orientation();
      if (q.has_x() && q.has_y() && q.has_z() && q.has_w()) return Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z());
    }
  return std::nullopt;
}

std::optional<bool> pressed_on(const haply_inverse::Text& message) {
  std::optional<bool> pressed;
  for (const haply_inverse::Handle& one : message.wireless_verse_grip()) {
    const haply_inverse::Buttons& buttons = one.state().buttons();
    pressed = pressed.value_or(false) || buttons.a() || buttons.b() || buttons.c();
  }
  return pressed;
}

std::string number(double value) {
  std::array<char, 32> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, 6);
  return error == std::errc{} ? std::string(text.data(), end) : "0";
}

}  // namespace

Result<std::optional<State>> parse_text(std::string_view text, std::string_view wanted_id) {
  if (text.size() > kMostTextBytes) return refused("the message is longer than 64 KiB");
  json::JsonParseOptions options;
  options.ignore_unknown_fields = true;
  haply_inverse::Text message;
  if (const auto read = json::JsonStringToMessage({text.data(), text.size()}, &message, options); !read.ok())
    return refused("the message is not the state of a device in JSON: " + read.ToString().substr(0, 200));
  if (message.inverse3_size() + message.verse_grip_size() + message.wireless_verse_grip_size() > kMostDevices)
    return refused("the message lists more than 16 devices and handles");
  for (const haply_inverse::Text::Inverse3& one : message.inverse3()) {
    if (!wanted_id.empty() && one.device_id() != wanted_id) continue;
    if (!is_id(one.device_id())) return refused("the device_id is not 1 to 64 letters, digits, '-', '_' or ':'");
    if (!one.has_state()) return std::optional<State>{};
    const auto cursor = all_three(one.state().cursor_position(), kFurthest_m);
    const auto velocity = all_three(one.state().cursor_velocity(), kFastest_m_per_s);
    if (!cursor || !velocity)
      return refused("the position or velocity is incomplete, not finite, beyond 2 m or above 50 m/s");
    return std::optional{State{one.device_id(), {*cursor}, {*velocity}, attitude_of(message), pressed_on(message)}};
  }
  return std::optional<State>{};
}

std::string force_text(std::string_view device_id, const Force<InverseBase>& force) {
  const Eigen::Vector3d N = force.N.allFinite() ? force.N : Eigen::Vector3d::Zero().eval();
  return R"({"inverse3":[{"device_id":")" + std::string(device_id) +
         R"(","commands":{"set_cursor_force":{"values":{"x":)" + number(N.x()) + R"(,"y":)" + number(N.y()) +
         R"(,"z":)" + number(N.z()) + "}}}}]}";
}

Transform<HapticBase, InverseBase> haptic_from_inverse(const Point<InverseBase>& origin) {
  Transform<HapticBase, InverseBase> out;
  Eigen::Matrix3d turn;
  turn << 1, 0, 0,  //
      0, 0, 1,      //
      0, -1, 0;
  out.iso.linear() = turn;
  out.iso.translation() = -(turn * origin.m);
  return out;
}

Eigen::Quaterniond in_haptic_axes(const Eigen::Quaterniond& inverse_from_handle) {
  const Eigen::Vector3d axis = haptic_from_inverse({}).iso.linear() * inverse_from_handle.vec();
  return {inverse_from_handle.w(), axis.x(), axis.y(), axis.z()};
}

}  // namespace telepalp::device::haply
