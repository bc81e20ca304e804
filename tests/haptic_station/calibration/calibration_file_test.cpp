#include "haptic_station/calibration/calibration_file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace telepalp::calibration {
namespace {

namespace fs = std::filesystem;

const Eigen::Isometry3d kTransform =
    Eigen::Translation3d(0.1, -0.25, 1.0 / 3.0) * Eigen::AngleAxisd(3.0, Eigen::Vector3d(1, 0, 1).normalized());

fs::path fresh_file(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / "telepalp_calibration";
  fs::create_directories(folder);
  fs::remove(folder / name);
  return folder / name;
}

msg::Calibration made() {
  msg::Calibration calibration;
  const auto date = std::chrono::system_clock::time_point(std::chrono::seconds(1'767'225'600));
  *calibration.mutable_haptic_from_camera() = measured(kTransform, {{0.001, 0.002, 0.003}}, "points", date, 3);
  return calibration;
}

TEST(CalibrationFile, ReadsBackWhatWasWrittenToTheLastBit) {
  const fs::path file = fresh_file("a.calibration.textproto");
  ASSERT_TRUE(write_calibration(file, made()));
  const Result<msg::Calibration> read = read_calibration(file);
  ASSERT_TRUE(read) << to_string(read.error());
  EXPECT_FALSE(read->has_haptic_from_tracker());
  EXPECT_EQ(read->haptic_from_camera().SerializeAsString(), made().haptic_from_camera().SerializeAsString());
  const Result<Eigen::Isometry3d> transform = transform_of(read->haptic_from_camera(), "test");
  ASSERT_TRUE(transform);
  EXPECT_LT((transform->matrix() - kTransform.matrix()).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(CalibrationFile, HoldsDateMethodAndResidualForPeopleToRead) {
  const fs::path file = fresh_file("b.calibration.textproto");
  ASSERT_TRUE(write_calibration(file, made()));
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  for (const char* part : {"date: \"2026-01-01T00:00:00Z\"", "method: \"points\"", "residual_mean_m: 0.002",
                           "residual_deviation_m: 0.001", "measurements: 3", "rank: 3"})
    EXPECT_NE(text.str().find(part), std::string::npos) << part << " in\n" << text.str();
}

TEST(CalibrationFile, RefusesWhatIsDamagedOrNotFinite) {
  const fs::path file = fresh_file("c.calibration.textproto");
  for (const char* text :
       {"haptic_from_camera {", "unknown: 1", "haptic_from_camera { transform { translation_m { x: nan } } }",
        "haptic_from_tracker { transform { translation_m { x: 1e9 } } }",
        "haptic_from_tracker { transform { rotation_vector_rad { y: inf } } }", "haptic_from_tracker { }",
        "haptic_from_tracker { transform { translation_m { x: 0,1 } } }"}) {
    std::ofstream(file) << text;
    const Result<msg::Calibration> read = read_calibration(file);
    ASSERT_FALSE(read) << text;
    EXPECT_NE(to_string(read.error()).find(file.string()), std::string::npos) << to_string(read.error());
  }
  EXPECT_FALSE(read_calibration("/nowhere/c.calibration.textproto"));
  EXPECT_FALSE(write_calibration("/nowhere/c.calibration.textproto", made()));
}

}  // namespace
}  // namespace telepalp::calibration
