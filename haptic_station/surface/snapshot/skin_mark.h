#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <optional>

namespace telepalp::surface {

/// Largest number of marks that are followed at once.
inline constexpr std::size_t kMostMarks = 8;

/// Where to find a mark: the skin's crossing with the line through `point` [m] along `up`, in the depth camera's frame.
struct MarkLine {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector3d up = Eigen::Vector3d::Zero();  ///< unit, out of the body
};
using MarkLines = std::array<std::optional<MarkLine>, kMostMarks>;

/// A mark: one place on the skin that is followed from image to image. The body below the mark is taken to have the
/// mark's displacement. All vectors are in the depth camera's frame.
struct SkinMark {
  bool watched = false;     ///< false: this entry of SkinMarks has no mark
  bool seen = false;        ///< this image shows the skin around the mark; false: position and displacement are held
  bool slide_seen = false;  ///< this image shows the mark's slide (tangential motion); false: the last slide is held
  Eigen::Vector3d at = Eigen::Vector3d::Zero();       ///< position of the mark [m]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();   ///< skin's normal at the mark when first seen, unit, outwards
  Eigen::Vector3d moved_m = Eigen::Vector3d::Zero();  ///< displacement since the mark was first seen
  double sigma_normal_m = 0.0;                        ///< 1-sigma of `moved_m` along the normal
  double sigma_slide_m = 0.0;  ///< 1-sigma of `moved_m` along the skin, in the least certain direction
};
using SkinMarks = std::array<SkinMark, kMostMarks>;

}  // namespace telepalp::surface
