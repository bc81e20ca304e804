#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "haptic_station/calibration/hand_on_probe.h"
#include "proto/words/result.h"

namespace telepalp::calibration {

/// Reads poses of a hand on a probe as CSV: the header row kPoseHeader, then one pose per row. The hand's pose is in
/// the tracker's frame, the probe's in the haptic base's. Rotations are rotation vectors. `name`: the file's name, for
/// errors. Error: unreadable file; or, with the line, another header, not 12 finite numbers, or over 10 000 rows.
[[nodiscard]] Result<std::vector<HandOnProbe>> read_hand_on_probe(const std::filesystem::path& file);
[[nodiscard]] Result<std::vector<HandOnProbe>> parse_hand_on_probe(std::string_view text, std::string_view name);

inline constexpr std::string_view kPoseHeader =
    "hand_x_m,hand_y_m,hand_z_m,hand_rx_rad,hand_ry_rad,hand_rz_rad,"
    "probe_x_m,probe_y_m,probe_z_m,probe_rx_rad,probe_ry_rad,probe_rz_rad";

/// Parses a pose `x,y,z,rx,ry,rz`: a translation in metres and a rotation vector in radians; nullopt when the text is
/// not six finite numbers.
[[nodiscard]] std::optional<Eigen::Isometry3d> parse_pose(std::string_view text);

}  // namespace telepalp::calibration
