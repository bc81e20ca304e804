#include "haptic_station/station/bill/billed_station.h"

#include <algorithm>
#include <numeric>

#include "haptic_station/station/bill/thread_time.h"
#include "haptic_station/station/rigs/inner_layers.h"
#include "haptic_station/station/rigs/placement.h"
#include "haptic_station/station/rigs/scene_rig.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;

constexpr auto kArrives = 20ms;  // from an image's exposure to its arrival at the station
constexpr auto kServed = 10ms;   // period of the network thread's work
constexpr auto kTotals = 1s;     // period of /station/stats
constexpr std::size_t kFirstImages = 1;

double us_since(std::int64_t before) noexcept {
  return 1e-3 * static_cast<double>(std::max<std::int64_t>(0, thread_ns() - before - thread_clock_ns()));
}

}  // namespace

void StationCost::add(Part part, double us) noexcept {
  const auto at = static_cast<std::size_t>(part);
  spent_us[at] += us;
  steps[at].add(static_cast<std::uint64_t>(1e3 * us));
}

double StationCost::share(Part part) const noexcept {
  return seconds > 0.0 ? 1e-4 * spent_us[static_cast<std::size_t>(part)] / seconds : 0.0;
}

double StationCost::share() const noexcept {
  return seconds > 0.0 ? 1e-4 * std::accumulate(spent_us.begin(), spent_us.end(), 0.0) / seconds : 0.0;
}

BilledStation::BilledStation(const scenes::Scene& scene, const SceneParts& parts, const BodyStream& stream)
    : scene_(scene),
      stream_(stream),
      effects_(core::build_effects(scene.effects)),
      effect_drivers_(effects_.stages.size()),
      loop_(loop_of(scene, effects_.bank)),
      rig_(rig_of(scene, parts.trace)),
      haptic_(loop_, *rig_, surfaces_, *ticks_, device_to_surface_),
      telemetry_(
          *ticks_, [this](const wire::Message& message) { publish(message); }, [](const loop::TickSample&) {}) {
  telemetry_.outbox().facts().clock_error_s = 0.0;
  if (parts.model) {
    haptic_from_camera_ = parts.model->haptic_from_model;
    surfaces_.put({parts.model->snapshot, parts.model->haptic_from_model});
  } else {
    start_surface_stage(parts);
  }
  start_inside_stages();
  if (!effects_.stages.empty()) haptic_.tell(tool_);
}

void BilledStation::start_surface_stage(const SceneParts& parts) {
  if (!surface::runs_in_tick(parts.surface)) collision_.emplace();
  const auto placement = [this](const DepthImage& depth, const Intrinsics& camera) {
    return haptic_from_camera_ = placed(scene_, depth, camera);
  };
  surface_stage_.emplace(parts.surface, placement, effects_.bank);
}

void BilledStation::start_inside_stages() {
  if (const auto settings = image_settings(scene_)) ultrasound_.emplace(inner_layers(scene_), *settings);
  core::InnerSurfacesStage surfaces(inner_layers(scene_));
  core::VirtualDriver<core::InnerSurfacesStage> driver;
  double spent_us = 0.0;
  if (auto made = run_stage(driver, surfaces, spent_us)) surfaces.hand_over(std::move(*made), now_);
  start_ms_ = 1e-3 * spent_us;
  if (scene_.layers().empty() && !scene_.probe) return;
  publish(core::Outbox::inside(*surfaces.placed(now_, scene_.haptic_from_camera), now_));
}

/// Runs a stage now, adds its processor time to `spent_us`, and returns its result at once. The stage is told its
/// processor time, by which it may choose a cheaper setting.
template <class Stage, class... Inputs>
std::optional<typename Stage::Result> BilledStation::run_stage(core::VirtualDriver<Stage>& driver, Stage& stage,
                                                               double& spent_us, Inputs&&... inputs) {
  const std::int64_t before = thread_ns();
  driver.begin(
      now_, stage, [before](core::StageStep) { return Nanoseconds{thread_ns() - before}; },
      std::forward<Inputs>(inputs)...);
  spent_us += us_since(before);
  return driver.finished(SessionTime::max());
}

void BilledStation::publish(const wire::Message& message) {
  Published& topic = published_[std::string(message.topic.name)];
  ++topic.messages;
  topic.bytes += message.payload->size();
}

void BilledStation::see(StationCost& cost) {
  const std::int64_t before = thread_ns();
  telemetry_.outbox().frame_received();
  const wire::Message& image = stream_.images[next_image_++];
  if (surface_stage_->admit(image.payload->size()))
    surface_stage_->arrived({.depth = image, .camera = stream_.camera, .received = now_});
  device_known_ |= device_to_surface_.take();
  const auto device = device_known_ ? std::optional(device_to_surface_.current()) : std::nullopt;
  double spent_us = 0.0;
  const auto made = run_stage(surface_driver_, *surface_stage_, spent_us, device);
  if (made->surface) {
    publish(telemetry_.outbox().surface(made->report, now_));
    if (collision_)
      to_collision_ = made->surface;
    else
      surfaces_.put(*made->surface);
  }
  cost.add(Part::Surface, spent_us);
  cost.add(Part::Messages, std::max(0.0, us_since(before) - spent_us));
}

void BilledStation::detect(StationCost& cost) {
  double spent_us = 0.0;
  (void)haptic_.device().take();
  const auto found = run_stage(collision_driver_, *collision_, spent_us, std::exchange(to_collision_, std::nullopt),
                               haptic_.device().current());
  if (found->plane) surfaces_.put(*found->plane);
  cost.add(Part::Collision, spent_us);
}

void BilledStation::look_inside(StationCost& cost) {
  const std::int64_t before = thread_ns();
  double spent_us = 0.0;
  auto made = run_stage(ultrasound_driver_, *ultrasound_, spent_us,
                        core::UltrasoundStage::View{*telemetry_.outbox().last(), *haptic_from_camera_, objects_});
  if (!made) return;
  if (const auto image = core::UltrasoundStage::hand_over(std::move(*made), now_))
    publish(core::Outbox::ultrasound(*image, now_));
  cost.add(Part::Inside, spent_us);
  cost.add(Part::Messages, std::max(0.0, us_since(before) - spent_us));
}

void BilledStation::run_effects(StationCost& cost) {
  tool_known_ = tool_.take() || tool_known_;
  if (!tool_known_) return;
  for (std::size_t i = 0; i < effect_drivers_.size(); ++i) {
    double spent_us = 0.0;
    auto result = run_stage(effect_drivers_[i], *effects_.stages[i], spent_us, tool_.current());
    if (!result) continue;
    effects_.stages[i]->hand_over(std::move(*result));
    cost.add(Part::Effects, spent_us);
  }
}

/// What the network thread does every 10 ms.
void BilledStation::serve(StationCost& cost) {
  const std::int64_t before = thread_ns();
  telemetry_.drain(now_);
  if (haptic_.compensation().take()) {
    objects_ = haptic_.compensation().current().objects;
    publish(telemetry_.outbox().compensation(haptic_.compensation().current(), now_));
  }
  if ((now_ - BodyStream::kBegin) % kTotals == 0s) publish_totals();
  cost.add(Part::Messages, us_since(before));
}

void BilledStation::publish_totals() {
  core::Outbox& outbox = telemetry_.outbox();
  outbox.facts().costs.clear();
  if (haptic_.bill().take()) outbox.facts().costs = costs_of(haptic_.bill().current(), cycles_per_us());
  publish(outbox.totals(counts_of(haptic_.counts(), 0), now_));
}

void BilledStation::tick(StationCost& cost, TickTimer* pace) {
  const std::int64_t before = thread_ns();
  if (pace != nullptr) (void)pace->wait();
  haptic_.tick({.deadline = TickTimer::Clock::time_point(now_.time_since_epoch()), .late = 0ns, .missed = 0});
  cost.add(Part::Loop, us_since(before));
}

void BilledStation::run(double seconds, StationCost& cost, TickTimer* pace) {
  const auto end = ticked_ + static_cast<std::uint64_t>(seconds / to_seconds(loop::kTickPeriod));
  for (; ticked_ < end; ++ticked_, now_ += loop::kTickPeriod) {
    if (surface_stage_ && next_image_ < stream_.images.size() &&
        stream_.images[next_image_].published + kArrives <= now_)
      see(cost);
    if (surface_stage_ && next_image_ < kFirstImages)
      continue;  // as the station, which ticks from the first surface on
    const bool served = (now_ - BodyStream::kBegin) % kServed == 0s;
    if (collision_ && served) detect(cost);
    if (!effect_drivers_.empty()) run_effects(cost);
    tick(cost, pace);
    if (served) serve(cost);
    if (ultrasound_ && served && telemetry_.outbox().last()) look_inside(cost);
  }
  cost.seconds += seconds;
}

std::vector<double> BilledStation::effects_us() const {
  std::vector<double> all;
  for (const effects::EffectBill& line : loop_.controller().effects().bill())
    all.push_back(line.steps == 0 ? 0.0
                                  : static_cast<double>(line.cost) / static_cast<double>(line.steps) / cycles_per_us());
  return all;
}

}  // namespace telepalp::station
