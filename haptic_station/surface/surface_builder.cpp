#include "haptic_station/surface/surface_builder.h"

#include "haptic_station/surface/grid_snapshot.h"

namespace telepalp::surface {

struct SurfaceBuilder::State {
  SurfaceSettings settings;
  BuilderCounts counts;
  std::optional<SessionTime> last;
  std::uint64_t sequence = 0;
};

SurfaceBuilder::SurfaceBuilder(SurfaceSettings settings) : state_(std::make_unique<State>()) {
  state_->settings = std::move(settings);
}
SurfaceBuilder::~SurfaceBuilder() = default;
SurfaceBuilder::SurfaceBuilder(SurfaceBuilder&&) noexcept = default;
SurfaceBuilder& SurfaceBuilder::operator=(SurfaceBuilder&&) noexcept = default;

const BuilderCounts& SurfaceBuilder::counts() const noexcept { return state_->counts; }
const SurfaceSettings& SurfaceBuilder::settings() const noexcept { return state_->settings; }

void SurfaceBuilder::restart() { state_->last.reset(); }

std::shared_ptr<const SurfaceSnapshot> SurfaceBuilder::add(const DepthImage& depth, const Intrinsics& camera,
                                                           SessionTime captured, const std::optional<Reach>& reach) {
  State& state = *state_;
  if (!is_well_formed(depth) || !is_well_formed(camera) || camera.width != depth.width ||
      camera.height != depth.height) {
    ++state.counts.malformed;
    return nullptr;
  }
  if (state.last && captured <= *state.last) {
    ++state.counts.not_newer;
    return nullptr;
  }
  state.last = captured;
  ++state.counts.built;
  auto snapshot = std::make_shared<GridSnapshot>(to_depth_field(depth), camera, reach, state.settings);
  snapshot->captured = captured;
  snapshot->sequence = ++state.sequence;
  return snapshot;
}

std::shared_ptr<const SurfaceSnapshot> build_snapshot(const DepthImage& depth, const Intrinsics& camera,
                                                      SessionTime captured, const std::optional<Reach>& reach,
                                                      const SurfaceSettings& settings) {
  return SurfaceBuilder(settings).add(depth, camera, captured, reach);
}

}  // namespace telepalp::surface
