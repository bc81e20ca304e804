#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "haptic_station/mechanism/held_linkage.h"

namespace telepalp::study {

/// Where the parts of a linkage are, in the plane z = 0 of the tissue's frame [m].
struct LinkagePlaces {
  Eigen::Vector2d a_m, o_m;  ///< pivots of links 1 and 3
  Eigen::Vector2d b_m, p_m;  ///< joints of links 2 and 3, and of links 1 and 2
  Eigen::Vector2d d_m, c_m;  ///< the handle, from link 3 to its end, which the hand holds
  Eigen::Vector2d tip_m;
};
/// `linkage`: a HeldLinkage or a FeltLinkage.
[[nodiscard]] LinkagePlaces places_of(const auto& linkage) noexcept {
  const mechanism::LinkagePlane& plane = linkage.plane();
  const auto place = [&plane](const mechanism::InPlane<double>& at) -> Eigen::Vector2d {
    return (plane.pivot_a.m + at.x * plane.x.v + at.y * plane.y.v).head<2>();
  };
  const mechanism::FourBarPose<double> pose = linkage.pose();
  return {.a_m = place({0.0, 0.0}),
          .o_m = place({linkage.bar().l4_m, 0.0}),
          .b_m = place(pose.b),
          .p_m = place(pose.p),
          .d_m = place(pose.d),
          .c_m = place(pose.c),
          .tip_m = place(pose.tip)};
}

/// What is drawn of a mechanism, in the plane z = 0 of the tissue's frame [m].
struct MechanismPicture {
  std::optional<LinkagePlaces> four_bar{};  ///< nullopt: another mechanism, drawn by `links`
  std::array<std::array<Eigen::Vector2d, 2>, 8> links{};
  std::size_t count = 0;  ///< of `links`
  Eigen::Vector2d hand_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d needle_m = Eigen::Vector2d::Zero();  ///< where the needle begins
  Eigen::Vector2d tip_m = Eigen::Vector2d::Zero();
};

}  // namespace telepalp::study
