#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace telepalp::mixed {

/// A revolute joint of a chain. Its frame turns about `axis` by the joint's angle, after `parent_from_joint`.
struct Joint {
  Eigen::Isometry3d parent_from_joint = Eigen::Isometry3d::Identity();  ///< at angle 0
  Eigen::Vector3d axis = Eigen::Vector3d::UnitX();                      ///< unit, in the joint's frame
  double least_rad = 0.0;
  double most_rad = 0.0;
};

/// The box around one link, fixed to the frame after `frame` joints (0: the base).
struct Prism {
  std::size_t frame = 0;
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d half_m = Eigen::Vector3d::Zero();  ///< half of its sides
};

/// A truncated cone around the handle, fixed to the last frame.
struct Cone {
  Eigen::Vector3d from_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d to_m = Eigen::Vector3d::Zero();
  double from_radius_m = 0.0;
  double to_radius_m = 0.0;
};

/// A haptic device as a chain of joints with approximate bodies. Source: paper S3 (docs/sources.md) 5.1.
struct DeviceModel {
  std::vector<Joint> joints;
  std::vector<Prism> prisms;
  Cone handle;
  Eigen::Vector3d tip_m = Eigen::Vector3d::Zero();  ///< the handle's tip, in the last frame
  std::size_t gimbal = 0;                           ///< the first joint of the gimbal, whose encoders are less exact
};

/// The PHANToM Omni in the haptic base's frame (y up, z to the user). Lengths and limits of the joints are those that
/// its public robot description gives; the widths of the links are our own measure of its pictures.
[[nodiscard]] DeviceModel omni();

/// The middle of the Omni's workspace in the base's frame [m].
inline const Eigen::Vector3d kOmniWorkspace_m(0.0, 0.12, 0.14);

/// The frames of the chain in the base's frame: the base itself, then one for each joint. `joints_rad`: one for each
/// joint of the model.
[[nodiscard]] std::vector<Eigen::Isometry3d> base_from_frames(const DeviceModel& model,
                                                              std::span<const double> joints_rad);

/// The tip of the handle in the base's frame [m].
[[nodiscard]] Eigen::Vector3d tip_of(const DeviceModel& model, std::span<const double> joints_rad);

}  // namespace telepalp::mixed
