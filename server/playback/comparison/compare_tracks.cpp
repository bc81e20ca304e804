#include "server/playback/comparison/compare_tracks.h"

#include <algorithm>
#include <cmath>

#include "proto/wire/station/contact_force.h"

namespace telepalp::playback {
namespace {

constexpr std::int64_t kSameInstant_ns = 10'000'000;  // states come each 10 ms

/// The time axis, in the session time of A. Times of B are shifted by `shift_ns` to it.
struct Axis {
  std::int64_t begin_ns;
  std::int64_t bin_ns;
  std::int64_t shift_ns;

  [[nodiscard]] int bin(std::int64_t at_ns) const noexcept {
    return static_cast<int>(std::clamp<std::int64_t>((at_ns - begin_ns) / bin_ns, 0, kComparisonBins - 1));
  }
};

bool share_time(const StateTrack& a, const StateTrack& b) noexcept {
  return a.begin_ns <= b.end_ns && b.begin_ns <= a.end_ns;
}

Axis axis_of(const StateTrack& a, const StateTrack& b) noexcept {
  const std::int64_t shift_ns = share_time(a, b) ? 0 : a.points.front().at_ns - b.points.front().at_ns;
  const std::int64_t begin_ns = std::min(a.points.front().at_ns, b.points.front().at_ns + shift_ns);
  const std::int64_t end_ns = std::max(a.points.back().at_ns, b.points.back().at_ns + shift_ns);
  return {.begin_ns = begin_ns, .bin_ns = (end_ns - begin_ns) / kComparisonBins + 1, .shift_ns = shift_ns};
}

double length(const std::array<float, 3>& v) { return std::hypot(double{v[0]}, double{v[1]}, double{v[2]}); }

double apart_N(const TrackPoint& a, const TrackPoint& b) {
  return std::hypot(double{a.force_N[0]} - double{b.force_N[0]}, double{a.force_N[1]} - double{b.force_N[1]},
                    double{a.force_N[2]} - double{b.force_N[2]});
}

void raise(float& largest, double value) { largest = std::max(largest, static_cast<float>(value)); }

void fill(msg::ComparisonState::Run& run, const StateTrack& track, const Axis& axis, std::int64_t shift_ns) {
  run.mutable_force_n()->Resize(kComparisonBins, 0.0F);
  run.mutable_indentation_mm()->Resize(kComparisonBins, 0.0F);
  run.mutable_phase()->Resize(kComparisonBins, msg::PHASE_UNSPECIFIED);
  for (const TrackPoint& point : track.points) {
    const int bin = axis.bin(point.at_ns + shift_ns);
    if (wire::is_contact(point.phase)) raise(*run.mutable_force_n()->Mutable(bin), length(point.force_N));
    raise(*run.mutable_indentation_mm()->Mutable(bin), 1e3 * double{point.indentation_m});
    run.set_phase(bin, point.phase);
  }
}

/// The point of `track` that is nearest to `at_ns`, searched from `from` on.
std::size_t nearest(const StateTrack& track, std::int64_t at_ns, std::size_t from) {
  const auto& points = track.points;
  while (from + 1 < points.size() && std::abs(points[from + 1].at_ns - at_ns) <= std::abs(points[from].at_ns - at_ns))
    ++from;
  return from;
}

bool touches(const TrackPoint& point) noexcept { return point.indentation_m > 0.0F; }

void compare_forces(msg::ComparisonState& state, const StateTrack& a, const StateTrack& b, const Axis& axis) {
  state.mutable_apart_n()->Resize(kComparisonBins, 0.0F);
  std::size_t j = 0;
  for (const TrackPoint& now : a.points) {
    j = nearest(b, now.at_ns - axis.shift_ns, j);
    const TrackPoint& other = b.points[j];
    if (std::abs(other.at_ns + axis.shift_ns - now.at_ns) > kSameInstant_ns) continue;
    if (!touches(now) && !touches(other)) continue;  // out of contact the force moves only the free device
    const double apart = apart_N(now, other);
    raise(*state.mutable_apart_n()->Mutable(axis.bin(now.at_ns)), apart);
    if (state.has_first() || apart <= kFeltDifference_N) continue;
    msg::ComparisonState::Difference& first = *state.mutable_first();
    first.set_at_s(static_cast<double>(now.at_ns - a.begin_ns) * 1e-9);
    first.set_force_a_n(length(now.force_N));
    first.set_force_b_n(length(other.force_N));
    first.set_apart_n(apart);
  }
}

}  // namespace

msg::ComparisonState compare_tracks(const StateTrack& a, const StateTrack& b) {
  const Axis axis = axis_of(a, b);
  msg::ComparisonState state;
  state.set_begin_s(static_cast<double>(axis.begin_ns - a.begin_ns) * 1e-9);
  state.set_bin_s(static_cast<double>(axis.bin_ns) * 1e-9);
  state.set_same_time(share_time(a, b));
  fill(*state.mutable_a(), a, axis, 0);
  fill(*state.mutable_b(), b, axis, axis.shift_ns);
  compare_forces(state, a, b, axis);
  return state;
}

}  // namespace telepalp::playback
