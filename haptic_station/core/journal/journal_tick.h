#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <type_traits>

#include "haptic_station/loop/tick.h"

namespace telepalp::core {

/// One tick as the journal keeps it: its inputs and its outcome, as exact doubles. Meanings and units are those of
/// TickIn and TickOut. The haptic thread hands it to the journal's thread by copy.
struct JournalTick {
  std::uint64_t tick = 0;
  std::int64_t now_ns = 0;
  double dt_s = 0.0;
  std::array<double, 3> device_m{};
  std::array<double, 3> device_m_per_s{};
  double device_age_s = 0.0;
  std::array<double, 4> tool_attitude{};  ///< x, y, z, w
  std::array<double, 3> tool_rad_per_s{};
  double most_N = 0.0;
  double most_N_m = 0.0;
  double loop_s = 0.0;
  std::int64_t hand_at_ns = 0;
  std::array<double, 3> hand_m{};
  std::array<double, 4> attitude{};  ///< x, y, z, w
  double wait_at_m = 0.0;
  std::uint64_t surface = 0;  ///< number of the surface adopted; 0: none
  std::array<double, 3> force_N{};
  std::array<double, 3> torque_N_m{};
  std::array<double, 3> proxy_m{};
  std::uint8_t phase = 0;
  bool has_tool_attitude = false;
  bool has_hand = false;
  bool has_attitude = false;
  bool has_wait = false;
  bool has_loop = false;
  bool rearm = false;
};
static_assert(std::is_trivially_copyable_v<JournalTick>);

// A new member of these inputs must be kept too, or a replay would differ from the run.
static_assert(sizeof(ports::DeviceReading) == 176, "keep the new member in JournalTick and journal.proto");
static_assert(sizeof(ports::HandSample) == 96, "keep the new member in JournalTick and journal.proto");

[[nodiscard]] inline std::array<double, 3> as_array(const Eigen::Vector3d& v) noexcept { return {v.x(), v.y(), v.z()}; }

/// Keeps a tick's inputs. Real-time safe.
inline void keep(const loop::TickIn& in, JournalTick& tick) noexcept {
  tick.now_ns = to_nanoseconds(in.now);
  tick.dt_s = in.dt_s;
  tick.device_m = as_array(in.reading.at.m);
  tick.device_m_per_s = as_array(in.reading.velocity.v);
  tick.device_age_s = in.reading.age_s;
  tick.has_tool_attitude = in.reading.attitude.has_value();
  if (in.reading.attitude) std::copy_n(in.reading.attitude->coeffs().data(), 4, tick.tool_attitude.begin());
  tick.tool_rad_per_s = as_array(in.reading.turning.v);
  tick.most_N = in.reading.power.most_N;
  tick.most_N_m = in.reading.power.most_N_m;
  tick.has_loop = in.reading.loop_s.has_value();
  tick.loop_s = in.reading.loop_s.value_or(0.0);
  tick.surface = in.surface == nullptr ? 0 : in.surface->number;
  tick.rearm = in.rearm;
  tick.has_hand = in.hand.has_value();
  if (!in.hand) return;
  tick.hand_at_ns = to_nanoseconds(in.hand->at);
  tick.hand_m = as_array(in.hand->hand.m);
  tick.has_attitude = in.hand->attitude.has_value();
  if (in.hand->attitude) std::copy_n(in.hand->attitude->coeffs().data(), 4, tick.attitude.begin());
  tick.has_wait = in.hand->wait_at_m.has_value();
  tick.wait_at_m = in.hand->wait_at_m.value_or(0.0);
}

/// Keeps a tick's outcome. Real-time safe.
inline void keep(const loop::TickOut& out, JournalTick& tick) noexcept {
  tick.force_N = as_array(out.force.N);
  tick.torque_N_m = as_array(out.torque.N_m);
  tick.proxy_m = as_array(out.contact.proxy.m);
  tick.phase = static_cast<std::uint8_t>(out.control.phase);
}

}  // namespace telepalp::core
