#include <algorithm>
#include <limits>

#include "haptic_station/tissue/build/local_net.h"
#include "haptic_station/tissue/net/cubic_nodes.h"
#include "haptic_station/tissue/net/stiffness_map.h"

namespace telepalp::tissue {

using Eigen::Vector3d;

StiffnessMap::StiffnessMap(const SurfaceMesh& mesh, const NetSettings& settings) {
  values_.resize(mesh.triangles().size());
  std::uint32_t middle = 0;
  double nearest_m = std::numeric_limits<double>::infinity();
  const BaseNet base(mesh);
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
    const LocalNet net(base, settings, t);
    Vector3d center_m = Vector3d::Zero();
    for (const std::uint32_t corner : mesh.triangles()[t]) center_m += mesh.vertices()[corner] / 3.0;
    if (center_m.norm() < nearest_m) {
      nearest_m = center_m.norm();
      middle = t;
    }
    for (std::size_t n = 0; n < kCubicNodes.size(); ++n) {
      const Vector3d shares(kCubicNodes[n][0] / 3.0, kCubicNodes[n][1] / 3.0, kCubicNodes[n][2] / 3.0);
      values_[t][n] = static_cast<float>(1.0 / net.limit(shares));
    }
  }
  const float whole = values_[middle][9];
  spring_ = 1.0 / whole;
  for (auto& values : values_)
    for (float& value : values) {
      value /= whole;
      range_.least = std::min(range_.least, static_cast<double>(value));
      range_.most = std::max(range_.most, static_cast<double>(value));
    }
  range_ = {std::max(range_.least, kLeast), std::min(range_.most, kMost)};
}

double net_compliance(const SurfaceMesh& mesh, const NetSettings& settings, std::uint32_t triangle,
                      const Vector3d& shares) {
  return LocalNet(BaseNet(mesh), settings, triangle).limit(shares);
}

}  // namespace telepalp::tissue
