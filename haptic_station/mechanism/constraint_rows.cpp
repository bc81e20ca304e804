#include "haptic_station/mechanism/constraint_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace telepalp::mechanism {
namespace {

using PointMotion = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, kMostCoordinates>;

Eigen::Vector2d turned(const Eigen::Vector2d& v, double rad) noexcept {
  const double c = std::cos(rad);
  const double s = std::sin(rad);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}
Eigen::Vector2d left_of(const Eigen::Vector2d& v) noexcept { return {-v.y(), v.x()}; }
double angle_of(int body, const PlanarPose& pose) noexcept { return body == 0 ? 0.0 : pose[3 * body - 1]; }

void add_slot(const Slot& slot, const PlanarPose& pose, JointEquations& out, int row) noexcept {
  const double line_rad = slot.line_rad + angle_of(slot.line.body, pose);
  const Eigen::Vector2d across(-std::sin(line_rad), std::cos(line_rad));
  const Eigen::Vector2d from_line = place_of(slot.point, pose) - place_of(slot.line, pose);
  out.errors[row] = across.dot(from_line);
  out.rows.row(row) = across.transpose().lazyProduct(motion_of(slot.point, pose) - motion_of(slot.line, pose));
  if (slot.line.body > 0) out.rows(row, 3 * slot.line.body - 1) += left_of(across).dot(from_line);
}

/// Gauss-Jordan elimination in place; `column_at` follows the exchanged columns. Returns the rank.
int eliminate(JointEquations& at, std::array<int, kMostCoordinates>& column_at) noexcept {
  const auto rows = static_cast<int>(at.rows.rows());
  const auto columns = static_cast<int>(at.rows.cols());
  double largest = 0.0;
  for (int rank = 0; rank < std::min(rows, columns); ++rank) {
    Eigen::Index i = 0;
    Eigen::Index j = 0;
    const double pivot = at.rows.block(rank, rank, rows - rank, columns - rank).cwiseAbs().maxCoeff(&i, &j);
    largest = std::max(largest, pivot);
    if (!(pivot > 1e-9 * largest)) return rank;
    at.rows.row(rank).swap(at.rows.row(rank + i));
    std::swap(at.errors[rank], at.errors[rank + i]);
    at.rows.col(rank).swap(at.rows.col(rank + j));
    std::swap(column_at[static_cast<std::size_t>(rank)], column_at[static_cast<std::size_t>(rank + j)]);
    const double scale = 1.0 / at.rows(rank, rank);
    at.rows.row(rank) *= scale;
    at.errors[rank] *= scale;
    for (int other = 0; other < rows; ++other) {
      const double share = other == rank ? 0.0 : at.rows(other, rank);
      if (share == 0.0) continue;
      for (int k = rank; k < columns; ++k) at.rows(other, k) -= share * at.rows(rank, k);
      at.errors[other] -= share * at.errors[rank];
    }
  }
  return std::min(rows, columns);
}

}  // namespace

Eigen::Vector2d place_of(const BodyPoint& point, const PlanarPose& pose) noexcept {
  if (point.body == 0) return point.at_m;
  return pose.segment<2>(3 * (point.body - 1)) + turned(point.at_m, angle_of(point.body, pose));
}

PointMotion motion_of(const BodyPoint& point, const PlanarPose& pose) noexcept {
  PointMotion motion = PointMotion::Zero(2, pose.size());
  if (point.body == 0) return motion;
  const int first = 3 * (point.body - 1);
  motion(0, first) = 1.0;
  motion(1, first + 1) = 1.0;
  motion.col(first + 2) = left_of(turned(point.at_m, angle_of(point.body, pose)));
  return motion;
}

JointEquations joint_equations(const PlanarMechanism& mechanism, const PlanarPose& pose) noexcept {
  const int count = 2 * mechanism.pins.size() + mechanism.slots.size();
  JointEquations out{PlanarErrors::Zero(count), PlanarRows::Zero(count, pose.size())};
  int row = 0;
  for (const Pin& pin : mechanism.pins) {
    out.errors.segment<2>(row) = place_of(pin.one, pose) - place_of(pin.other, pose);
    out.rows.middleRows<2>(row) = motion_of(pin.one, pose) - motion_of(pin.other, pose);
    row += 2;
  }
  for (const Slot& slot : mechanism.slots) add_slot(slot, pose, out, row++);
  return out;
}

Solutions solutions_of(const JointEquations& equations) noexcept {
  JointEquations at = equations;
  const auto columns = static_cast<int>(at.rows.cols());
  std::array<int, kMostCoordinates> column_at{};
  for (int i = 0; i < columns; ++i) column_at[static_cast<std::size_t>(i)] = i;
  const int rank = eliminate(at, column_at);
  Solutions out{PlanarPose::Zero(columns), {}};
  out.free.setZero(columns, columns - rank);
  for (int i = 0; i < columns; ++i) {
    const int coordinate = column_at[static_cast<std::size_t>(i)];
    if (i < rank) {
      out.one[coordinate] = -at.errors[i];
      for (int k = rank; k < columns; ++k) out.free(coordinate, k - rank) = -at.rows(i, k);
    } else {
      out.free(coordinate, i - rank) = 1.0;
    }
  }
  return out;
}

}  // namespace telepalp::mechanism
