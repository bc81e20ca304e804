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
    int place = 0;
    Point<HapticBase> known;
    Eigen::Isometry3d headset_from_tool = Eigen::Isometry3d::Identity();
  };
  std::vector<AtPlace> places;
  std::vector<Eigen::Isometry3d> pivot;  ///< with the tip at rest, while the tool turned: rows of place -1
};
/// Error, with file and line: as each_row(), or a place that is no whole number from -1 to 1000.
[[nodiscard]] Result<AnchorTouches> read_touches(const std::filesystem::path& file);

[[nodiscard]] std::string touches_table(const AnchorTouches& touches);
[[nodiscard]] std::string anchor_table(const HeadsetAnchor& anchor);

}  // namespace telepalp::mixed
