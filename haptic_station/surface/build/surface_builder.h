#pragma once

#include <memory>
#include <optional>

#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// What the builder did since it was made.
struct BuilderCounts {
  std::uint64_t built = 0;
  std::uint64_t not_newer = 0;  ///< duplicates and frames out of order, dropped
  std::uint64_t malformed = 0;  ///< images or cameras that are not well formed, dropped
};

/// Makes touchable snapshots of a stream of depth images and keeps what passes from frame to frame: the average of what
/// is still, the motion of what is not. Owner: the surface thread.
class SurfaceBuilder {
 public:
  explicit SurfaceBuilder(SurfaceSettings settings);
  ~SurfaceBuilder();
  SurfaceBuilder(SurfaceBuilder&&) noexcept;
  SurfaceBuilder& operator=(SurfaceBuilder&&) noexcept;

  /// The surface as of `captured`. `reach`: what the hand can reach before the next frame; none: everything. nullptr
  /// when the frame is not newer than the last or not well formed; it is then counted and nothing changes.
  /// A shared_ptr because the 2 kHz thread reads what this thread made and must not be the one to free it.
  [[nodiscard]] std::shared_ptr<const SurfaceSnapshot> add(const DepthImage& depth, const Intrinsics& camera,
                                                           SessionTime captured, const std::optional<Reach>& reach);

  [[nodiscard]] const BuilderCounts& counts() const noexcept;
  [[nodiscard]] const SurfaceSettings& settings() const noexcept;

  /// The next snapshot is made by `settings`; what was seen stays.
  void use(const SurfaceSettings& settings);

  /// Forgets everything seen: another camera, or the same one moved.
  void restart();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// One frame alone, without memory.
[[nodiscard]] std::shared_ptr<const SurfaceSnapshot> build_snapshot(const DepthImage& depth, const Intrinsics& camera,
                                                                    SessionTime captured,
                                                                    const std::optional<Reach>& reach,
                                                                    const SurfaceSettings& settings);

}  // namespace telepalp::surface
