#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "clients/mixed/anchor/headset_anchor.h"

namespace telepalp::mixed {

inline constexpr std::string_view kTouchesHeader =
    "place,known_x_m,known_y_m,known_z_m,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad";
inline constexpr std::string_view kAnchorHeader = "x_m,y_m,z_m,rx_rad,ry_rad,rz_rad,rms_m";

/// Poses of a tracked finger or controller, as the web viewer saves them.
struct AnchorTouches {
  struct AtPlace {
    int place = 0;            ///< number of the place; touches with equal numbers are repeats
    Point<HapticBase> known;  ///< the place on the device
    Eigen::Isometry3d headset_from_tool = Eigen::Isometry3d::Identity();
  };
  std::vector<AtPlace> places;
  /// headset_from_tool while the tool turned about its resting tip; rows of place -1 in the table.
  std::vector<Eigen::Isometry3d> pivot;
};
/// Error, with file and line: as each_row(), or a place is not a whole number from -1 to 1000.
[[nodiscard]] Result<AnchorTouches> read_touches(const std::filesystem::path& file);

/// The text of each table, header first.
[[nodiscard]] std::string touches_table(const AnchorTouches& touches);
[[nodiscard]] std::string anchor_table(const HeadsetAnchor& anchor);

}  // namespace telepalp::mixed
