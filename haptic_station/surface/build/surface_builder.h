#pragma once

#include <memory>
#include <optional>

#include "haptic_station/surface/depth/depth_field.h"
#include "haptic_station/surface/snapshot/surface_settings.h"
#include "haptic_station/surface/snapshot/surface_snapshot.h"

namespace telepalp::surface {

/// Radius of the ball around the hand in which the station builds the surface: a hand at 2 m/s moves 0.13 m in two
/// frame times; the rest is the support of the implicit function.
inline constexpr double kReach_m = 0.16;

/// Numbers of frames that the builder used or dropped.
struct BuilderCounts {
  std::uint64_t built = 0;
  std::uint64_t not_newer = 0;  ///< duplicates and frames out of order, dropped
  std::uint64_t malformed = 0;  ///< invalid images or camera models, or different sizes of the two; dropped
};

/// Makes surface snapshots, which a hand can touch, from a stream of depth images. Between frames it keeps the temporal
/// average of static skin and the estimated motion of moving skin. Owner: surface thread.
class SurfaceBuilder {
 public:
  explicit SurfaceBuilder(SurfaceSettings settings);
  ~SurfaceBuilder();
  SurfaceBuilder(SurfaceBuilder&&) noexcept;
  SurfaceBuilder& operator=(SurfaceBuilder&&) noexcept;

  /// Makes the surface at the time `captured`. `reach`: the sphere that the hand can reach before the next frame,
  /// beyond which the surface may be missing; nullopt: the whole image. Returns nullptr when the frame is not newer
  /// than the last one or is malformed (see BuilderCounts). Returns a shared_ptr because the 2 kHz thread reads the
  /// snapshot and must not free it.
  [[nodiscard]] std::shared_ptr<const SurfaceSnapshot> add(const DepthImage& depth, const Intrinsics& camera,
                                                           SessionTime captured, const std::optional<Reach>& reach);

  [[nodiscard]] const BuilderCounts& counts() const noexcept;
  [[nodiscard]] const SurfaceSettings& settings() const noexcept;

  /// Uses `settings` from the next snapshot on. Keeps the temporal average and the estimated motion.
  void use(const SurfaceSettings& settings);

  /// Follows the places where these lines cross the skin, from the next frame on; SurfaceSnapshot::marks gives them.
  void watch(const MarkLines& lines);

  /// Discards the temporal average, the estimated motion, the patches of the marks, the remembered skin (HiddenSkin)
  /// and the last capture time. Call it when the camera is replaced or moved, or when session time has stepped back.
  void restart();

  /// True if an object lay over the centre of the reach in the last image. With the temporal average, the surface there
  /// is the remembered skin, which fades (HiddenSkin); without it, there is none.
  [[nodiscard]] bool object_over_place() const noexcept;

  /// Makes the object over the centre of the reach skin as soon as that centre is above it (HiddenSkin).
  void accept_object() noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Makes a snapshot from one frame, without temporal average or motion.
[[nodiscard]] std::shared_ptr<const SurfaceSnapshot> build_snapshot(const DepthImage& depth, const Intrinsics& camera,
                                                                    SessionTime captured,
                                                                    const std::optional<Reach>& reach,
                                                                    const SurfaceSettings& settings);

}  // namespace telepalp::surface
