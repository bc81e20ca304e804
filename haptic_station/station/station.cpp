#include "haptic_station/station/station.h"

#include <algorithm>
#include <boost/asio/post.hpp>
#include <cstdio>
#include <utility>

#include "codec/depth.h"
#include "haptic_station/station/rigs/placement.h"
#include "haptic_station/station/rigs/scene_rig.h"
#include "haptic_station/station/threads/bill.h"
#include "haptic_station/station/threads/timer_check.h"
#include "proto/wire/camera/calibration_message.h"
#include "proto/wire/depth_loss.h"
#include "proto/wire/vector_message.h"
#include "proto/wire/viewer/viewer_hand.h"
#include "proto/words/counted.h"
#include "support/program/address.h"
#include "support/program/ending.h"
#include "support/program/log.h"
#include "support/program/version.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;

constexpr const char* kName = "telepalp-station";
constexpr auto kStatePeriod = 10ms;  // /station/state at 100 Hz
constexpr auto kTotalsPeriod = 1s;   // /station/stats
constexpr auto kImagePeriod = 40ms;  // /station/ultrasound at 25 Hz
constexpr auto kSayStillWaiting = 5s;
constexpr auto kBetweenRefusals = 5s;

void say(const std::string& text) { program::log(kName, text); }

wire::ClientLink::Options link_options(const StationOptions& options, bool takes_viewer_hand) {
  wire::ClientLink::Options link{
      .host = options.host,
      .port = options.port,
      .name = kName,
      .role = "doctor",
      .key = options.key,
      .subscribes = options.model ? std::vector<std::string>{}
                                  : std::vector<std::string>{std::string(wire::kCameraDepth.name),
                                                             std::string(wire::kCameraInfo.name)},
      .publishes = {wire::kStationState, wire::kStationTicks, wire::kStationSurface, wire::kStationCompensation,
                    wire::kStationEvents, wire::kStationStats, wire::kStationUltrasound, wire::kStationInside},
      .accepts_touch = options.accepts_touch};
  if (takes_viewer_hand) link.subscribes.emplace_back(wire::kViewerHand.name);
  return link;
}

}  // namespace

Station::Station(boost::asio::io_context& io, StationSignals& signals, const StationOptions& options,
                 const scenes::Scene& scene, const surface::SurfaceSettings& surface,
                 std::optional<tracking::HandTrace> trace, ConnectedRig rig)
    : options_(options),
      scene_(scene),
      trace_(std::move(trace)),
      io_(io),
      signals_(signals),
      fast_timer_(io),
      slow_timer_(io),
      link_(io, link_options(options, rig.browser != nullptr),
            {.on_message = [this](const wire::Message& message) { on_message(message); },
             .on_state = [this](wire::LinkState state, const std::string& detail) { on_link(state, detail); },
             .on_datagrams = [this](wire::DatagramPhase, const std::string& detail) { on_datagrams(detail); },
             .on_hand_over = [this](bool done, const std::string& outcome) { hand_over_.on_answer(done, outcome); }}),
      hand_over_(link_),
      device_refusals_(std::move(rig.device_refusals)),
      in_tick_(options.model || surface::runs_in_tick(surface)),
      loop_(loop_of(scene)),
      rig_(std::move(rig.rig)),
      viewer_hand_tracker_(rig.browser),
      telemetry_(
          ticks_, [this](wire::Message message) { publish(std::move(message)); },
          [this](const loop::TickSample& sample) { faults_.add(sample); }),
      faults_(io, telemetry_, options.control, options.state_folder, scene.name,
              {.now = [this] { return now(); },
               .rearm = [this] { haptic_->rearm(); },
               .other_command =
                   [this](const std::string& command, const ControlSocket::Reply& reply) {
                     return hand_over_.on_command(command, reply);
                   }}) {
  if (rig.haptic_from_tracker) telemetry_.set_calibration(*rig.haptic_from_tracker);
  telemetry_.set_software(program::software(kName));
  start_surface_thread(surface);
}

Station::~Station() { end_threads(); }

/// Ends the threads before the members that they use are destroyed. The collision thread reads a hand-off of the haptic
/// thread, so it ends first.
void Station::end_threads() {
  inside_thread_.reset();
  collision_.reset();
  haptic_.reset();
  worker_.reset();
}

/// A browser's hand must know what it flies over; no other tracker needs the images.
decltype(SurfaceWorker::Handlers::on_image) Station::image_handler() {
  if (viewer_hand_tracker_ == nullptr) return nullptr;
  return [this](const DepthImage& depth, const Intrinsics& camera,
                const Transform<HapticBase, DepthCamera>& haptic_from_camera) {
    viewer_hand_tracker_->see(tracking::heights_of(depth, camera, haptic_from_camera));
  };
}

void Station::start_surface_thread(const surface::SurfaceSettings& surface) {
  const auto placement = [this](const DepthImage& depth, const Intrinsics& camera) {
    const auto haptic_from_camera = placed(scene_, depth, camera);
    boost::asio::post(io_, [this, haptic_from_camera] { haptic_from_camera_ = haptic_from_camera; });
    return haptic_from_camera;
  };
  worker_.emplace(
      surface, placement,
      SurfaceWorker::Handlers{
          .now = [this] { return now(); },
          .on_report =
              [this](const msg::SurfaceReport& report) {
                boost::asio::post(io_, [this, report] { on_surface(report); });
              },
          .on_bad_frame = [this](const Error& error) { boost::asio::post(io_, [this, error] { on_dropped(error); }); },
          .request_key_frame =
              [this](const wire::Message& unreadable) {
                boost::asio::post(io_, [this, unreadable] { link_.request_key_frame(unreadable); });
              },
          .on_image = image_handler()},
      in_tick_ ? surfaces_ : slow_surfaces_, device_to_surface_, scene_.effects);
}

Result<void> Station::run() {
  if (const Result<void> listening = faults_.listen(); !listening) {
    if (options_.control_is_asked_for) return listening.error();
    say("this station has no control socket, so telepalp-station rearm cannot end a fault: " +
        to_string(listening.error()));
  }
  const msg::TimerCheck idle_timer = watch_idle_timer(kTimerWatched);
  say(in_words(idle_timer));
  telemetry_.set_idle_timer(idle_timer);
  started_ = std::chrono::steady_clock::now();
  link_.start();
  if (options_.model) touch_model();
  every_10_ms();
  if (!stopped_) every_second();
  io_.run();
  if (haptic_) haptic_->stop();
  collision_.reset();
  if (failure_) return *failure_;
  return {};
}

void Station::look_at_signals() {
  const StationSignals::Asked asked = signals_.asked();
  if (asked == StationSignals::Asked::NewScene) stop("a new scene is accepted");
  if (asked != StationSignals::Asked::End) return;
  program::end_within(
      program::kTimeToEnd,
      "telepalp-station: the station did not end within 5 s and is aborted. fix: start telepalp-station again");
  stop("a signal stopped the station (Ctrl-C, kill, or its terminal was closed)");
}

void Station::stop(const std::string& reason) {
  if (std::exchange(stopped_, true)) return;
  if (haptic_) haptic_->stop();
  telemetry_.drain(now());
  faults_.look(true);
  publish_totals();
  say("ending: " + reason);
  if (const std::string ages = ages_.in_words(); !ages.empty()) say(ages);
  if (!costs_.empty())
    say("mean computing time of each effect in a tick with contact: " +
        line_of(costs_, std::chrono::duration<double, std::micro>(kTickPeriod).count()));
  fast_timer_.cancel();
  slow_timer_.cancel();
  faults_.stop();
  link_.stop(reason);
}

void Station::give_up(const Error& error) {
  if (!failure_) failure_ = error;
  stop("the station cannot go on: " + (error.where.empty() ? "" : error.where + ": ") + error.what);
}

/// Ends the station because no surface came within the operator's time limit.
void Station::lose_patience() {
  const std::string where = program::to_text({options_.host, options_.port});
  const bool connected = link_.state() == wire::LinkState::Connected;
  if (const std::optional<Error>& newest = dropped_.newest_image(); connected && newest)
    return give_up({.what = "none of the server's " + counted(dropped_.images(), "depth image", "depth images") +
                            " could be used; the last one: " + newest->what,
                    .where = where,
                    .fix = newest->fix + ", or wait longer by --patience S"});
  if (connected)
    return give_up(
        {.what = "the server answers but sends no depth image",
         .where = where,
         .fix = "check the server's camera or recording (telepalp-server --source), or wait longer by --patience S"});
  const std::optional<Error>& reason = link_.not_served_because();
  if (!reason)
    return give_up({.what = "does not answer",
                    .where = where,
                    .fix = "start telepalp-server, name another one by --connect, or wait longer by --patience S"});
  give_up({.what = "the server does not serve this station yet: " + reason->what,
           .where = where,
           .fix = "start the station again with a longer --patience S" +
                  (reason->fix.empty() ? "" : ", and while it waits: " + reason->fix)});
}

void Station::publish(wire::Message message) { (void)link_.publish(std::move(message)); }

void Station::on_link(wire::LinkState state, const std::string& detail) {
  say_link("link " + std::string(wire::name(state)) + (detail.empty() ? "" : ": " + detail), state);
  if (state == wire::LinkState::Refused && !options_.model)  // a model is touched without a server
    return give_up(link_.refusal());
  look_at_clock();
  if (haptic_) haptic_->set_clock_offset(link_.clock().offset());
  if (state == wire::LinkState::Connected) publish_inside();
  if (state == wire::LinkState::Connected || state == wire::LinkState::Lost)
    telemetry_.publish_event(now(), msg::EVENT_KIND_LINK, "link " + std::string(wire::name(state)));
}

void Station::on_datagrams(const std::string& detail) {
  say(detail);
  telemetry_.publish_event(now(), msg::EVENT_KIND_LINK, detail);
}

/// Repeated attempts to connect are logged once until one succeeds.
void Station::say_link(const std::string& text, wire::LinkState state) {
  const bool trying = state == wire::LinkState::Connecting;
  if (!trying) said_of_trying_.clear();
  if (!trying || said_of_trying_.insert(text).second) say(text);
}

void Station::on_message(const wire::Message& message) {
  if (message.topic.name == wire::kCameraDepth.name) on_depth(message);
  if (message.topic.name == wire::kCameraInfo.name) on_camera_info(message);
  if (message.topic.name == wire::kViewerHand.name) on_viewer_hand(message);
}

void Station::on_camera_info(const wire::Message& message) {
  foxglove::CameraCalibration calibration;
  if (!calibration.ParseFromString(*message.payload)) return on_unreadable(message);
  const std::optional<Intrinsics> intrinsics = wire::intrinsics_of(calibration);
  if (!intrinsics)
    return say(
        "message on /camera/info dropped: the camera's intrinsics are not finite and positive. fix: correct the "
        "intrinsics in the server's camera.textproto");
  camera_ = intrinsics;
}

void Station::on_depth(const wire::Message& message) {
  telemetry_.frame_received();
  if (!camera_) return;  // the camera's model comes within a second
  worker_->offer({.depth = message, .camera = *camera_, .received = now()});
}

void Station::on_dropped(const Error& error) {
  if (const auto line = dropped_.add_image(error, std::chrono::steady_clock::now())) say(*line);
}

void Station::on_unreadable(const wire::Message& message) {
  if (const auto line = dropped_.add_unreadable(message.topic.name, std::chrono::steady_clock::now())) say(*line);
}

void Station::on_viewer_hand(const wire::Message& message) {
  const std::optional<msg::ViewerHand> hand = wire::read_viewer_hand(*message.payload);
  if (!hand) return on_unreadable(message);
  if (viewer_hand_tracker_ == nullptr || !haptic_from_camera_) return;
  if (hand->rearm()) return faults_.rearm_for("viewer " + std::to_string(hand->viewer()));
  const Point<HapticBase> in_haptic = *haptic_from_camera_ * Point<DepthCamera>{wire::vector_of(hand->hand_camera())};
  const auto taken = viewer_hand_tracker_->hear(*hand, in_haptic, std::chrono::steady_clock::now());
  if (std::exchange(hand_taken_, taken) != taken)
    say("/viewer/hand: viewer " + std::to_string(hand->viewer()) + ": " + tracking::in_words(taken));
}

void Station::on_surface(const msg::SurfaceReport& report) {
  msg::SurfaceReport bounded = report;
  bounded.set_clock_error_s(clock_error_s_);
  ages_.add(bounded);
  publish(wire::make_message(wire::kStationSurface, now(), bounded));
  say_depth(report);
  if (!haptic_) start_haptic_thread();
}

/// Near-lossless depth differs from the measurement, so the log states its error bound.
void Station::say_depth(const msg::SurfaceReport& report) {
  const wire::DepthFidelity fidelity = wire::depth_fidelity(report);
  const std::string words = wire::in_words(fidelity);
  if (std::exchange(depth_, words) == words) return;
  if (!fidelity.moved) return say("depth is lossless (depth mode " + fidelity.mode + ")");
  const std::string warning = "the touched depth is near-lossless: " + words +
                              "; such depth is for pictures, not for touch. fix: " +
                              (fidelity.mode == codec::name(codec::DepthMode::Bounded)
                                   ? "start telepalp-server with --depth-mode fast, intra or temporal"
                                   : "give the server a source with lossless depth");
  say(warning);
  telemetry_.publish_event(now(), msg::EVENT_KIND_SCENE, warning);
}

/// Hands over the surface of the static model. The network thread does this, because there is no surface thread without
/// a camera.
void Station::touch_model() {
  if (!options_.model->remarks.empty()) say("model: " + options_.model->remarks);
  say("the hand touches a model of " + std::to_string(options_.model->snapshot->points) +
      " points from a file; the station needs no server");
  haptic_from_camera_ = options_.model->haptic_from_model;
  surfaces_.put({options_.model->snapshot, options_.model->haptic_from_model});
  start_haptic_thread();
}

void Station::start_haptic_thread() {
  if (!rig_) rig_ = rig_of(scene_, trace_);
  haptic_.emplace(loop_, *rig_, surfaces_, ticks_, device_to_surface_);
  haptic_->set_clock_offset(link_.clock().offset());
  if (!in_tick_) collision_.emplace(slow_surfaces_, haptic_->device(), surfaces_, [this] { return now(); });
  const Result<RealtimeGrant> granted = haptic_->start(options_.realtime);
  if (!granted) return give_up(granted.error());
  realtime_granted_ = granted->both();
  ticking_since_ = std::chrono::steady_clock::now();
  const std::string realtime = in_words(*granted);
  say("the surface is touchable; the control loop runs at 2 kHz " + realtime);
  telemetry_.publish_event(now(), msg::EVENT_KIND_SCENE, "the control loop runs scene " + scene_.name + " " + realtime);
  start_inside_thread();
}

void Station::start_inside_thread() {
  if (scene_.layers.empty() && !scene_.probe) {
    inside_.emplace();  // a message without structures replaces that of a station before this one
    return publish_inside();
  }
  inside_thread_.emplace(
      scene_, InsideThread::Handlers{.on_structures =
                                         [this](InnerSurfaces made) {
                                           boost::asio::post(io_, [this, made = std::move(made)]() mutable {
                                             for (const std::string& layer : made.left_out)
                                               say("the viewers do not draw the " + layer);
                                             say("the inner surfaces for viewers are made");
                                             inside_ = std::move(made.drawn);
                                             publish_inside();
                                           });
                                         },
                                     .on_image =
                                         [this](msg::UltrasoundImage image) {
                                           boost::asio::post(io_, [this, image = std::move(image)] {
                                             publish(wire::make_message(wire::kStationUltrasound, now(), image));
                                           });
                                         }});
}

void Station::publish_inside() {
  if (!inside_ || !haptic_from_camera_) return;
  inside_->set_stamp_ns(static_cast<std::uint64_t>(to_nanoseconds(now())));
  set_place(*inside_, *haptic_from_camera_);
  publish(wire::make_message(wire::kStationInside, now(), *inside_));
}

/// Asks for the next ultrasound image when it is due.
void Station::look_inside() {
  const auto now = std::chrono::steady_clock::now();
  if (!inside_thread_ || !haptic_from_camera_ || !telemetry_.has_ticked() || now < next_image_) return;
  next_image_ = std::max(next_image_ + kImagePeriod, now);  // the period on average, however late the timer comes
  inside_thread_->offer({telemetry_.last(), *haptic_from_camera_, objects_});
}

void Station::every_10_ms() {
  look_at_signals();
  if (stopped_) return;
  telemetry_.drain(now());
  faults_.look(false);
  say_clock_step();
  look_inside();
  if (haptic_ && haptic_->compensation().take()) {
    objects_ = haptic_->compensation().current().objects;
    msg::StationCompensation compensation = compensation_message(haptic_->compensation().current());
    compensation.set_clock_error_s(clock_error_s_);
    publish(wire::make_message(wire::kStationCompensation, now(), compensation));
  }
  if (haptic_) haptic_->set_clock_offset(link_.clock().offset());
  const bool time_is_up = haptic_ && options_.seconds > 0.0 &&
                          std::chrono::steady_clock::now() - ticking_since_ >= from_seconds(options_.seconds);
  if (time_is_up) return stop("the time of --seconds is over");
  if (!haptic_ && options_.patience && std::chrono::steady_clock::now() - started_ > *options_.patience)
    return lose_patience();
  fast_timer_.expires_after(kStatePeriod);
  fast_timer_.async_wait([this](const boost::system::error_code& error) {
    if (!error && !stopped_) every_10_ms();
  });
}

/// A static model has this computer's own time stamps, so the clock error is 0.
void Station::look_at_clock() {
  const Nanoseconds bound = options_.model ? Nanoseconds{0} : link_.clock_uncertainty();
  clock_error_s_ = bound == Nanoseconds::max() ? std::numeric_limits<double>::infinity() : to_seconds(bound);
}

/// When a server restarts, the session clock may step by as much as the wall clock of its computer was changed.
void Station::say_clock_step() {
  const Nanoseconds stepped = link_.clock_stepped();
  const Nanoseconds by = stepped - std::exchange(clock_stepped_, stepped);
  if (by == Nanoseconds{0}) return;
  char text[128];
  std::snprintf(text, sizeof text,
                "the server's clock stepped by %+.1f s; the contact ends, and can begin again with the next image",
                to_seconds(by));
  say(text);
  telemetry_.publish_event(now(), msg::EVENT_KIND_LINK, text);
}

/// One line at most every 5 s, with the number of datagrams since the last one.
void Station::say_device_refusals() {
  const auto now = std::chrono::steady_clock::now();
  if (!device_refusals_ || (refusals_said_ && now - *refusals_said_ < kBetweenRefusals)) return;
  const std::optional<Error> refused = device_refusals_();
  if (!refused) return;
  refusals_said_ = now;
  say(to_string(*refused));
}

void Station::every_second() {
  look_at_clock();
  say_device_refusals();
  if (haptic_)
    publish_totals();
  else if (const auto waited = std::chrono::steady_clock::now() - started_; waited % kSayStillWaiting < kTotalsPeriod)
    say(link_.state() == wire::LinkState::Connected ? "waiting for the first usable depth image"
                                                    : "waiting for the server");
  slow_timer_.expires_after(kTotalsPeriod);
  slow_timer_.async_wait([this](const boost::system::error_code& error) {
    if (!error && !stopped_) every_second();
  });
}

void Station::publish_totals() {
  if (!haptic_) return;
  if (haptic_->bill().take()) costs_ = costs_of(haptic_->bill().current(), cycles_per_us());
  telemetry_.publish_totals(now(), clock_error_s_, haptic_->counts(), worker_->dropped(), realtime_granted_, costs_);
}

}  // namespace telepalp::station
