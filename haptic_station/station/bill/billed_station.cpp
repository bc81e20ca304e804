#include "haptic_station/station/bill/billed_station.h"

#include <algorithm>
#include <numeric>

#include "haptic_station/station/bill/thread_time.h"
#include "haptic_station/station/rigs/placement.h"
#include "haptic_station/station/rigs/scene_rig.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;

constexpr auto kArrives = 20ms;     // from an image's exposure to its arrival at the station
constexpr auto kServed = 10ms;      // period of the network thread's work
constexpr auto kTotals = 1s;        // period of /station/stats
constexpr auto kUltrasound = 40ms;  // period of the ultrasound image
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
      loop_(loop_of(scene)),
      rig_(rig_of(scene, parts.trace)),
      haptic_(loop_, *rig_, surfaces_, *ticks_, device_to_surface_),
      telemetry_(
          *ticks_, [this](const wire::Message& message) { publish(message); }, [](const loop::TickSample&) {}) {
  if (parts.model) {
    haptic_from_camera_ = parts.model->haptic_from_model;
    surfaces_.put({parts.model->snapshot, parts.model->haptic_from_model});
  } else {
    start_surface_thread(parts);
  }
  start_inside_thread();
}

/// Ends the threads before the members that they use are destroyed.
BilledStation::~BilledStation() {
  inside_.reset();
  worker_.reset();
}

void BilledStation::start_surface_thread(const SceneParts& parts) {
  if (!surface::runs_in_tick(parts.surface)) collision_.emplace();
  const auto placement = [this](const DepthImage& depth, const Intrinsics& camera) {
    return haptic_from_camera_ = placed(scene_, depth, camera);
  };
  const auto answer = [this] {
    surface_spent_ns_ = thread_ns();
    answered_.release();
  };
  worker_.emplace(parts.surface, placement,
                  SurfaceWorker::Handlers{.now = [this] { return now_ + Nanoseconds{thread_ns() - surface_spent_ns_}; },
                                          .on_report =
                                              [this, answer](const msg::SurfaceReport& report) {
                                                answer_ = wire::make_message(wire::kStationSurface, now_, report);
                                                answer();
                                              },
                                          .on_bad_frame = [answer](const Error&) { answer(); },
                                          .request_key_frame = [](const wire::Message&) {}},
                  collision_ ? slow_surfaces_ : surfaces_, device_to_surface_, scene_.effects);
}

void BilledStation::start_inside_thread() {
  if (scene_.layers.empty() && !scene_.probe) return;
  inside_.emplace(scene_,
                  InsideThread::Handlers{.on_structures =
                                             [this](const InnerSurfaces& made) {
                                               inside_spent_ns_ = thread_ns();
                                               answer_ = wire::make_message(wire::kStationInside, now_, made.drawn);
                                               answered_.release();
                                             },
                                         .on_image =
                                             [this](const msg::UltrasoundImage& image) {
                                               inside_spent_ns_ = thread_ns();
                                               answer_ = wire::make_message(wire::kStationUltrasound, now_, image);
                                               answered_.release();
                                             }});
  answered_.acquire();
  start_ms_ = 1e-6 * static_cast<double>(inside_spent_ns_);
  publish(*answer_);
}

void BilledStation::publish(const wire::Message& message) {
  Published& topic = published_[std::string(message.topic.name)];
  ++topic.messages;
  topic.bytes += message.payload->size();
}

/// Hands the next image to the surface thread and waits for its surface.
void BilledStation::see(StationCost& cost) {
  const std::int64_t before = surface_spent_ns_;
  const std::int64_t mine = thread_ns();
  telemetry_.frame_received();
  answer_.reset();
  worker_->offer({.depth = stream_.images[next_image_], .camera = stream_.camera, .received = now_});
  answered_.acquire();
  if (answer_) publish(*answer_);
  cost.add(Part::Surface, 1e-3 * static_cast<double>(surface_spent_ns_ - before));
  cost.add(Part::Messages, us_since(mine));
  ++next_image_;
}

void BilledStation::look_inside(StationCost& cost) {
  const std::int64_t before = inside_spent_ns_;
  const std::int64_t mine = thread_ns();
  inside_->offer({telemetry_.last(), *haptic_from_camera_, objects_});
  answered_.acquire();
  publish(*answer_);
  cost.add(Part::Inside, 1e-3 * static_cast<double>(inside_spent_ns_ - before));
  cost.add(Part::Messages, us_since(mine));
  next_ultrasound_ = now_ + kUltrasound;
}

/// What the network thread does every 10 ms.
void BilledStation::serve(StationCost& cost) {
  const std::int64_t before = thread_ns();
  telemetry_.drain(now_);
  if (haptic_.compensation().take()) {
    objects_ = haptic_.compensation().current().objects;
    publish(
        wire::make_message(wire::kStationCompensation, now_, compensation_message(haptic_.compensation().current())));
  }
  if ((now_ - BodyStream::kBegin) % kTotals == 0s)
    telemetry_.publish_totals(
        now_, 0.0, haptic_.counts(), 0, false,
        haptic_.bill().take() ? costs_of(haptic_.bill().current(), cycles_per_us()) : std::vector<msg::EffectCost>{});
  cost.add(Part::Messages, us_since(before));
}

void BilledStation::tick(StationCost& cost, TickTimer* pace) {
  const std::int64_t before = thread_ns();
  if (pace != nullptr) (void)pace->wait();
  haptic_.tick({.deadline = TickTimer::Clock::time_point(now_.time_since_epoch()), .late = 0ns, .missed = 0});
  cost.add(Part::Loop, us_since(before));
}

void BilledStation::run(double seconds, StationCost& cost, TickTimer* pace) {
  const auto end = ticked_ + static_cast<std::uint64_t>(seconds / to_seconds(kTickPeriod));
  for (; ticked_ < end; ++ticked_, now_ += kTickPeriod) {
    if (worker_ && next_image_ < stream_.images.size() && stream_.images[next_image_].published + kArrives <= now_)
      see(cost);
    if (worker_ && next_image_ < kFirstImages) continue;  // as the station, which ticks from the first surface on
    const bool served = (now_ - BodyStream::kBegin) % kServed == 0s;
    if (collision_ && served) {
      const std::int64_t before = thread_ns();
      collision_->detect(slow_surfaces_, haptic_.device(), surfaces_, [this] { return now_; });
      cost.add(Part::Collision, us_since(before));
    }
    tick(cost, pace);
    if (served) serve(cost);
    if (inside_ && inside_->has_probe() && telemetry_.has_ticked() && now_ >= next_ultrasound_) look_inside(cost);
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
