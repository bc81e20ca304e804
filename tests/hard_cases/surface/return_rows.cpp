#include <random>

#include "tests/hard_cases/surface/driven.h"
#include "tests/hard_cases/surface/seen_patient.h"

namespace telepalp::surface {
namespace {

constexpr double kFeltWithin_s = 1.5;
constexpr double kRightAfter_s = 3.0;

AssertionResult returns(const SeenPatient& patient) {
  const Returned got = press_on(patient);
  return all_of({{got.touched_before, "was in contact"},
                 below("felt again", got.felt_after_s, kFeltWithin_s, 1.0, "s"),
                 below("off the law after 3 s", got.off_after_3_s, 0.05, 100.0, "%"),
                 below("anchor off the skin", got.anchor_off_m, 0.0005, 1e3, "mm"),
                 below_N("step", got.worst_step_N, kMostStep_N)});
}

SeenPatient missing(double seconds, double shift_m = 0.0) {
  SeenPatient patient;
  patient.lift_m = [=](double t) { return t < 2.0 ? 0.0 : shift_m; };
  patient.frame_arrives = [=](double t) { return t < 2.0 || t > 2.0 + seconds; };
  patient.well_again_s = 2.0 + seconds;
  return patient;
}

AssertionResult frames_missing_1_6_s() { return returns(missing(1.6)); }
AssertionResult frames_missing_3_s() { return returns(missing(3.0)); }
AssertionResult frames_missing_5_s_risen() { return returns(missing(5.0, 0.03)); }
AssertionResult stalled_and_risen() { return returns(missing(0.9, 0.025)); }

SeenPatient shifted(double shift_m) {
  SeenPatient patient;
  patient.lift_m = [=](double t) { return t < 2.0 ? 0.0 : shift_m; };
  return patient;
}

AssertionResult nearer_by_30_mm() { return returns(shifted(0.03)); }
AssertionResult replaced_by_another() { return returns(shifted(0.055)); }
AssertionResult farther_by_10_mm() { return returns(shifted(-0.01)); }

/// From 2 s on, for `seconds`, the camera sees `what_m(u, v)` instead of the skin; where it is NaN, the skin.
SeenPatient instead_for(double seconds, const std::function<double(int, int)>& what_m) {
  SeenPatient patient;
  patient.over_m = [=](int u, int v, double t) { return t >= 2.0 && t < 2.0 + seconds ? what_m(u, v) : std::nan(""); };
  patient.well_again_s = 2.0 + seconds;
  return patient;
}

bool around_the_device(int u, int v, int half_px) { return std::abs(u - 80) <= half_px && std::abs(v - 60) <= half_px; }

AssertionResult black_for_2_s() {
  return returns(instead_for(2.0, [](int, int) { return 0.0; }));
}
AssertionResult hole_for_3_s() {
  return returns(instead_for(3.0, [](int u, int v) { return around_the_device(u, v, 30) ? 0.0 : std::nan(""); }));
}
AssertionResult foreign_hand_for_3_s() {
  return returns(instead_for(3.0, [](int u, int v) { return around_the_device(u, v, 30) ? 0.65 : std::nan(""); }));
}
AssertionResult low_foreign_hand_for_3_s() {
  SeenPatient patient =
      instead_for(3.0, [](int u, int v) { return around_the_device(u, v, 30) ? 0.77 : std::nan(""); });
  patient.depth_m = 0.01;  // 40 mm below the hand
  return returns(patient);
}

/// The hand is 85 mm below the foreign one: too far for the contact to go on, near enough for another to begin.
AssertionResult felt_foreign_hand_for_3_s() {
  return returns(instead_for(3.0, [](int u, int v) { return around_the_device(u, v, 30) ? 0.735 : std::nan(""); }));
}

/// The camera sees a steep object 170 mm over the device. The nearest part of the object is 85 mm away, to the side.
AssertionResult under_a_steep_object() {
  const Snapshot steep = from_depth([](int u, int) {
    const double per_z = (u - small_camera().cx) / small_camera().fx;
    return std::clamp(0.65 / (1.0 - 1.73 * per_z), 0.3, 1.2);
  });
  const Vector3d device(0.0, 0.0, 0.82);
  const Drive drove = drive_on(steep, line(device, device, 1.0), 0.3);
  return all_of({{!drove.touched, "no contact"}, {drove.finite, "finite"}});
}

/// Two hands at the patient's site, 10 mm to the left and to the right of the touched point.
AssertionResult between_two_hands() {
  const Returned got = press_on(instead_for(3.0, [](int u, int) {
    const int beside_px = std::abs(u - 80);
    return beside_px > 16 && beside_px < 60 ? 0.72 : std::nan("");
  }));
  return all_of({{got.touched_before && got.never_lost, "contact holds between them"},
                 below("off the law", got.worst_off, 0.2, 100.0, "%"),
                 below_N("step", got.worst_step_N, kMostStep_N)});
}

/// The camera is pushed: the whole image tilts by 4 degrees and comes 15 mm nearer.
AssertionResult camera_moved() {
  SeenPatient patient;
  patient.lift_m = [](double t) { return t < 2.0 ? 0.0 : 0.015; };
  patient.tilt = [](double t) { return t < 2.0 ? 0.0 : 0.07; };
  return returns(patient);
}

/// The device is at the image's border and goes beyond it and back.
AssertionResult at_the_images_border() {
  SeenPatient patient;
  patient.device_x_m = [](double t) { return -0.12 + 0.02 * std::cos(M_PI * std::max(0.0, t - 2.0)); };
  patient.well_again_s = 2.0;
  const Returned got = press_on(patient);
  return all_of(
      {{got.touched_before, "was in contact"}, {got.finite, "finite"}, below_N("step", got.worst_step_N, 0.1)});
}

/// The skin closes above the finger: walls of a dent lean over it until they meet, 20 mm above the device.
AssertionResult skin_folds_over_the_finger() {
  SeenPatient patient;
  patient.over_m = [](int u, int v, double t) {
    const double aside_px = std::hypot(u - 80.0, v - 60.0);
    const double closed = std::clamp((t - 2.0) / 0.5, 0.0, 1.0);
    const double ring_px = 22.0 * (1.0 - closed);
    return t > 2.0 && t < 4.0 && aside_px > ring_px && aside_px < 30.0 ? 0.78 : std::nan("");
  };
  patient.well_again_s = 4.0;
  return returns(patient);
}

/// The builder drops late frames. A restarted server with an older clock is counted, and its frames are used.
AssertionResult older_than_the_last() {
  SurfaceBuilder builder = SurfaceBuilder(SurfaceSettings{});
  SeenPatient patient;
  std::mt19937_64 random(1);
  const auto first = builder.add(image_of(patient, 0.0, random), small_camera(), at_s(1.5), std::nullopt);
  const bool dropped = builder.add(image_of(patient, 0.1, random), small_camera(), at_s(1.4), std::nullopt) == nullptr;
  const Snapshot newer = from_depth([](int, int) { return 0.8; }, at_s(1.5));
  const Snapshot older = from_depth([](int, int) { return 0.79; }, at_s(1.2));
  Touch touch;
  touch.adopt(*newer, at_s(1.5));
  const auto feed = [&](double t) -> const SurfaceSnapshot* {
    return std::abs(t - 0.8) < 0.5 * kTick_s ? older.get() : nullptr;
  };
  const Drive drove = drive(touch, line({0, 0, 0.79}, {0, 0, 0.805}, 0.6), 1.2, feed, 0.5);
  return all_of({{first != nullptr && dropped && builder.counts().not_newer == 1, "dropped by the builder"},
                 {touch.out_of_order() == 1, "counted by the touch"},
                 below_N("step", drove.worst_step_N, kMostStep_N)});
}

/// 50 of 200 seeds: gaps to 5 s, shifts to 30 mm, holes, black and foreign hands, at any depth to 40 mm.
template <std::uint64_t kFirstSeed>
AssertionResult fifty_accidents() {
  int not_felt = 0;
  double slowest_s = 0.0;
  double worst_off = 0.0;
  double worst_step_N = 0.0;
  for (std::uint64_t seed = kFirstSeed; seed < kFirstSeed + 50; ++seed) {
    const Returned got = press_on(accident(seed));
    if (!(got.touched_before && got.felt_after_s < kFeltWithin_s && got.off_after_3_s < 0.05)) ++not_felt;
    slowest_s = std::max(slowest_s, got.felt_after_s);
    worst_off = std::max(worst_off, got.off_after_3_s);
    worst_step_N = std::max(worst_step_N, got.worst_step_N);
  }
  return all_of({below("not felt as the law says", not_felt, 0.5, 1.0, "of 50"),
                 below("slowest", slowest_s, kFeltWithin_s, 1.0, "s"),
                 below("worst off the law after 3 s", worst_off, 0.05, 100.0, "%"),
                 below_N("step", worst_step_N, kMostStep_N)});
}

}  // namespace
}  // namespace telepalp::surface

namespace telepalp::hard_cases {

std::vector<HardCase> return_rows() {
  using namespace surface;
  const char* const back = "felt within 1.5 s, the law after 3 s, no step";
  return {
      {"frames missing 1.6 s", "the contact ends at depth", back, frames_missing_1_6_s},
      {"frames missing 3 s", "the contact ends at depth", back, frames_missing_3_s},
      {"frames missing 5 s, 30 mm up", "the skin is then above the hand", back, frames_missing_5_s_risen},
      {"stalled 0.9 s, 25 mm up", "the step is beyond the gate", back, stalled_and_risen},
      {"image 30 mm nearer", "the step is beyond the gate", back, nearer_by_30_mm},
      {"patient 10 mm lower", "the skin sinks from the hand", back, farther_by_10_mm},
      {"patient replaced, 55 mm nearer", "another surface, over the same hand", back, replaced_by_another},
      {"black for 2 s", "nothing is seen", back, black_for_2_s},
      {"hole for 3 s", "nothing is seen under the hand", back, hole_for_3_s},
      {"foreign hand for 3 s", "it hides the skin", back, foreign_hand_for_3_s},
      {"foreign hand near the skin", "it looks like risen skin", back, low_foreign_hand_for_3_s},
      {"foreign hand that is felt", "one contact follows another at once", back, felt_foreign_hand_for_3_s},
      {"under a steep object", "its nearest part is to the side", "no push to the side", under_a_steep_object},
      {"between two hands", "silhouettes on both sides", "contact holds, no step", between_two_hands},
      {"camera moved in contact", "the whole image tilts and jumps", back, camera_moved},
      {"at the image's border", "half of the support is missing", "fades, no step", at_the_images_border},
      {"skin folds over the finger", "the camera sees the fold, not the dent", back, skin_folds_over_the_finger},
      {"snapshot older than the last", "the link reorders", "dropped, counted, no step", older_than_the_last},
      {"accidents 1 to 50", "gaps, shifts, holes, black, hands", back, fifty_accidents<1>},
      {"accidents 51 to 100", "gaps, shifts, holes, black, hands", back, fifty_accidents<51>},
      {"accidents 101 to 150", "gaps, shifts, holes, black, hands", back, fifty_accidents<101>},
      {"accidents 151 to 200", "gaps, shifts, holes, black, hands", back, fifty_accidents<151>},
  };
}

}  // namespace telepalp::hard_cases
