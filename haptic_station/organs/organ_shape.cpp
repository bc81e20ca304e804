#include "haptic_station/organs/organ_shape.h"

#include <utility>

namespace telepalp::organs {
namespace {

constexpr std::uintmax_t kMostMeshBytes = std::uintmax_t{64} << 20;  // sampling a larger mesh takes minutes

}  // namespace

Result<std::shared_ptr<const solids::DistanceLattice>> read_organ_shape(const std::filesystem::path& file,
                                                                        const OrganShapeSettings& settings) {
  std::error_code code;
  if (const std::uintmax_t size = std::filesystem::file_size(file, code); !code && size > kMostMeshBytes)
    return Error{.what = "is larger than 64 MiB", .where = file.string(), .fix = "simplify the mesh"};
  Result<models::PointModel> model = models::read_point_model(file);
  if (!model) return model.error();
  for (Eigen::Vector3f& point : model->points)
    point = (settings.haptic_from_model * (settings.unit_m * point.cast<double>())).cast<float>();
  Result<solids::DistanceLattice> lattice = signed_distance(*model, settings.cell_m, settings.margin_m);
  if (!lattice) {
    Error error = lattice.error();
    error.where = file.string();
    return error;
  }
  return std::make_shared<const solids::DistanceLattice>(*std::move(lattice));
}

}  // namespace telepalp::organs
