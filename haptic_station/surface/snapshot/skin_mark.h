#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

namespace telepalp::surface {

/// Most places on the skin that are watched at once.
inline constexpr std::size_t kMostMarks = 8;

/// Where to find a mark: the skin's crossing with the line through `point` along `up`, in the depth camera's frame.
struct MarkLine {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d up = Eigen::Vector3d::Zero();  ///< unit, out of the body
};
using MarkLines = std::array<std::optional<MarkLine>, kMostMarks>;

/// A mark: one place on the skin, followed from the first images on. Its displacement is that of the body below. Depth
/// camera's frame.
struct SkinMark {
  bool watched = false;
  bool seen = false;        ///< the skin around the mark was measured; false: the last values are held
  bool slide_seen = false;  ///< the skin has enough shape to measure its slide; false: the last slide is held
  Eigen::Vector3d at = Eigen::Vector3d::Zero();       ///< the mark
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();   ///< normal of the skin there, unit, out of the body
  Eigen::Vector3d moved_m = Eigen::Vector3d::Zero();  ///< displacement since the first images
  double sigma_normal_m = 0.0;                        ///< 1-sigma of `moved_m` along the normal
  double sigma_slide_m = 0.0;  ///< 1-sigma of `moved_m` along the skin, in the least certain direction
};
using SkinMarks = std::array<SkinMark, kMostMarks>;

}  // namespace telepalp::surface
