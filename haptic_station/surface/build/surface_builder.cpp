#include "haptic_station/surface/build/surface_builder.h"

#include <cmath>

#include "haptic_station/surface/build/hidden_skin.h"
#include "haptic_station/surface/build/mark_tracker.h"
#include "haptic_station/surface/cloud/cloud_snapshot.h"
#include "haptic_station/surface/depth/sample_depths.h"
#include "haptic_station/surface/grid/grid_snapshot.h"
#include "haptic_station/surface/paper/paper_surface.h"
#include "haptic_station/surface/temporal/temporal_filter.h"

namespace telepalp::surface {
namespace {

/// The points in reach, with normals from their sixteen nearest neighbours.
std::vector<CloudPoint> points_in_reach(const DepthField& depth, const Intrinsics& camera,
                                        const std::optional<Reach>& reach) {
  const PixelBox box = box_in_reach(camera, reach, 8);
  std::vector<Eigen::Vector3f> points;
  const IndexedPoints all = to_points(depth, camera);
  for (int row = box.top; row < box.bottom; ++row)
    for (int column = box.left; column < box.right; ++column) points.push_back(all.at_m[depth.index(column, row)]);
  return with_normals(points, 16, Eigen::Vector3f::Zero());
}

/// Makes a snapshot of one depth field by any method. `label` sets the members that all methods share.
template <class Label>
std::shared_ptr<const SurfaceSnapshot> make_snapshot(const DepthField& depth, const Intrinsics& camera,
                                                     const std::optional<Reach>& reach, const SurfaceSettings& settings,
                                                     const MotionField* motion, const Hidden& hidden,
                                                     const Label& label) {
  if (settings.method == Method::Paper) {
    auto snapshot = std::make_shared<PaperSurface>(to_points(depth, camera), settings);
    label(*snapshot);
    return snapshot;
  }
  if (settings.method == Method::Cloud) {
    CloudShape shape;
    shape.support_m = settings.radius_m;
    if (settings.support == Support::KthNeighbor) shape.neighbors = static_cast<std::size_t>(settings.neighbors);
    auto snapshot = std::make_shared<CloudSnapshot>(points_in_reach(depth, camera, reach), shape, settings.index);
    snapshot->motion.ages = true;
    label(*snapshot);
    return snapshot;
  }
  auto snapshot = std::make_shared<GridSnapshot>(depth, camera, reach, settings);
  if (motion != nullptr && settings.predict) snapshot->carry_forward(*motion);
  if (hidden.fades) snapshot->fade(hidden.lattice, hidden.shown);
  label(*snapshot);
  return snapshot;
}

constexpr double kForgetAfter_s = 2.0;  // average and motion are discarded after this time without a frame

}  // namespace

struct SurfaceBuilder::State {
  SurfaceSettings settings;
  BuilderCounts counts;
  std::optional<SessionTime> last;
  std::uint64_t sequence = 0;
  SampleDepths samples;
  DepthField field;  // of the newest frame; a member, because a new one costs as much as the frame's conversion
  std::optional<TemporalFilter> filter;
  HiddenSkin skin;
  MarkTracker marks;
  Intrinsics camera;  // camera of the last frame
};

SurfaceBuilder::SurfaceBuilder(SurfaceSettings settings) : state_(std::make_unique<State>()) {
  state_->settings = std::move(settings);
}
SurfaceBuilder::~SurfaceBuilder() = default;
SurfaceBuilder::SurfaceBuilder(SurfaceBuilder&&) noexcept = default;
SurfaceBuilder& SurfaceBuilder::operator=(SurfaceBuilder&&) noexcept = default;

const BuilderCounts& SurfaceBuilder::counts() const noexcept { return state_->counts; }
const SurfaceSettings& SurfaceBuilder::settings() const noexcept { return state_->settings; }

void SurfaceBuilder::use(const SurfaceSettings& settings) { state_->settings = settings; }

void SurfaceBuilder::watch(const MarkLines& lines) { state_->marks.watch(lines); }

void SurfaceBuilder::restart() {
  state_->marks.restart();
  state_->last.reset();
  state_->samples = {};
  state_->filter.reset();
  state_->skin.restart();
}

bool SurfaceBuilder::object_over_place() const noexcept { return state_->skin.hidden().over_place; }

void SurfaceBuilder::accept_object() noexcept { state_->skin.accept_object(); }

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
  const double dt_s = state.last ? to_seconds(captured - *state.last) : 0.0;
  state.last = captured;
  ++state.counts.built;
  DepthField& field = state.field;
  if (state.settings.disparity_levels)
    state.samples.field_of(depth, field);
  else
    to_depth_field(depth, field);
  fill_pinholes(field, state.settings.break_m);
  const bool begins_again = dt_s > kForgetAfter_s || camera != state.camera;
  if (begins_again) state.skin.restart();
  const Hidden& hidden =
      state.skin.add(field, camera, dt_s, reach ? std::optional<Point<DepthCamera>>(reach->centre) : std::nullopt);
  hidden.blank(field);
  if (state.settings.temporal && (!state.filter || begins_again || hidden.camera_moved))
    state.filter.emplace(camera.width, camera.height, state.settings);
  state.camera = camera;
  const std::span<const std::uint8_t> covered =
      hidden.any ? std::span<const std::uint8_t>(hidden.block) : std::span<const std::uint8_t>();
  const DepthField& shown = state.filter ? state.filter->add(field, dt_s, covered) : field;
  state.marks.add(shown, field, camera, dt_s);
  const MotionField* motion = state.filter ? &state.filter->motion() : nullptr;
  return make_snapshot(shown, camera, reach, state.settings, motion, hidden, [&](SurfaceSnapshot& snapshot) {
    snapshot.captured = captured;
    snapshot.sequence = ++state.sequence;
    snapshot.marks = state.marks.marks();
  });
}

std::shared_ptr<const SurfaceSnapshot> build_snapshot(const DepthImage& depth, const Intrinsics& camera,
                                                      SessionTime captured, const std::optional<Reach>& reach,
                                                      const SurfaceSettings& settings) {
  return SurfaceBuilder(settings).add(depth, camera, captured, reach);
}

}  // namespace telepalp::surface
