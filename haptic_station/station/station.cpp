#include "haptic_station/station/station.h"

#include <boost/asio/post.hpp>
#include <utility>

#include "haptic_station/station/rigs/placement.h"
#include "haptic_station/station/rigs/scene_rig.h"
#include "haptic_station/station/telemetry/say.h"
#include "haptic_station/station/threads/bill.h"
#include "haptic_station/station/threads/timer_check.h"
#include "messages/camera.pb.h"
#include "proto/wire/camera/calibration_message.h"
#include "proto/wire/vector_message.h"
#include "proto/wire/viewer/viewer_hand.h"
#include "proto/words/counted.h"
#include "support/program/address.h"
#include "support/program/ending.h"
#include "support/program/version.h"

namespace telepalp::station {
namespace {

using namespace std::chrono_literals;

constexpr const char* kName = "telepalp-station";
constexpr auto kStatePeriod = 10ms;  // /station/state at 100 Hz
constexpr auto kTotalsPeriod = 1s;   // /station/stats
constexpr auto kSayStillWaiting = 5s;
constexpr auto kBetweenRefusals = 5s;

std::vector<std::string> subscriptions(const StationOptions& options, const DepthChoice& depth,
                                       bool takes_viewer_hand) {
  std::vector<std::string> names;
  if (!options.model) {
    names = depth.topics();
    names.emplace_back(wire::kCameraInfo.name);
    if (depth.asks_window()) names.emplace_back(wire::kCameraStatus.name);
  }
  if (takes_viewer_hand) names.emplace_back(wire::kViewerHand.name);
  return names;
}

wire::ClientLink::Options link_options(const StationOptions& options, std::vector<std::string> subscribes) {
  return {.host = options.host,
          .port = options.port,
          .site = options.site,
          .name = kName,
          .role = "doctor",
          .key = options.key,
          .subscribes = std::move(subscribes),
          .publishes = {wire::kStationState, wire::kStationTicks, wire::kStationSurface, wire::kStationCompensation,
                        wire::kStationEvents, wire::kStationStats, wire::kStationUltrasound, wire::kStationInside,
                        wire::kStationWindow},
          .accepts_touch = options.accepts_touch};
}

}  // namespace

Station::Station(boost::asio::io_context& io, StationSignals& signals, const StationOptions& options,
                 const scenes::Scene& scene, const surface::SurfaceSettings& surface,
                 std::optional<tracking::HandTrace> trace, ConnectedRig rig)
    : options_(options),
      scene_(scene),
      io_(io),
      signals_(signals),
      timers_(io),
      depth_choice_(options.asks_window),
      link_(io, link_options(options, subscriptions(options, depth_choice_, rig.browser != nullptr)),
            {.on_message = [this](const wire::Message& message) { on_message(message); },
             .on_state = [this](wire::LinkState state, const std::string& detail) { on_link(state, detail); },
             .on_datagrams = [this](wire::DatagramPhase, const std::string& detail) { on_datagrams(detail); },
             .on_notice = [](const std::string& text) { say(text); }},
            options.model.has_value()),
      core_(scene, options.model || surface::runs_in_tick(surface), rig.rig ? std::move(rig.rig) : rig_of(scene, trace),
            options.journal),
      telemetry_(
          core_.ticks(), [this](wire::Message message) { link_.publish(std::move(message)); },
          [this](const loop::TickSample& sample) { faults_.add(sample); }),
      faults_(io, telemetry_, options.control, options.state_folder, scene.name,
              {.now = [this] { return now(); },
               .rearm = [this] { core_.haptic()->rearm(); },
               .other_command =
                   [this](const std::string& command, const ControlSocket::Reply& reply) {
                     return link_.hand_over().on_command(command, reply);
                   }}),
      viewer_hand_(rig.browser),
      refusals_{std::move(rig.device_refusals), std::nullopt} {
  core::Outbox::Facts& facts = telemetry_.outbox().facts();
  if (rig.haptic_from_tracker) facts.haptic_from_tracker = core::motion_message(*rig.haptic_from_tracker);
  facts.software = program::software(kName);
  start_surface_thread(surface);
}

Station::~Station() { end_threads(); }

/// Ends the threads before the members that they use are destroyed.
void Station::end_threads() {
  inside_.end();
  core_.end();
}

void Station::start_surface_thread(const surface::SurfaceSettings& surface) {
  const auto placement = [this](const DepthImage& depth, const Intrinsics& camera) {
    const auto haptic_from_camera = placed(scene_, depth, camera);
    boost::asio::post(io_, [this, haptic_from_camera] { seen_.haptic_from_camera = haptic_from_camera; });
    return haptic_from_camera;
  };
  core_.start_surface(
      surface, placement,
      {.now = [this] { return now(); },
       .on_report =
           [this](const msg::SurfaceReport& report) { boost::asio::post(io_, [this, report] { on_surface(report); }); },
       .on_bad_frame = [this](const Error& error) { boost::asio::post(io_, [this, error] { on_dropped(error); }); },
       .request_key_frame =
           [this](const wire::Message& unreadable) {
             boost::asio::post(io_, [this, unreadable] { link_.request_key_frame(unreadable); });
           },
       .on_image = viewer_hand_.image_handler()});
}

Result<void> Station::run() {
  if (const Result<void> listening = faults_.listen(); !listening) {
    if (options_.control_is_asked_for) return listening.error();
    say("this station has no control socket, so telepalp-station rearm cannot end a fault: " +
        to_string(listening.error()));
  }
  const msg::TimerCheck idle_timer = watch_idle_timer(kTimerWatched);
  say(in_words(idle_timer));
  telemetry_.outbox().facts().idle_timer = idle_timer;
  progress_.started = std::chrono::steady_clock::now();
  link_.start();
  if (options_.model) touch_model();
  every_10_ms();
  if (!progress_.stopped) every_second();
  io_.run();
  end_threads();
  if (progress_.failure) return *progress_.failure;
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
  if (std::exchange(progress_.stopped, true)) return;
  if (HapticThread* haptic = core_.haptic()) haptic->stop();
  telemetry_.drain(now());
  faults_.look(true);
  publish_totals();
  say("ending: " + reason);
  if (const std::string ages = images_.ages_in_words(); !ages.empty()) say(ages);
  if (const std::vector<msg::EffectCost>& costs = telemetry_.outbox().facts().costs; !costs.empty())
    say("mean computing time of each effect in a tick with contact: " +
        line_of(costs, std::chrono::duration<double, std::micro>(loop::kTickPeriod).count()));
  timers_.every_10_ms.cancel();
  timers_.every_second.cancel();
  faults_.stop();
  link_.stop(reason);
}

void Station::give_up(const Error& error) {
  if (!progress_.failure) progress_.failure = error;
  stop("the station cannot go on: " + (error.where.empty() ? "" : error.where + ": ") + error.what);
}

/// Ends the station because no surface came within the operator's time limit.
void Station::lose_patience() {
  const std::string where = program::to_text({options_.host, options_.port});
  const bool connected = link_.client().state() == wire::LinkState::Connected;
  if (const std::optional<Error>& newest = images_.dropped().newest_image(); connected && newest)
    return give_up({.what = "none of the server's " +
                            counted(images_.dropped().images(), "depth image", "depth images") +
                            " could be used; the last one: " + newest->what,
                    .where = where,
                    .fix = newest->fix + ", or wait longer by --patience S"});
  if (connected)
    return give_up(
        {.what = "the server answers but sends no depth image",
         .where = where,
         .fix = "check the server's camera or recording (telepalp-server --source), or wait longer by --patience S"});
  const std::optional<Error>& reason = link_.client().not_served_because();
  if (!reason)
    return give_up({.what = link_.client().no_answer(),
                    .where = where,
                    .fix = "start telepalp-server, name another one by --connect, or wait longer by --patience S"});
  give_up({.what = "the server does not serve this station yet: " + reason->what,
           .where = where,
           .fix = "start the station again with a longer --patience S" +
                  (reason->fix.empty() ? "" : ", and while it waits: " + reason->fix)});
}

void Station::on_link(wire::LinkState state, const std::string& detail) {
  if (const auto line = link_.line_of(state, detail)) say(*line);
  if (state == wire::LinkState::Refused && !options_.model)  // a model is touched without a server
    return give_up(link_.client().refusal());
  look_at_clock();
  if (HapticThread* haptic = core_.haptic()) haptic->set_clock_offset(link_.clock_offset());
  if (state == wire::LinkState::Connected) {
    depth_choice_.connected(std::chrono::steady_clock::now());
    publish_inside();
  }
  if (state == wire::LinkState::Connected || state == wire::LinkState::Lost)
    telemetry_.publish_event(now(), msg::EVENT_KIND_LINK, "link " + std::string(wire::name(state)));
}

void Station::on_datagrams(const std::string& detail) {
  say(detail);
  telemetry_.publish_event(now(), msg::EVENT_KIND_LINK, detail);
}

void Station::on_message(const wire::Message& message) {
  choose_depth(message);
  if (message.topic.name == wire::kCameraInfo.name) on_camera_info(message);
  if (message.topic.name == wire::kCameraStatus.name) on_camera_status(message);
  if (message.topic.name == wire::kViewerHand.name) on_viewer_hand(message);
}

/// CaptureStatus::detail also tells what the server gives up for a thin line, so the operator sees each new text. The
/// first text only describes the camera.
void Station::on_camera_status(const wire::Message& message) {
  msg::CaptureStatus status;
  if (!status.ParseFromString(*message.payload)) return;
  const std::string before = std::exchange(camera_detail_, status.detail());
  if (before.empty() || before == camera_detail_) return;
  say(camera_detail_);
  telemetry_.publish_event(now(), msg::EVENT_KIND_LINK, camera_detail_);
}

void Station::on_camera_info(const wire::Message& message) {
  foxglove::CameraCalibration calibration;
  if (!calibration.ParseFromString(*message.payload)) return on_unreadable(message);
  const std::optional<Intrinsics> intrinsics = wire::intrinsics_of(calibration);
  if (!intrinsics)
    return say(
        "message on /camera/info dropped: the camera's intrinsics are not finite and positive. fix: correct the "
        "intrinsics in the server's camera.textproto");
  seen_.camera = intrinsics;
}

void Station::choose_depth(const wire::Message& message) {
  const DepthChoice::Came came = depth_choice_.came(message.topic.name, std::chrono::steady_clock::now());
  if (came.topics_changed) subscribe();
  if (came.said) {
    say(*came.said);
    telemetry_.publish_event(now(), msg::EVENT_KIND_SCENE, *came.said);
  }
  if (came.is_used) on_depth(message);
}

void Station::subscribe() { link_.subscribe(subscriptions(options_, depth_choice_, viewer_hand_.is_used())); }

void Station::on_depth(const wire::Message& message) {
  telemetry_.outbox().frame_received();
  if (!seen_.camera) return;  // the camera's model comes within a second
  core_.surface().offer({.depth = message, .camera = *seen_.camera, .received = now()});
}

void Station::on_dropped(const Error& error) {
  if (const auto line = images_.dropped().add_image(error, std::chrono::steady_clock::now())) say(*line);
}

void Station::on_unreadable(const wire::Message& message) {
  if (const auto line = images_.dropped().add_unreadable(message.topic.name, std::chrono::steady_clock::now()))
    say(*line);
}

void Station::on_viewer_hand(const wire::Message& message) {
  const std::optional<msg::ViewerHand> hand = wire::read_viewer_hand(*message.payload);
  if (!hand) return on_unreadable(message);
  if (!viewer_hand_.is_used() || !seen_.haptic_from_camera) return;
  if (hand->rearm()) return faults_.rearm_for("viewer " + std::to_string(hand->viewer()));
  if (hand->accept_object()) return core_.surface().accept_object();
  const Point<DepthCamera> in_camera{wire::vector_of(hand->hand_camera())};
  if (const auto line = viewer_hand_.hear(*hand, *seen_.haptic_from_camera * in_camera)) say(*line);
}

void Station::on_surface(const msg::SurfaceReport& report) {
  telemetry_.publish(telemetry_.outbox().surface(report, now()));
  if (const auto fidelity = images_.add(report, link_.clock_error_s())) {
    say(fidelity->text);
    if (fidelity->is_warning) telemetry_.publish_event(now(), msg::EVENT_KIND_SCENE, fidelity->text);
  }
  if (const auto left = window_requests_.look(report, now())) {
    say(*left);
    telemetry_.publish_event(now(), msg::EVENT_KIND_SCENE, *left);
  }
  if (core_.haptic() == nullptr) start_haptic_thread();
}

void Station::ask_window(const loop::TickSample& tick) {
  if (!depth_choice_.asks_window() || !seen_.camera || !seen_.haptic_from_camera) return;
  const auto request = window_requests_.due(tick, *seen_.haptic_from_camera, *seen_.camera);
  if (request) telemetry_.publish(wire::make_message(wire::kStationWindow, now(), *request));
}

void Station::touch_model() {
  if (!options_.model->remarks.empty()) say("model: " + options_.model->remarks);
  say("the hand touches a model of " + std::to_string(options_.model->snapshot->points) +
      " points from a file; the station needs no server");
  seen_.haptic_from_camera = options_.model->haptic_from_model;
  core_.touch(*options_.model);
  start_haptic_thread();
}

void Station::start_haptic_thread() {
  const Result<RealtimeGrant> granted =
      core_.start_haptic(options_.realtime, link_.clock_offset(), [this] { return now(); });
  if (!granted) return give_up(granted.error());
  telemetry_.outbox().facts().realtime = granted->both();
  progress_.ticking_since = std::chrono::steady_clock::now();
  const std::string realtime = in_words(*granted);
  say("the surface is touchable; the control loop runs at 2 kHz " + realtime);
  telemetry_.publish_event(now(), msg::EVENT_KIND_SCENE, "the control loop runs scene " + scene_.name + " " + realtime);
  start_inside_view();
}

void Station::start_inside_view() {
  const auto on_structures = [this](const std::vector<std::string>& left_out) {
    for (const std::string& layer : left_out) say("the viewers do not draw the " + layer);
    say("the inner surfaces for viewers are made");
    publish_inside();
  };
  const auto on_image = [this](const msg::UltrasoundImage& image) {
    telemetry_.publish(core::Outbox::ultrasound(image, now()));
  };
  inside_.start(io_, scene_, {.now = [this] { return now(); }, .on_structures = on_structures, .on_image = on_image});
  publish_inside();
}

void Station::publish_inside() {
  if (!seen_.haptic_from_camera) return;
  if (const auto structures = inside_.structures(now(), *seen_.haptic_from_camera))
    telemetry_.publish(core::Outbox::inside(*structures, now()));
}

void Station::every_10_ms() {
  look_at_signals();
  if (progress_.stopped) return;
  telemetry_.drain(now());
  faults_.look(false);
  if (const auto step = link_.clock_step()) {
    say(*step);
    telemetry_.publish_event(now(), msg::EVENT_KIND_LINK, *step);
  }
  const auto since = [](std::chrono::steady_clock::time_point then) { return std::chrono::steady_clock::now() - then; };
  if (HapticThread* haptic = core_.haptic()) {
    serve_haptic_thread(*haptic);
    if (options_.seconds > 0.0 && since(progress_.ticking_since) >= from_seconds(options_.seconds))
      return stop("the time of --seconds is over");
  } else if (options_.patience && since(progress_.started) > *options_.patience) {
    return lose_patience();
  }
  timers_.every_10_ms.expires_after(kStatePeriod);
  timers_.every_10_ms.async_wait([this](const boost::system::error_code& error) {
    if (!error && !progress_.stopped) every_10_ms();
  });
}

void Station::serve_haptic_thread(HapticThread& haptic) {
  if (const auto& tick = telemetry_.outbox().last(); tick && seen_.haptic_from_camera)
    inside_.look(now(), *tick, *seen_.haptic_from_camera);
  if (const auto& tick = telemetry_.outbox().last()) ask_window(*tick);
  if (haptic.compensation().take()) {
    const loop::Compensation& compensation = haptic.compensation().current();
    inside_.set_objects(compensation.objects);
    telemetry_.publish(telemetry_.outbox().compensation(compensation, now()));
    if (const auto limited = stiffness_notice_.look(compensation)) {
      say(*limited);
      telemetry_.publish_event(now(), msg::EVENT_KIND_DEVICE, *limited);
    }
  }
  haptic.set_clock_offset(link_.clock_offset());
}

/// One line at most every 5 s, with the number of datagrams since the last one.
void Station::say_device_refusals() {
  const auto now = std::chrono::steady_clock::now();
  if (!refusals_.newest || (refusals_.said && now - *refusals_.said < kBetweenRefusals)) return;
  const std::optional<Error> refused = refusals_.newest();
  if (!refused) return;
  refusals_.said = now;
  say(to_string(*refused));
}

void Station::look_at_clock() {
  link_.look_at_clock();
  telemetry_.outbox().facts().clock_error_s = link_.clock_error_s();
}

void Station::every_second() {
  look_at_clock();
  say_device_refusals();
  publish_totals();
  const auto now = std::chrono::steady_clock::now();
  if (!options_.model && link_.client().state() == wire::LinkState::Connected && depth_choice_.look(now)) subscribe();
  const auto waited = now - progress_.started;
  if (core_.haptic() == nullptr && waited % kSayStillWaiting < kTotalsPeriod)
    say(link_.client().state() == wire::LinkState::Connected ? "waiting for the first usable depth image"
                                                             : "waiting for the server");
  timers_.every_second.expires_after(kTotalsPeriod);
  timers_.every_second.async_wait([this](const boost::system::error_code& error) {
    if (!error && !progress_.stopped) every_second();
  });
}

void Station::publish_totals() {
  HapticThread* const haptic = core_.haptic();
  if (haptic == nullptr) return;
  core::Outbox& outbox = telemetry_.outbox();
  if (haptic->bill().take()) outbox.facts().costs = costs_of(haptic->bill().current(), cycles_per_us());
  telemetry_.publish(outbox.totals(counts_of(haptic->counts(), core_.surface().dropped()), now()));
}

}  // namespace telepalp::station
