#include "haptic_station/tracking/hand_trace.h"
#include "where.h"

#include <gtest/gtest.h>

namespace telepalp::tracking {
namespace {

constexpr const char* kHeader = "timestamp_us,hand_id,palm_x_mm,palm_y_mm,palm_z_mm\n";

TEST(HandTrace, ReadsTheShippedRecording) {
  const Result<HandTrace> trace = read_hand_trace(TELEPALP_SOURCE_DIR "/deploy/demo_data/hand_grab.csv");
  ASSERT_TRUE(trace.ok()) << to_string(trace.error());
  EXPECT_EQ(trace->samples.size(), 374U);
  EXPECT_NEAR(to_seconds(trace->samples.back().at.time_since_epoch()), 3.3, 0.1);
  EXPECT_NEAR(trace->samples.front().palm.m.y(), 0.185083, 1e-9);
}

TEST(HandTrace, SkipsAndCountsWhatCannotBeUsed) {
  const Result<HandTrace> trace = parse_hand_trace(std::string(kHeader) +
                                                       "1000,1,1,2,3\r\n"
                                                       "500,1,1,2,3\n"     // back in time
                                                       "2000,2,1,2,3\n"    // another hand
                                                       "3000,1,nan,2,3\n"  // no number
                                                       "4000,1,1;5,2,3\n"  // number in another locale
                                                       "5000,1,1,2\n"      // short
                                                       "6000,1,4,5,6",
                                                   "t.csv");
  ASSERT_TRUE(trace.ok());
  EXPECT_EQ(trace->samples.size(), 2U);
  EXPECT_EQ(trace->skipped, 5U);
  EXPECT_EQ(trace->samples.back().at, SessionTime{std::chrono::microseconds(5000)});
}

TEST(HandTrace, ReadsTheAttitudeFromAQuaternionOrFromTwoDirections) {
  const Result<HandTrace> shipped = read_hand_trace(TELEPALP_SOURCE_DIR "/deploy/demo_data/hand_grab.csv");
  ASSERT_TRUE(shipped.ok()) << to_string(shipped.error());
  ASSERT_TRUE(shipped->samples[0].attitude);
  const Eigen::Vector3d palm(-0.131365, -0.683878, -0.717673);
  EXPECT_LT((*shipped->samples[0].attitude * Eigen::Vector3d::UnitZ() + palm).norm(), 1e-3);
  const Result<HandTrace> trace = parse_hand_trace(
      "timestamp_us,palm_x_mm,palm_y_mm,palm_z_mm,qx,qy,qz,qw\n"
      "1,0,0,0,0.6,0,0,0.8\n2,0,0,0,0,0,0,0\n3,0,0,0,nan,0,0,1\n",
      "t.csv");
  ASSERT_TRUE(trace.ok());
  ASSERT_EQ(trace->samples.size(), 3U);
  EXPECT_NEAR(trace->samples[0].attitude->x(), 0.6, 1e-12);
  EXPECT_FALSE(trace->samples[1].attitude) << "no rotation";
  EXPECT_FALSE(trace->samples[2].attitude) << "no number";
}

TEST(HandTrace, ARecordedPersonTurnsTheHandAsTheTraceDoes) {
  const Result<HandTrace> trace = parse_hand_trace(
      "timestamp_us,palm_x_mm,palm_y_mm,palm_z_mm,qx,qy,qz,qw\n0,0,0,0,0,0,0,1\n1000000,10,0,0,0.6,0,0,0.8\n", "t.csv");
  ASSERT_TRUE(trace.ok());
  Transform<HapticBase, HandTracker> turned;
  turned.iso.linear() = Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const RecordedIntention person(*trace, turned, {}, 0.0);
  const Eigen::Quaterniond end = Eigen::Quaterniond(turned.iso.linear()) * Eigen::Quaterniond(0.8, 0.6, 0.0, 0.0);
  ASSERT_TRUE(person.attitude(1.0));
  EXPECT_LT(person.attitude(1.0)->angularDistance(end), 1e-9);
  EXPECT_NEAR(person.attitude(1.5)->angularDistance(end), 0.5 * person.attitude(0.0)->angularDistance(end), 1e-9);
}

TEST(HandTrace, NamesTheColumnThatIsMissing) {
  const Result<HandTrace> trace = parse_hand_trace("timestamp_us,palm_x_mm,palm_z_mm\n1,2,3\n", "t.csv");
  ASSERT_FALSE(trace.ok());
  EXPECT_NE(trace.error().what.find("palm_y_mm"), std::string::npos);
}

TEST(HandTrace, OneSampleIsNoTrace) {
  EXPECT_FALSE(parse_hand_trace(std::string(kHeader) + "1,1,1,1,1\n", "t.csv").ok());
  EXPECT_FALSE(parse_hand_trace("", "t.csv").ok());
}

TEST(RecordedIntention, GoesThereAndBackAndReachesTheDepth) {
  const Result<HandTrace> trace = read_hand_trace(TELEPALP_SOURCE_DIR "/deploy/demo_data/hand_grab.csv");
  ASSERT_TRUE(trace.ok());
  const RecordedIntention person(*trace, {}, {{0.0, 0.1, 0.0}}, 0.04);
  double lowest_m = 1.0;
  Eigen::Vector3d last = person.at(0.0).at.m;
  for (double t = 0.0; t < 4.0 * person.duration_s(); t += 0.001) {
    const device::Intention now = person.at(t);
    lowest_m = std::min(lowest_m, now.at.m.y());
    ASSERT_LT((now.at.m - last).norm(), 0.003) << "no jump, at the ends either";
    last = now.at.m;
  }
  EXPECT_NEAR(lowest_m, 0.06, 0.002);
}

}  // namespace
}  // namespace telepalp::tracking
