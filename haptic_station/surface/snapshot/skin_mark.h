#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

namespace telepalp::surface {

/// Largest number of marks that are followed at once.
inline constexpr std::size_t kMostMarks = 8;

/// Where to find a mark: the skin's crossing with the line through `point` along `up`, in the depth camera's frame.
struct MarkLine {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d up = Eigen::Vector3d::Zero();  ///< unit, out of the body
};
using MarkLines = std::array<std::optional<MarkLine>, kMostMarks>;

/// A mark: one place on the skin that is followed from image to image. The body below is taken to have the same
/// displacement. Depth camera's frame.
struct SkinMark {
  bool watched = false;     ///< false: this entry has no mark
  bool seen = false;        ///< the skin around the mark was measured; false: the last values are held
  bool slide_seen = false;  ///< its slide (tangential motion) can be measured; false: the last one is held
  Eigen::Vector3d at = Eigen::Vector3d::Zero();       ///< position of the mark [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();   ///< normal of the skin there, unit, out of the body
  Eigen::Vector3d moved_m = Eigen::Vector3d::Zero();  ///< displacement since the mark was first seen
  double sigma_normal_m = 0.0;                        ///< 1-sigma of `moved_m` along the normal
  double sigma_slide_m = 0.0;  ///< 1-sigma of `moved_m` along the skin, in the least certain direction
};
using SkinMarks = std::array<SkinMark, kMostMarks>;

}  // namespace telepalp::surface
