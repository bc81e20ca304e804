#include "support/isosurface/cells/planes.h"

#include <Eigen/Eigenvalues>

namespace telepalp::isosurface {
namespace {
constexpr double kLeastShare = 0.03;  // of the greatest eigenvalue; below it, the planes do not hold a direction
}

Meeting meeting_of(std::span<const Plane> planes, int most_rank) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Plane& plane : planes) mean += plane.at;
  mean /= static_cast<double>(planes.size());
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Plane& plane : planes) {
    products += plane.normal * plane.normal.transpose();
    right += plane.normal * plane.normal.dot(plane.at - mean);
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(products);  // in increasing order
  Meeting meeting{.at = mean, .rank = 0, .worst_m = 0.0};
  for (int i = 2; i >= 0 && meeting.rank < most_rank; --i) {
    if (!(solver.eigenvalues()[i] > kLeastShare * solver.eigenvalues()[2])) break;
    const Eigen::Vector3d direction = solver.eigenvectors().col(i);
    meeting.at += direction * (direction.dot(right) / solver.eigenvalues()[i]);
    ++meeting.rank;
  }
  for (const Plane& plane : planes)
    meeting.worst_m = std::max(meeting.worst_m, std::abs(plane.normal.dot(meeting.at - plane.at)));
  return meeting;
}

}  // namespace telepalp::isosurface
