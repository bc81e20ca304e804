#include "haptic_station/solids/text/rigid_matrix.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace telepalp::solids {

Result<Solid> placement_of(const std::array<double, 12>& matrix, const std::string& where) {
  const Eigen::Matrix<double, 3, 4> rows =
      Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(matrix.data());
  const Eigen::Matrix3d linear = rows.leftCols<3>();
  const double scale = std::cbrt(linear.determinant());
  const double skew = (linear.transpose() * linear - scale * scale * Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(scale > 0.0 && skew <= 1e-6 * scale * scale))
    return Error{
        .what = "the matrix of tm shears, mirrors, or scales its axes differently",
        .where = where,
        .fix = "give a rotation times one scale factor, which keeps distances in proportion; or use tr, ro and sc"};
  const Eigen::AngleAxisd turn(Eigen::Quaterniond(Eigen::Matrix3d(linear / scale)).normalized());
  Node move{.word = *find_word("tx")};
  move.numbers = {matrix[3],       matrix[7],       matrix[11],     turn.angle() * 180.0 / std::numbers::pi,
                  turn.axis().x(), turn.axis().y(), turn.axis().z()};
  Node sized{.word = *find_word("sc")};
  sized.numbers[0] = scale;
  return Solid{move, sized};
}

}  // namespace telepalp::solids
