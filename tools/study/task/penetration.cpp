#include "tools/study/task/penetration.h"

namespace telepalp::study {
namespace {

using Eigen::Vector3d;
constexpr double kSeenPast_m = 0.001;  // a needle is seen to have passed a layer this far beyond it

}  // namespace

SimulatedHand::SimulatedHand(const Penetration& one, const Learned& learned, device::Random& random) noexcept
    : condition_(one.condition),
      decisions_(one.person, one.condition, learned, random),
      arm_(one.person, one.tool.on_the_way_m(0.0)) {}

Vector3d SimulatedHand::next_m(const Insertion& insertion) noexcept {
  const double depth_m = insertion.depth_m();
  const bool through = insertion.through();
  const Perceived sensed{.depth_m = depth_m,
                         .hand_force_N = insertion.needle_N().norm(),
                         .layer_passed = through && depth_m > insertion.depth_at_puncture_m() + kSeenPast_m,
                         .punctured = through};
  way_m_ += kTick_s * decisions_.speed_m_per_s(sensed, kTick_s);
  const double time_s = insertion.time_s();
  const Vector3d tremor_m(decisions_.tremor_m(time_s, 0), decisions_.tremor_m(time_s, 1), 0.0);
  const Vector3d shown_N = feels(condition_) ? insertion.felt_N() : Vector3d(Vector3d::Zero());
  arm_.step(insertion.tool().on_the_way_m(way_m_) + tremor_m, shown_N);
  return arm_.hand_m();
}

Outcome penetrate(const Penetration& one, Learned& learned, device::Random& random) noexcept {
  SimulatedHand hand(one, learned, random);
  Insertion insertion(one.tool, one.tissue);
  while (!insertion.over()) insertion.step(hand.next_m(insertion));
  Outcome out = insertion.outcome();
  out.noticed = hand.decisions().noticed();
  if (out.through) learned.add(hand.decisions().sensed_depth_m(out.depth_at_puncture_m));
  return out;
}

}  // namespace telepalp::study
