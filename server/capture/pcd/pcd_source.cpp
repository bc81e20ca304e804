#include <filesystem>
#include <utility>

#include "server/capture/pacing/sequence_source.h"
#include "server/capture/pcd/pinhole_fit.h"
#include "server/capture/sources.h"

namespace telepalp::capture {

Result<std::unique_ptr<CaptureSource>> open_pcd(const std::string& file, const SourceOptions& options) {
  const Result<models::PointModel> cloud = models::read_point_model(file);
  if (!cloud) return cloud.error();
  Result<RgbdFrame> frame = frame_of(*cloud, file);
  if (!frame) return frame.error();
  const Intrinsics& camera = frame->camera.depth;
  std::string description = "a still point cloud, " + std::filesystem::path(file).filename().string() + ", " +
                            std::to_string(camera.width) + "x" + std::to_string(camera.height) + ", focal length " +
                            std::to_string(static_cast<int>(camera.fx + 0.5)) + " px (fitted)";
  return play({.count = 1,
               .period = Nanoseconds{33'333'333},
               .load = [still = std::move(*frame)](std::size_t) -> Result<RgbdFrame> { return still; },
               .description = std::move(description)},
              options);
}

}  // namespace telepalp::capture
