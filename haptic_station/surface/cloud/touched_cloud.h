#pragma once

#include "haptic_station/surface/cloud/static_model.h"

namespace telepalp::surface {

/// Makes a touchable surface from a cloud without triangles. `cloud`: points in metres relative to their mean, which is
/// `origin_m` in the file's frame. settings.support_m sets the support; if it is 0, the noise of the points does, and
/// if this support exceeds eight spacings, only a random part of the points is kept. Normals are estimated if the cloud
/// has none, or if its normals differ from the estimate by 20 degrees or more (median). Normals that face the wrong
/// side are reversed when the right side is certain. Error: no usable point; the cloud is too noisy; or it is not
/// closed and its normals contradict each other or its points. `settings.anyway` accepts the last two.
[[nodiscard]] Result<StaticModel> touched_cloud(const models::PointModel& cloud, const StaticModelSettings& settings,
                                                const Eigen::Vector3d& origin_m);

}  // namespace telepalp::surface
