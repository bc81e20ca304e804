#include "haptic_station/calibration/calibration_file.h"

#include <google/protobuf/text_format.h>

#include <cstdio>
#include <ctime>

#include "proto/wire/vector_message.h"
#include "proto/words/rotation_vector.h"
#include "support/program/files/whole_file.h"
#include "support/program/text/text_format.h"

namespace telepalp::calibration {
namespace {

constexpr double kFurthest_m = 10.0;
constexpr double kLongestTurn_rad = 6.3;

std::string utc_text(std::chrono::system_clock::time_point at) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(at);
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char text[32];
  const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {text, length};
}

}  // namespace

msg::MeasuredTransform measured(const Eigen::Isometry3d& to_from_from, const Residuals& residuals,
                                const std::string& method, std::chrono::system_clock::time_point date, int rank) {
  msg::MeasuredTransform message;
  const Eigen::AngleAxisd turn(to_from_from.linear());
  wire::set_vector(*message.mutable_transform()->mutable_translation_m(), to_from_from.translation());
  wire::set_vector(*message.mutable_transform()->mutable_rotation_vector_rad(), turn.axis() * turn.angle());
  message.set_date(utc_text(date));
  message.set_method(method);
  message.set_measurements(static_cast<std::uint32_t>(residuals.each_m.size()));
  message.set_residual_rms_m(residuals.rms_m());
  message.set_residual_mean_m(residuals.mean_m());
  message.set_residual_deviation_m(residuals.deviation_m());
  message.set_residual_largest_m(residuals.largest_m());
  message.set_rank(static_cast<std::uint32_t>(rank));
  return message;
}

Result<Eigen::Isometry3d> transform_of(const msg::MeasuredTransform& message, const std::string& where) {
  const Eigen::Vector3d translation = wire::vector_of(message.transform().translation_m());
  const Eigen::Vector3d turn = wire::vector_of(message.transform().rotation_vector_rad());
  if (!message.has_transform() || !translation.allFinite() || !turn.allFinite() ||
      translation.cwiseAbs().maxCoeff() > kFurthest_m || turn.norm() > kLongestTurn_rad)
    return Error{
        .what = "the transform is missing or not finite, moves by more than 10 m, or turns by more than a full turn",
        .where = where,
        .fix = "calibrate again with telepalp-station calibrate"};
  return isometry_of(turn, translation);
}

Result<msg::Calibration> read_calibration(const std::filesystem::path& file) {
  msg::Calibration calibration;
  if (const auto read = program::read_text_format(file, calibration); !read) return read.error();
  for (const auto& [has, transform, name] :
       {std::tuple{calibration.has_haptic_from_tracker(), &calibration.haptic_from_tracker(), "haptic_from_tracker"},
        std::tuple{calibration.has_haptic_from_camera(), &calibration.haptic_from_camera(), "haptic_from_camera"}})
    if (has)
      if (const auto checked = transform_of(*transform, file.string() + ": " + name); !checked) return checked.error();
  return calibration;
}

Result<void> write_calibration(const std::filesystem::path& file, const msg::Calibration& calibration) {
  std::string text;
  google::protobuf::TextFormat::PrintToString(calibration, &text);
  constexpr auto kHead =
      "# Transforms, measured by telepalp-station calibrate and read by telepalp-station --calibration.\n";
  return program::write_whole_file(file, kHead + text, program::Readers::Anyone);
}

}  // namespace telepalp::calibration
