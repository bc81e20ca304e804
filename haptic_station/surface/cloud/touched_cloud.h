#pragma once

#include "haptic_station/surface/cloud/static_model.h"

namespace telepalp::surface {

/// Makes a touchable surface from a cloud without triangles, in metres relative to its centre. The support follows the
/// noise of the points, and normals that face the wrong side are reversed when the right side is certain. Error: the
/// cloud is too noisy, or it is not closed and its normals contradict each other or its points; `anyway` accepts both.
[[nodiscard]] Result<StaticModel> touched_cloud(const models::PointModel& cloud, const StaticModelSettings& settings,
                                                const Eigen::Vector3d& origin_m);

}  // namespace telepalp::surface
