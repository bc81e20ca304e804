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

/// One measured transform as a file tells it. `date`: when it was measured, UTC, to the second.
[[nodiscard]] msg::MeasuredTransform measured(const Eigen::Isometry3d& to_from_from, const Residuals& residuals,
                                              const std::string& method, std::chrono::system_clock::time_point date,
                                              int rank = 0);

/// The message as a rigid motion. Error: a number that is not finite, further than 10 m, or turned by over 2 pi.
[[nodiscard]] Result<Eigen::Isometry3d> transform_of(const msg::MeasuredTransform& message, const std::string& where);

/// Reads a *.calibration.textproto and checks both transforms. A damaged file is an error with line and column.
[[nodiscard]] Result<msg::Calibration> read_calibration(const std::filesystem::path& file);

/// Writes it whole or not at all (by a file beside it, then a rename).
[[nodiscard]] Result<void> write_calibration(const std::filesystem::path& file, const msg::Calibration& calibration);

}  // namespace telepalp::calibration
