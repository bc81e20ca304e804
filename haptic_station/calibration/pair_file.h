#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "haptic_station/calibration/point_registration.h"
#include "proto/words/result.h"

namespace telepalp::calibration {

/// Reads point pairs as CSV: a header row `place,to_x_m,to_y_m,to_z_m,from_x_m,from_y_m,from_z_m`, then one row per
/// measurement. Rows with an equal `place`, an integer, are repeated measurements of one point. Numbers have a decimal
/// point in every locale. `name`: the file's name, for errors. Error: the file cannot be read; or, reported with the
/// line, another header, a row that is not an integer and six finite numbers, or over 100 000 rows.
[[nodiscard]] Result<std::vector<PointPair>> read_point_pairs(const std::filesystem::path& file);
[[nodiscard]] Result<std::vector<PointPair>> parse_point_pairs(std::string_view text, std::string_view name);

}  // namespace telepalp::calibration
