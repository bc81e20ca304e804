// The camera's model and the times of its images, as the wire carries them.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "foxglove/CompressedImage.pb.h"
#include "foxglove/CompressedVideo.pb.h"
#include "proto/wire/camera/calibration_message.h"
#include "proto/wire/camera/camera_stamp.h"
#include "proto/wire/camera/color_message.h"

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

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

TEST(ColorCoding, VideoReplacesPicturesInWhateverCoversThem) {
  for (const std::string wanted : {"*", "/camera/*", "/camera/color*", "/camera/color"}) {
    const std::vector<std::string> names = subscription_for(ColorCoding::Video, {wanted, "/station/*"});
    EXPECT_TRUE(contains(names, kCameraColorVideo.name)) << wanted;
    EXPECT_FALSE(contains(names, kCameraColor.name)) << wanted;
    EXPECT_TRUE(contains(names, "/station/*")) << wanted;
    EXPECT_FALSE(contains(names, kViewerHand.name)) << "a recorder takes no hand";
    EXPECT_EQ(contains(names, "/camera/depth*"), wanted == "*" || wanted == "/camera/*") << wanted;
    EXPECT_EQ(contains(names, "/camera/color/info*"), wanted != "/camera/color") << wanted;
  }
}

TEST(ColorCoding, WhoWantsNoColourGetsNone) {
  const std::vector<std::string> depth{"/camera/depth", "/station/*"};
  EXPECT_EQ(subscription_for(ColorCoding::Video, depth), depth);
  EXPECT_EQ(subscription_for(ColorCoding::Pictures, {"*"}), std::vector<std::string>{"*"});
}

TEST(ColorCoding, IsNamedByTheUser) {
  EXPECT_EQ(color_coding("jpeg", "--color").value(), ColorCoding::Pictures);
  EXPECT_EQ(color_coding("vp8", "--color").value(), ColorCoding::Video);
  for (const char* wrong : {"", "JPEG", "vp9", "video"}) EXPECT_FALSE(color_coding(wrong, "--color")) << wrong;
}

TEST(CompressedColor, IsReadFromBothTopicsAndFromNoOther) {
  const auto of = [](const Topic& topic, const std::string& payload) {
    return compressed_color({topic, session_time(5), std::make_shared<const std::string>(payload), 7, true});
  };
  foxglove::CompressedImage picture;
  set_stamp(*picture.mutable_timestamp(), session_time(1'000'000'003));
  picture.set_format("jpeg");
  picture.set_data("PICTURE");
  const auto color = of(kCameraColor, picture.SerializeAsString());
  ASSERT_TRUE(color);
  EXPECT_EQ(color->captured_ns, 1'000'000'003);
  EXPECT_EQ(color->format + " " + color->data, "jpeg PICTURE");
  EXPECT_EQ(color->number, 7U);
  foxglove::CompressedVideo video;
  video.set_format("vp8");
  video.set_data("FRAME");
  EXPECT_EQ(of(kCameraColorVideo, video.SerializeAsString())->data, "FRAME");
  EXPECT_FALSE(of(kCameraDepth, picture.SerializeAsString()));
  EXPECT_FALSE(of(kCameraColorVideo, "\xff\xff"));
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
