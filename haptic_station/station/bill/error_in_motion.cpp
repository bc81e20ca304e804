#include "haptic_station/station/bill/error_in_motion.h"

#include <algorithm>
#include <iterator>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/core/surface_stage.h"
#include "haptic_station/core/virtual_driver.h"
#include "haptic_station/loop/rig_tick.h"
#include "haptic_station/station/rigs/placement.h"
#include "haptic_station/station/rigs/scene_rig.h"
#include "proto/words/numbers/quantile.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;
using Eigen::Vector3d;

constexpr double kTick_s = 0.0005;
constexpr auto kLate = 40ms;  // from an image's exposure to the first tick that feels its surface
constexpr SessionTime kBegin{100s};
constexpr solids::ProxySettings kFinest{.rounds = 60, .tolerance_m = 1e-10, .remembers = false};

/// 0 without values.
double quantile(std::vector<float>& values, double share) {
  return values.empty() ? 0.0 : double{quantile_of(values, share)};
}

/// Effect `i` of the scene alone, as the last of its effects; friction keeps the skin that it acts on.
std::vector<effects::Recipe> alone(const scenes::Scene& scene, std::size_t i) {
  std::vector<effects::Recipe> one;
  if (std::holds_alternative<effects::FrictionSettings>(scene.effects[i]))
    std::ranges::copy_if(scene.effects, std::back_inserter(one), [](const effects::Recipe& recipe) {
      return std::holds_alternative<effects::SkinSettings>(recipe);
    });
  one.push_back(scene.effects[i]);
  return one;
}

bool may_have_mesh(const effects::Recipe& recipe) {
  return std::holds_alternative<effects::OrganSettings>(recipe) ||
         std::holds_alternative<effects::SolidSettings>(recipe);
}

/// One effect twice: as the station computes it, and as it should be.
struct Twins {
  effects::EffectBank shown;
  effects::EffectBank truth;
  bool compared = true;  // MovingError's
  std::vector<float> errors_N{};

  void begin(const effects::EffectInput& seen, const effects::EffectInput& real) noexcept {
    shown.begin(seen);
    truth.begin(real);
  }
  void step(const effects::EffectInput& seen, const effects::EffectInput& real) {
    const Vector3d is = shown.step(seen, kTick_s).force.N;
    const Vector3d should = truth.step(real, kTick_s).force.N;
    if (is.norm() > 0.0 || should.norm() > 0.0) errors_N.push_back(static_cast<float>((is - should).norm()));
  }
};

/// The truth has meshes that are sampled twice as densely, and exact proxies.
Result<std::vector<Twins>> twins_of(const scenes::Scene& scene, const std::filesystem::path& file) {
  std::vector<Twins> all;
  std::optional<scenes::Scene> finer;
  if (std::ranges::any_of(scene.effects, may_have_mesh)) {
    Result<scenes::Scene> read = scenes::parse_scene(scene.text, file, scenes::MeshDetail::Finer);
    if (!read) return read.error();
    finer = std::move(read).value();
  }
  for (std::size_t i = 0; i < scene.effects.size(); ++i) {
    std::vector<effects::Recipe> truth = alone(scene, i);
    if (may_have_mesh(truth.back())) truth.back() = finer->effects.at(i);
    all.push_back({core::bank_of(alone(scene, i)), core::bank_of(truth), !core::has_slow_stage(truth)});
    all.back().truth.find_proxies_with(kFinest);
  }
  return all;
}

/// Two stations that hold the same device: one sees the body through its camera, the other one knows it.
class Pair {
 public:
  Pair(const scenes::Scene& scene, const SceneParts& parts, const SeenBody& body, std::vector<Twins> twins)
      : body_(body),
        stage_(
            parts.surface,
            [&scene](const DepthImage& depth, const Intrinsics& camera) { return placed(scene, depth, camera); },
            core::bank_of(scene.effects)),
        shown_(loop_of(scene, core::bank_of(scene.effects))),
        truth_(loop_of(scene, core::bank_of(scene.effects))),
        rig_(rig_of(scene, parts.trace)),
        twins_(std::move(twins)) {
    if (!parts.model) return;
    haptic_from_camera_ = parts.model->haptic_from_model;
    model_ = parts.model->snapshot;
  }

  void run(double seconds) {
    const auto ticks = static_cast<int>(seconds / kTick_s);
    for (int i = 0; i < ticks; ++i, now_ += from_seconds(kTick_s)) {
      see();
      if (haptic_from_camera_) tick();
    }
  }
  [[nodiscard]] std::vector<Twins>& twins() noexcept { return twins_; }

 private:
  [[nodiscard]] double time_s() const noexcept { return to_seconds(now_ - kBegin); }

  void see() {
    if (model_) {
      if (seen_++ == 0) adopt(model_, model_);
      return;
    }
    const double exposed_s = static_cast<double>(seen_) / SeenBody::kFrames_per_s;
    const SessionTime captured = kBegin + from_seconds(exposed_s);
    if (captured + kLate > now_) return;
    ++seen_;
    stage_.arrived(
        core::seen_image(body_.depth_at(exposed_s), body_.camera(), captured, static_cast<std::uint64_t>(seen_), now_));
    const auto result = core::run_at_once(stage_, now_, device_);
    if (!result->surface) return;
    haptic_from_camera_ = result->surface->haptic_from_camera;
    adopt(result->surface->snapshot, std::make_shared<TrueBody>(body_, time_s(), now_));
  }

  void adopt(std::shared_ptr<const surface::SurfaceSnapshot> shown,
             std::shared_ptr<const surface::SurfaceSnapshot> truth) {
    before_ = std::move(surfaces_);  // the loops refer to these until they get the new ones
    surfaces_ = {loop::TouchableSurface{std::move(shown), *haptic_from_camera_},
                 loop::TouchableSurface{std::move(truth), *haptic_from_camera_}};
    fresh_ = true;
  }

  /// Where the body really carries the objects now.
  [[nodiscard]] effects::Placements true_places() const noexcept {
    effects::Placements places{};
    const effects::EffectBank& bank = shown_.controller().effects();
    for (std::size_t i = 0; i < bank.size(); ++i)
      if (const auto at = bank.object_at(i); at && !model_) {
        const double y_m = (haptic_from_camera_->inverse() * *at).m.y();
        places[i].moved.v = haptic_from_camera_->iso.linear() * Vector3d(0.0, 0.0, -body_.risen_m(y_m, time_s()));
      }
    return places;
  }

  void tick() {
    const bool fresh = std::exchange(fresh_, false);
    loop::TickOut truth;
    Point<HapticBase> at;
    const loop::TickOut shown = loop::tick_at_rig(
        shown_, *rig_, {.now = now_, .dt_s = kTick_s, .surface = fresh ? &surfaces_[0] : nullptr},
        [](const loop::TickIn&) {},
        [&](loop::TickIn in, const loop::TickOut&) {
          at = shown_.in_patient_frame(in.reading.at);
          if (fresh) in.surface = &surfaces_[1];
          truth = truth_.tick(in);
        });
    const Vector<HapticBase> moved{at.m - device_.m};
    device_ = at;
    feel({.device = at, .device_velocity = {moved.v / kTick_s}, .contact = shown.contact, .moved = moved},
         {.device = at, .device_velocity = {moved.v / kTick_s}, .contact = truth.contact, .moved = moved});
  }

  void feel(const effects::EffectInput& seen, const effects::EffectInput& real) {
    const bool in_body = seen.contact.in_body || real.contact.in_body;
    const bool enters = in_body && !std::exchange(in_body_, in_body);
    if (!in_body) return;
    const effects::Placements true_places = this->true_places();
    const loop::ObjectPlacements objects = shown_.objects();
    for (std::size_t i = 0; i < twins_.size(); ++i) {
      const std::array<float, 3>& moved = objects[i].moved;
      effects::Placements shown_at{};
      effects::Placements truth_at{};
      shown_at[0].moved.v = Vector3d(moved[0], moved[1], moved[2]);
      truth_at[0] = true_places[i];
      twins_[i].shown.place(shown_at);
      twins_[i].truth.place(truth_at);
      if (enters) twins_[i].begin(seen, real);
      twins_[i].step(seen, real);
    }
  }

  const SeenBody& body_;
  core::SurfaceStage stage_;
  loop::HapticLoop shown_;
  loop::HapticLoop truth_;
  std::unique_ptr<ports::Rig> rig_;
  std::vector<Twins> twins_;
  std::optional<Transform<HapticBase, DepthCamera>> haptic_from_camera_;
  std::shared_ptr<const surface::SurfaceSnapshot> model_;  // nullptr: the body is seen
  std::array<loop::TouchableSurface, 2> surfaces_;         // as shown, and the truth
  std::array<loop::TouchableSurface, 2> before_;
  bool fresh_ = false;
  Point<HapticBase> device_;
  SessionTime now_ = kBegin;
  int seen_ = 0;
  bool in_body_ = false;
};

}  // namespace

Result<std::vector<MovingError>> errors_in_motion(const scenes::Scene& scene, const SceneParts& parts,
                                                  const std::filesystem::path& file, const SeenBody& body,
                                                  double seconds) {
  Result<std::vector<Twins>> twins = twins_of(scene, file);
  if (!twins) return twins.error();
  Pair pair(scene, parts, body, std::move(twins).value());
  pair.run(seconds);
  std::vector<MovingError> errors;
  for (Twins& one : pair.twins())
    errors.push_back({.ticks = one.errors_N.size(),
                      .compared = one.compared,
                      .p50_N = quantile(one.errors_N, 0.5),
                      .p99_N = quantile(one.errors_N, 0.99),
                      .stiffness_N_per_m = one.shown.stiffest_N_per_m(scene.control.limits.peak_N)});
  return errors;
}

}  // namespace telepalp::station
