#include "tools/study/person/operator.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace telepalp::study {
namespace {

constexpr Drawn<Operator> kOperatorRanges[] = {
    {"reaction time", "s", &Operator::reaction_s, 0.12, 0.25,
     "Chernikoff 1952: 0.119 s, kinaesthetic; usual visual values to 0.25 s. One range for all senses: an exact "
     "apparatus found no difference between them"},
    {"arm stiffness", "N/m", &Operator::arm_N_per_m, 100.0, 600.0,
     "van Beek 2015 (10.1038/srep18004): 135 N/m, one person, relaxed; Fu and Cavusoglu 2012, stylus: hundreds"},
    {"arm damping ratio", "", &Operator::arm_damping, 0.35, 0.8, "van Beek 2015: 0.37 (6.45 N s/m, 0.554 kg, 135 N/m)"},
    {"arm mass", "kg", &Operator::arm_kg, 0.3, 0.8, "van Beek 2015: 0.554 kg"},
    {"tremor, RMS", "m", &Operator::tremor_m, 49e-6, 133e-6, "Riviere 1997: 49 um held, 133 um moving; 6 to 12 Hz"},
    {"speed of the hand", "m/s", &Operator::hand_m_per_s, 0.02, 0.06,
     "357 insertions into patients: mean 48 mm/s, range 4 to 174 (ece.ualberta.ca/~tbs)"},
    {"time for the depths that are uncertain", "s", &Operator::patience_s, 1.0, 3.0, "assumed: no source was found"},
    {"force difference noticed", "of the force", &Operator::force_jnd, 0.07, 0.2,
     "Pang 1991: 7 % at 2.5 to 10 N; 15 to 27 % below 1 N"},
    {"force difference noticed, at least", "N", &Operator::force_floor_N, 0.03, 0.1, "assumed: no source was found"},
    {"sense of depth without sight, SD", "of the depth", &Operator::kinaesthesia, 0.08, 0.2,
     "assumed: no source was found for a needle; position sense of a hand errs by about 10 mm"},
    {"sense of depth with the needle in sight, SD", "of the depth", &Operator::needle_sight, 0.03, 0.1,
     "assumed: usual differences in length that are seen are 3 to 5 %, and memory adds to them"},
    {"sense of depth with the layers in sight, SD", "m", &Operator::layer_sight_m, 0.0005, 0.0015,
     "assumed: no source was found"},
    {"caution", "SD", &Operator::caution, 1.0, 2.0, "assumed: 84 to 98 % of unaided stops are past the layer"},
};

constexpr double kHold_s = 0.4;  // an operator who stopped too early waits, and goes on
constexpr double kFeelOver_s = 0.02;
constexpr double kForgetsPeak_s = 0.5;
constexpr double kBrakes_s = 0.05;     // time in which the far end of the arm comes to rest
constexpr double kArmedFrom = 0.6;     // share of the expected depth; a drop of force at less depth is the skin's
constexpr double kSlowsOver_m = 0.01;  // the hand slows down over this distance before the puncture may come
constexpr double kBlind_s = 0.2;       // Condition::NoReflexes goes on for this time after the puncture

}  // namespace

std::span<const Drawn<Operator>> operator_ranges() noexcept { return kOperatorRanges; }

Decisions::Decisions(const Operator& person, Condition condition, const Learned& learned,
                     device::Random& random) noexcept
    : person_(person),
      condition_(condition),
      expected_m_(learned.depth_m),
      uncertain_m_(condition == Condition::SeesLayers ? person.layer_sight_m
                   : sees_needle(condition)           ? person.needle_sight * learned.depth_m
                                                      : person.kinaesthesia * learned.depth_m),
      reaction_s_(person.reaction_s * std::clamp(1.0 + 0.15 * random.normal(), 0.5, 2.0)),
      stop_at_m_(learned.depth_m + person.caution * uncertain_m_),
      tremor_Hz_(random.uniform(6.0, 12.0)) {
  error_ = random.normal() * uncertain_m_ / learned.depth_m;
  for (auto& axis : phases_)
    for (double& phase : axis) phase = random.uniform(0.0, 2.0 * std::numbers::pi);
}

double Decisions::tremor_m(double time_s, int axis) const noexcept {
  constexpr double kLines[] = {0.85, 0.95, 1.07, 1.2};  // of the tremor's frequency; their RMS is 1 together
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i)
    sum +=
        std::sin(2.0 * std::numbers::pi * kLines[i] * tremor_Hz_ * time_s + phases_[static_cast<std::size_t>(axis)][i]);
  return person_.tremor_m * sum / std::numbers::sqrt2;
}

/// A cue: the force falls by a noticeable part of its peak, or the needle is seen to pass the layer.
void Decisions::sense(const Perceived& sensed, double dt_s) noexcept {
  felt_N_ += (sensed.hand_force_N - felt_N_) * std::min(1.0, dt_s / kFeelOver_s);
  peak_N_ = std::max(felt_N_, peak_N_ * (1.0 - dt_s / kForgetsPeak_s));
  if (noticed_) return;
  const bool armed = sensed_depth_m(sensed.depth_m) > kArmedFrom * expected_m_;
  const double noticeable_N = std::max(person_.force_floor_N, person_.force_jnd * peak_N_);
  const bool drop = feels(condition_) && armed && peak_N_ - felt_N_ > noticeable_N;
  const bool seen = condition_ == Condition::SeesLayers && sensed.layer_passed;
  const bool oracle = condition_ == Condition::NoReflexes && sensed.punctured;
  noticed_ = condition_ == Condition::NoReflexes ? oracle : drop || seen;
  if (noticed_) decided_s_ = 0.0;
}

/// The hand is fast up to the depths at which the puncture may come, and slow through them. The less certain the depth,
/// the longer this slow part is, and the faster an operator with this patience must pass it. Past these depths the
/// operator is fast again, because the expected depth was wrong.
double Decisions::wanted_speed(double depth_m) const noexcept {
  const double slow = std::clamp(4.0 * uncertain_m_ / person_.patience_s / person_.hand_m_per_s, 0.05, 1.0);
  const double outside_m = std::abs(expected_m_ - depth_m) - 2.0 * uncertain_m_;
  return person_.hand_m_per_s * std::clamp(outside_m / kSlowsOver_m, slow, 1.0);
}

double Decisions::speed_m_per_s(const Perceived& sensed, double dt_s) noexcept {
  sense(sensed, dt_s);
  const double depth_m = sensed_depth_m(sensed.depth_m);
  const bool far_enough = condition_ != Condition::NoReflexes && depth_m > stop_at_m_;
  if (decided_s_ < 0.0 && far_enough) decided_s_ = 0.0;
  if (decided_s_ >= 0.0) decided_s_ += dt_s;
  const double react_s = condition_ == Condition::NoReflexes ? kBlind_s : reaction_s_;
  const bool brakes = decided_s_ > react_s;
  const double wanted = brakes ? 0.0 : wanted_speed(depth_m);
  const double change = person_.hand_m_per_s * dt_s / kBrakes_s;
  speed_ = std::clamp(wanted, speed_ - change, speed_ + change);
  paused_s_ = brakes && speed_ == 0.0 && !sensed.punctured ? paused_s_ + dt_s : 0.0;
  if (paused_s_ > kHold_s) {  // S4's program tells that the sac is still whole: go on, and further
    decided_s_ = -1.0;
    noticed_ = false;
    peak_N_ = felt_N_;
    expected_m_ = depth_m + person_.caution * uncertain_m_;
    stop_at_m_ = expected_m_ + person_.caution * uncertain_m_;
  }
  return speed_;
}

}  // namespace telepalp::study
