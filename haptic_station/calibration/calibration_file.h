#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "haptic_station/calibration/residuals.h"
#include "messages/calibration.pb.h"
#include "proto/words/frames.h"
#include "proto/words/result.h"

namespace telepalp::calibration {

/// Makes the calibration file's message of one measured transform, target frame from source frame. `date`: time of the
/// measurement, stored as UTC to the second. `rank`: dimensions that the measured points span; 0: the method has none.
[[nodiscard]] msg::MeasuredTransform measured(const Eigen::Isometry3d& to_from_from, const Residuals& residuals,
                                              const std::string& method, std::chrono::system_clock::time_point date,
                                              int rank = 0);

/// The rigid motion of a message. `where`: file and field of the message, for errors. Error: no transform, a number
/// that is not finite, a coordinate of the translation beyond 10 m, or a rotation vector longer than 6.3 rad.
[[nodiscard]] Result<Eigen::Isometry3d> transform_of(const msg::MeasuredTransform& message, const std::string& where);

/// Reads a *.calibration.textproto. Error: a damaged file, reported with line and column, or errors of transform_of().
[[nodiscard]] Result<msg::Calibration> read_calibration(const std::filesystem::path& file);

/// Writes the file atomically: to a temporary file in the same folder, which is then renamed.
[[nodiscard]] Result<void> write_calibration(const std::filesystem::path& file, const msg::Calibration& calibration);

}  // namespace telepalp::calibration
