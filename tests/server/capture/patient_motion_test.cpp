#include "server/capture/synthetic/motion/patient_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "server/capture/synthetic/source/synthetic_spec.h"
#include "server/capture/synthetic/synthetic_patient.h"
#include "support/program/files/shipped.h"

namespace telepalp::capture {
namespace {

constexpr double kStep_s = 1e-4;
const Point<DepthCamera> kBelow{{0.02, 0.01, 0.9}};  // inside the patient: a line upwards meets the belly

SessionTime at_seconds(double seconds) { return session_time(1'700'000'000'000'000'000) + from_seconds(seconds); }

PatientMotion motion_of(Motion motion, std::uint64_t seed = 1) { return {motion, 0.005, 0.25, seed}; }

SyntheticPatient patient_who(Motion motion) {
  const auto mesh = read_mesh(program::shipped_file("deploy/demo_data/torso/visible_human_torso.ply").value());
  return *SyntheticPatient::make(
      *mesh, {.camera = {.width = 320, .height = 240, .fx = 525.0, .fy = 525.0, .cx = 159.5, .cy = 119.5},
              .motion = motion,
              .noise = DepthNoise::None,
              .disparity_steps = false,
              .holes = false,
              .depth_unit_m = 0.0001});
}

class PatientMotions : public testing::TestWithParam<Motion> {};

TEST_P(PatientMotions, MoveContinuouslyAtTheRateThatTheyState) {
  const PatientMotion motion = motion_of(GetParam());
  for (double t = 0.0; t < 90.0; t += 0.0137) {
    const PatientPose before = motion.at(at_seconds(t - kStep_s));
    const PatientPose here = motion.at(at_seconds(t));
    const PatientPose after = motion.at(at_seconds(t + kStep_s));
    const auto rate = [](double a, double b) { return (b - a) / (2.0 * kStep_s); };
    ASSERT_NEAR(rate(before.breath.lift_m, after.breath.lift_m), here.breath.speed_m_per_s, 2e-3) << t;
    ASSERT_NEAR(rate(before.rise_m, after.rise_m), here.rise_m_per_s, 1e-3) << t;
    ASSERT_NEAR(rate(before.tilt, after.tilt), here.tilt_per_s, 1e-3) << t;
    ASSERT_LT(((after.slide_m - before.slide_m) / (2.0 * kStep_s) - here.slide_m_per_s).norm(), 1e-3) << t;
  }
}

TEST_P(PatientMotions, AreTheSameForTheSameSeedAndOthersForAnother) {
  const PatientMotion motion = motion_of(GetParam(), 7);
  const PatientMotion same = motion_of(GetParam(), 7);
  const PatientMotion other = motion_of(GetParam(), 8);
  double differs_m = 0.0;
  for (double t = 0.0; t < 60.0; t += 0.1) {
    const PatientPose pose = motion.at(at_seconds(t));
    EXPECT_EQ(pose.breath.lift_m, same.at(at_seconds(t)).breath.lift_m);
    differs_m = std::max(differs_m, std::abs(pose.breath.lift_m - other.at(at_seconds(t)).breath.lift_m));
  }
  if (GetParam() == Motion::Regular) return;
  EXPECT_GT(differs_m, 0.001);
}

TEST_P(PatientMotions, TheTrueHeightMovesAtItsStatedSpeedAndTheCameraSeesIt) {
  const SyntheticPatient patient = patient_who(GetParam());
  const Vector<DepthCamera> up{-Eigen::Vector3d::UnitZ()};
  for (double t = 0.3; t < 40.0; t += 0.73) {
    const auto before = patient.true_surface(at_seconds(t - kStep_s)).height_along(kBelow, up);
    const auto here = patient.true_surface(at_seconds(t)).height_along(kBelow, up);
    const auto after = patient.true_surface(at_seconds(t + kStep_s)).height_along(kBelow, up);
    ASSERT_TRUE(before && here && after) << t;
    ASSERT_NEAR((after->m - before->m) / (2.0 * kStep_s), here->m_per_s, 2e-3) << t;
    const RgbdFrame frame = patient.frame_at(at_seconds(t), 0);
    const double seen_m = frame.depth.at(150, 110) * frame.depth.unit_m;
    ASSERT_NEAR(seen_m, patient.true_surface(at_seconds(t)).depth_m(150, 110), 0.0001) << t;
  }
}

INSTANTIATE_TEST_SUITE_P(All, PatientMotions, testing::ValuesIn(all_motions().begin(), all_motions().end()),
                         [](const auto& one) {
                           std::string text(name(one.param));
                           std::erase(text, '-');
                           return text;
                         });

TEST(PatientMotion, AHeldBreathStandsStillForSevenSecondsInTwenty) {
  const PatientMotion motion = motion_of(Motion::Hold);
  int still = 0;
  for (int i = 0; i < 6000; ++i) still += motion.at(at_seconds(0.01 * i)).breath.speed_m_per_s == 0.0 ? 1 : 0;
  EXPECT_NEAR(0.01 * still, 3 * 7.5, 1.0 + 0.15 * 60);  // pauses after exhales stand still too
  EXPECT_GT(0.01 * still, 3 * 7.4);
}

TEST(PatientMotion, NoTwoIrregularBreathsAreAlike) {
  const PatientMotion motion = motion_of(Motion::Irregular);
  double least_m = 1.0;
  double most_m = 0.0;
  double peak_m = 0.0;
  bool rising = false;
  for (int i = 0; i < 20'000; ++i) {
    const Breath breath = motion.at(at_seconds(0.01 * i)).breath;
    if (rising && breath.speed_m_per_s <= 0.0) {
      least_m = std::min(least_m, peak_m);
      most_m = std::max(most_m, peak_m);
    }
    rising = breath.speed_m_per_s > 0.0;
    peak_m = breath.lift_m;
  }
  EXPECT_LT(least_m, 0.0040);
  EXPECT_GT(most_m, 0.0060);
  EXPECT_GE(least_m, 0.0034);
  EXPECT_LE(most_m, 0.0066);
}

TEST(SyntheticSpec, TakesEveryMotionByItsNameAndRefusesOthers) {
  for (const Motion motion : all_motions()) {
    const auto spec = parse_synthetic_spec("torso,motion=" + std::string(name(motion)) + ",seed=3");
    ASSERT_TRUE(spec) << name(motion);
    EXPECT_EQ(spec->settings.motion, motion);
    EXPECT_EQ(spec->settings.seed, 3U);
  }
  const auto unknown = parse_synthetic_spec("torso,motion=dance");
  ASSERT_FALSE(unknown);
  EXPECT_NE(unknown.error().fix.find("sit-up"), std::string::npos);
}

}  // namespace
}  // namespace telepalp::capture
