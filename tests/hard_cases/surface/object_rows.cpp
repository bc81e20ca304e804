#include "proto/words/smooth_step.h"
#include "tests/hard_cases/surface/driven.h"
#include "tests/hard_cases/surface/seen_patient.h"

namespace telepalp::surface {
namespace {

constexpr double kBeyond_N = 0.3;  // most by which the force may exceed that without the object
constexpr double kMeans_N = 0.6;   // the same while the body rises under the object

/// An object of 60 × 60 pixels (90 mm) at the depth `z_m`, with an arm 40 pixels wide to the image's edge, comes from
/// the right at 0.3 m/s, is over the device at 2 s, stays for `stays_s` and leaves as it came.
SeenPatient visited(double z_m, double stays_s) {
  SeenPatient patient;
  patient.over_m = [=](int u, int v, double t) {
    const double way_px = 200.0 * std::max({0.0, 2.0 - t, t - 2.0 - stays_s});  // 0.3 m/s
    const double ahead_px = u - (50.0 + way_px);                                // behind the hand's front
    const bool hand = ahead_px > 0.0 && ahead_px < 60.0 && std::abs(v - 60) < 30;
    const bool arm = ahead_px >= 60.0 && std::abs(v - 60) < 20;
    return hand || arm ? z_m : std::nan("");
  };
  patient.depth_m = 0.004;                     // 2 N: more force would be seen
  patient.well_again_s = 2.0 + stays_s + 0.6;  // it has left the image
  return patient;
}

AssertionResult adds_no_force(const SeenPatient& patient) {
  const Returned got = press_on(patient);
  return all_of({{got.touched_before, "was in contact"},
                 below_N("beyond the skin's force", got.most_beyond_N, kBeyond_N),
                 below("felt again", got.felt_after_s, 1.0, 1.0, "s"),
                 below("off the law after 3 s", got.off_after_3_s, 0.05, 100.0, "%"),
                 below_N("step", got.worst_step_N, kMostStep_N)});
}

AssertionResult hand_20_mm_over() { return adds_no_force(visited(0.78, 5.0)); }
AssertionResult hand_60_mm_over() { return adds_no_force(visited(0.74, 5.0)); }
AssertionResult hand_90_mm_over() { return adds_no_force(visited(0.71, 5.0)); }
AssertionResult hand_60_mm_over_a_deep_finger() {
  SeenPatient patient = visited(0.74, 5.0);
  patient.depth_m = 0.04;
  return adds_no_force(patient);
}

/// The skin rises by 10 mm while the object lies over it.
AssertionResult body_rises_under_the_hand() {
  SeenPatient patient = visited(0.74, 0.9);
  patient.lift_m = [](double t) { return 0.01 * smooth_step((t - 2.1) / 0.4); };
  const Returned got = press_on(patient);
  return all_of({{got.touched_before && got.never_lost, "felt all the time"},
                 below_N("beyond the skin's force", got.most_beyond_N, kMeans_N),
                 below("off the law after 3 s", got.off_after_3_s, 0.05, 100.0, "%"),
                 below_N("step", got.worst_step_N, kMostStep_N)});
}

/// An arm lies over a quarter of the image, 60 mm beside the device. The belly rises as in a cough, by 13 mm, more
/// than the rest of the body.
AssertionResult coughs_beside_an_arm() {
  SeenPatient patient;
  patient.depth_m = 0.004;
  patient.over_m = [](int u, int v, double t) {
    if (t > 1.5 && v > 90) return 0.74;
    const double belly = std::exp(-0.5 * (std::pow((u - 80.0) / 40.0, 2.0) + std::pow((v - 75.0) / 30.0, 2.0)));
    const double cough = t < 2.5 ? 0.0 : std::pow(std::sin(M_PI * std::fmod(t - 2.5, 1.5) / 1.5), 2.0);
    return 0.8 - 0.013 * belly * cough;
  };
  patient.well_again_s = 6.25;  // at the top of the third cough, 11 mm up at the device
  const Returned got = press_on(patient);
  return all_of({{got.touched_before && got.never_lost, "felt all the time"},
                 above("felt at its new place, 11 mm higher", got.last_N, 6.5, 1.0, "N"),
                 below_N("step", got.worst_step_N, kMostStep_N)});
}

/// What was remembered is no longer felt under an object that stays.
AssertionResult remembered_skin_fades() {
  const auto force_after_N = [](double seconds) {
    SeenPatient patient = visited(0.74, seconds);
    patient.well_again_s = 2.0 + seconds;  // the hand is still there
    return press_on(patient).last_N;
  };
  return all_of(
      {above("after 0.9 s", force_after_N(0.9), 1.8, 1.0, "N"), below_N("after 4 s", force_after_N(4.0), kBeyond_N)});
}

/// The upper half of the body sits up by 15 degrees in 2 s, into the hand.
AssertionResult patient_sits_up() {
  SeenPatient patient;
  patient.depth_m = 0.004;
  patient.over_m = [](int u, int /*v*/, double t) {
    const double up = 0.26 * smooth_step((t - 2.0) / 2.0);
    const double from_hips_m = 0.0015 * (u - 20.0);
    return t < 2.0 || u < 20 ? std::nan("") : 0.8 - up * from_hips_m;
  };
  patient.well_again_s = 2.0 + 0.8;  // the skin is 8 mm higher at the device
  const Returned got = press_on(patient);
  return all_of({{got.touched_before && got.never_lost, "felt all the time"},
                 above("felt at its new place, 8 mm higher", got.last_N, 5.0, 1.0, "N")});
}

/// A towel is laid on the skin. The doctor lifts the hand 70 mm over it, and presses it.
AssertionResult towel_is_pressed_anew() {
  SeenPatient patient;
  patient.over_m = [](int u, int v, double t) {
    return t > 2.0 && std::abs(u - 80) < 40 && std::abs(v - 60) < 40 ? 0.77 : std::nan("");
  };
  patient.depth_m = 0.0;
  patient.raised_m = [](double t) { return 0.10 * smooth_step((t - 3.0) / 0.5) - 0.08 * smooth_step((t - 4.0) / 1.0); };
  patient.well_again_s = 6.0;  // the device rests 10 mm below the towel's surface
  const Returned got = press_on(patient);
  return all_of(
      {above("the towel is felt", got.last_N, 4.5, 1.0, "N"), below_N("step", got.worst_step_N, kMostStep_N)});
}

/// A towel is laid on the skin under a hand that rests on it, and accepted at once. The hand is lifted by 40 mm, so
/// that it is never clear of the towel, and comes down again.
Returned towel_is_accepted(bool accepts) {
  SeenPatient patient;
  patient.over_m = [](int u, int v, double t) {
    return t > 2.0 && std::abs(u - 80) < 40 && std::abs(v - 60) < 40 ? 0.77 : std::nan("");
  };
  patient.depth_m = 0.0;
  patient.accepts = [accepts](double t) { return accepts && t > 2.2 && t < 2.24; };
  patient.raised_m = [](double t) { return 0.05 * smooth_step((t - 3.0) / 0.5) - 0.03 * smooth_step((t - 4.0) / 1.0); };
  patient.well_again_s = 6.0;  // the device rests 10 mm below the towel's surface
  return press_on(patient);
}

AssertionResult towel_is_accepted_by_the_button() {
  const Returned without = towel_is_accepted(false);
  const Returned got = towel_is_accepted(true);
  return all_of({below_N("not accepted", without.last_N, kBeyond_N),
                 above("the towel is felt", got.last_N, 4.5, 1.0, "N"),
                 below_N("step", got.worst_step_N, kMostStep_N)});
}

/// A towel is laid 25 mm beside the place, so that only the blocks at its edge reach it. It is accepted while the hand
/// is 50 mm over the skin; then the hand goes 45 mm to the side and presses the towel.
AssertionResult towel_beside_the_place_is_accepted() {
  SeenPatient patient;
  patient.over_m = [](int u, int v, double t) {
    return t > 2.0 && u >= 96 && std::abs(v - 60) < 40 ? 0.77 : std::nan("");
  };
  patient.depth_m = 0.0;
  patient.accepts = [](double t) { return t > 3.6 && t < 3.64; };
  patient.device_x_m = [](double t) { return 0.06 * smooth_step((t - 4.0) / 0.5); };
  patient.raised_m = [](double t) { return 0.05 * smooth_step((t - 3.0) / 0.5) - 0.03 * smooth_step((t - 4.6) / 0.8); };
  patient.well_again_s = 6.0;  // the device rests 10 mm below the towel's surface
  const Returned got = press_on(patient);
  return all_of(
      {above("the towel is felt", got.last_N, 4.5, 1.0, "N"), below_N("step", got.worst_step_N, kMostStep_N)});
}

/// Another's finger lies on the skin, 36 mm wide, and the camera sees nothing in the 9 mm around it. Some blocks at its
/// rim were measured at first. It is accepted while the hand is 50 mm over the skin, and pressed.
AssertionResult finger_with_a_ragged_rim_is_accepted() {
  SeenPatient patient;
  patient.over_m = [](int u, int v, double t) {
    const int from_middle = std::max(std::abs(u - 80), std::abs(v - 60));
    if (t < 2.0 || from_middle > 18) return std::nan("");
    return from_middle < 12 || t < 2.5 ? 0.77 : 0.0;
  };
  patient.depth_m = 0.0;
  patient.accepts = [](double t) { return t > 3.6 && t < 3.64; };
  patient.raised_m = [](double t) { return 0.05 * smooth_step((t - 3.0) / 0.5) - 0.03 * smooth_step((t - 4.0) / 1.0); };
  patient.well_again_s = 6.0;  // the device rests 10 mm below the finger's surface
  const Returned got = press_on(patient);
  return all_of({{!got.says_object, "the page no longer says that an object lies there"},
                 above("the finger is felt", got.last_N, 4.5, 1.0, "N"),
                 below_N("step", got.worst_step_N, kMostStep_N)});
}

/// An accepted object does not push the device that is below it.
AssertionResult hand_is_accepted_over_the_finger() {
  SeenPatient patient = visited(0.74, 5.0);
  patient.accepts = [](double t) { return t > 2.5 && t < 2.54; };
  return adds_no_force(patient);
}

/// A body of 120 x 120 pixels on a bed 150 mm deeper. What jumps comes 30 mm nearer at 2 s, between two images.
Returned jumped(bool bed_too) {
  SeenPatient patient;
  patient.depth_m = 0.004;
  patient.lift_m = [](double t) { return t < 2.0 ? 0.0 : 0.03; };
  patient.over_m = [bed_too](int u, int /*v*/, double t) {
    return u < 120 ? std::nan("") : 0.95 - (bed_too && t >= 2.0 ? 0.03 : 0.0);
  };
  patient.well_again_s = 2.6;
  return press_on(patient);
}

AssertionResult camera_is_pushed() {
  const Returned got = jumped(true);
  return all_of({{got.touched_before && !got.never_lost, "the contact ends"},
                 below_N("0.6 s after it", got.last_N, kBeyond_N),
                 below("felt again", got.felt_after_s, 1.0, 1.0, "s")});
}

AssertionResult patient_jumps_on_a_resting_bed() {
  const Returned got = jumped(false);
  return all_of({{got.touched_before && got.never_lost, "felt all the time"},
                 above("felt at its new place", got.last_N, 5.0, 1.0, "N")});
}

}  // namespace
}  // namespace telepalp::surface

namespace telepalp::hard_cases {

std::vector<HardCase> object_rows() {
  using namespace surface;
  const char* const harmless = "no more force than the skin's, felt within 1 s after it";
  return {
      {"another's hand 20 mm over the skin", "it looks like risen skin", harmless, hand_20_mm_over},
      {"another's hand 60 mm over the skin", "it hides the pressed place", harmless, hand_60_mm_over},
      {"another's hand 90 mm over the skin", "it hides the pressed place", harmless, hand_90_mm_over},
      {"another's hand over a deep finger", "the finger is 100 mm below it", harmless, hand_60_mm_over_a_deep_finger},
      {"body rises under another's hand", "the place is not seen", "the remembered skin rises, too",
       body_rises_under_the_hand},
      {"cough beside an arm", "the arm hides a quarter of the image, the belly moves", "the belly stays skin",
       coughs_beside_an_arm},
      {"another's hand stays", "the skin is not seen for long", "felt for 1 s, no force after 3 s",
       remembered_skin_fades},
      {"patient sits up into the hand", "skin comes nearer by up to 54 mm on half of the image", "is felt",
       patient_sits_up},
      {"towel on the skin is pressed", "it looks like another's hand", "felt, once the hand was clear of it",
       towel_is_pressed_anew},
      {"towel on the skin is accepted", "it looks like another's hand", "felt as soon as the hand is above it",
       towel_is_accepted_by_the_button},
      {"towel beside the place is accepted", "only the blocks that its edge hides reach the place",
       "felt as soon as the hand is above it", towel_beside_the_place_is_accepted},
      {"finger with a ragged rim is accepted",
       "blocks of its rim are no longer measured, so nothing tells that they went",
       "felt, and the page stops saying that it lies there", finger_with_a_ragged_rim_is_accepted},
      {"another's hand is accepted over a finger", "its surface lies 60 mm over the finger", harmless,
       hand_is_accepted_over_the_finger},
      {"the camera is pushed", "bed and body jump together", "lets go, then feels the skin where it is seen now",
       camera_is_pushed},
      {"patient jumps on a resting bed", "all of the body jumps between two images", "is felt",
       patient_jumps_on_a_resting_bed},
  };
}

}  // namespace telepalp::hard_cases
