// The camera's model and the times of its images, as the wire carries them.

#include <gtest/gtest.h>

#include <limits>

#include "proto/wire/camera/calibration_message.h"
#include "proto/wire/camera/camera_stamp.h"

namespace telepalp::wire {
namespace {

foxglove::CameraCalibration calibration(std::uint32_t width, std::uint32_t height, double fx) {
  foxglove::CameraCalibration message;
  message.set_width(width);
  message.set_height(height);
  for (const double value : {fx, 0.0, 320.0, 0.0, 530.0, 240.0, 0.0, 0.0, 1.0}) message.add_k(value);
  return message;
}

TEST(CalibrationMessage, GivesTheIntrinsicsOfK) {
  const Intrinsics expected{.width = 640, .height = 480, .fx = 525.0, .fy = 530.0, .cx = 320.0, .cy = 240.0};
  EXPECT_EQ(intrinsics_of(calibration(640, 480, 525.0)), expected);
}

TEST(CalibrationMessage, IsRefusedWhenItsSizeOrItsNumbersAreImpossible) {
  EXPECT_FALSE(intrinsics_of(foxglove::CameraCalibration())) << "no K";
  EXPECT_FALSE(intrinsics_of(calibration(640, 0, 525.0)));
  EXPECT_FALSE(intrinsics_of(calibration(std::numeric_limits<std::uint32_t>::max(), 480, 525.0)));
  EXPECT_FALSE(intrinsics_of(calibration(kMaxImageSide + 1, 480, 525.0)));
  EXPECT_FALSE(intrinsics_of(calibration(640, 480, 0.0)));
  EXPECT_FALSE(intrinsics_of(calibration(640, 480, std::numeric_limits<double>::quiet_NaN())));
}

TEST(CameraStamp, KeepsSessionTimeToTheNanosecond) {
  google::protobuf::Timestamp timestamp;
  set_stamp(timestamp, session_time(1'763'800'000'123'456'789));
  EXPECT_EQ(timestamp.seconds(), 1'763'800'000);
  EXPECT_EQ(stamp_ns(timestamp), 1'763'800'000'123'456'789);
}

TEST(CameraStamp, OfAnImpossibleTimeDoesNotOverflow) {  // undefined behaviour would stop the sanitized run
  google::protobuf::Timestamp timestamp;
  timestamp.set_seconds(std::numeric_limits<std::int64_t>::max());
  timestamp.set_nanos(-1);
  EXPECT_EQ(stamp_ns(timestamp), -1'000'000'001);
}

}  // namespace
}  // namespace telepalp::wire
