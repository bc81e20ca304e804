#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "haptic_station/loop/simulated_rig.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/commands/hand_over.h"
#include "haptic_station/station/faults/fault_monitor.h"
#include "haptic_station/station/inside/inside_thread.h"
#include "haptic_station/station/rigs/rig_choice.h"
#include "haptic_station/station/rigs/static_patient.h"
#include "haptic_station/station/signals/station_signals.h"
#include "haptic_station/station/telemetry/dropped_messages.h"
#include "haptic_station/station/telemetry/image_ages.h"
#include "haptic_station/station/telemetry/telemetry_publisher.h"
#include "haptic_station/station/threads/collision_thread.h"
#include "haptic_station/station/threads/haptic_thread.h"
#include "haptic_station/station/threads/surface_worker.h"
#include "proto/wire/client_link.h"
#include "support/program/patience.h"

namespace telepalp::station {

/// Options of the command line.
struct StationOptions {
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;
  std::shared_ptr<const keys::KeyFile> key{};  ///< null: the server is on this machine
  bool accepts_touch = false;                  ///< accepts the touch (permission to palpate) whenever it is offered
  double seconds = 0.0;                        ///< run time of the haptic loop; 0: until a signal
  program::Patience patience;                  ///< time limit for the server's first image
  Realtime realtime = Realtime::Prefer;
  std::filesystem::path control;                      ///< path of the socket for operators' commands; empty: no socket
  bool control_is_asked_for = false;                  ///< the user named the socket: without it, run() fails
  std::filesystem::path state_folder;                 ///< folder for the files of the flight recorder
  std::optional<StaticPatient> model = std::nullopt;  ///< the hand touches this model instead of a server's surface
};

/// The station: a link to the server, the surface thread and the haptic thread, which exchange data without waiting for
/// each other (LatestValue, SpscRing). run() turns the calling thread into the network thread and returns when the time
/// is up, an operator ends the station, or the scene was read again and accepted.
class Station {
 public:
  /// `io`: the network thread's io_context; run() runs it, and it must outlive the station. `trace`: the scene's
  /// recorded hand movement, if it has one. `rig`: a connected rig; when empty, the scene's simulated rig is used.
  Station(boost::asio::io_context& io, StationSignals& signals, const StationOptions& options,
          const scenes::Scene& scene, const surface::SurfaceSettings& surface, std::optional<tracking::HandTrace> trace,
          ConnectedRig rig = {});
  ~Station();
  Station(const Station&) = delete;
  Station& operator=(const Station&) = delete;

  /// Runs the station to its end. Error: why it gave up, such as no depth image in time or no real-time scheduling.
  [[nodiscard]] Result<void> run();

 private:
  void on_message(const wire::Message& message);
  void on_camera_info(const wire::Message& message);
  void on_depth(const wire::Message& message);
  void on_dropped(const Error& error);
  void on_unreadable(const wire::Message& message);
  void on_viewer_hand(const wire::Message& message);
  void on_link(wire::LinkState state, const std::string& detail);
  void on_datagrams(const std::string& detail);
  void say_link(const std::string& text, wire::LinkState state);
  void on_surface(const msg::SurfaceReport& report);
  void say_depth(const msg::SurfaceReport& report);
  void start_inside_thread();
  void publish_inside();
  void look_inside();
  void touch_model();
  void start_surface_thread(const surface::SurfaceSettings& surface);
  [[nodiscard]] decltype(SurfaceWorker::Handlers::on_image) image_handler();
  void start_haptic_thread();
  void end_threads();
  void every_10_ms();
  void every_second();
  void look_at_clock();
  void say_clock_step();
  void say_device_refusals();
  void publish_totals();
  void look_at_signals();
  void stop(const std::string& reason);
  void give_up(const Error& error);
  void lose_patience();
  void publish(wire::Message message);
  [[nodiscard]] SessionTime now() const noexcept { return link_.clock().now(); }

  // The members' initialisers read only the constructor's parameters, so the order of members is free. The destructor
  // ends the threads before it destroys any member.
  StationOptions options_;
  scenes::Scene scene_;
  std::optional<tracking::HandTrace> trace_;
  boost::asio::io_context& io_;  // of the network thread
  StationSignals& signals_;
  boost::asio::steady_timer fast_timer_;
  boost::asio::steady_timer slow_timer_;
  wire::ClientLink link_;
  HandOver hand_over_;
  std::optional<Intrinsics> camera_;
  std::optional<Error> failure_;
  std::set<std::string> said_of_trying_;
  std::string depth_;  // last logged description: depth lossless, or its error bound
  double clock_error_s_ = std::numeric_limits<double>::infinity();  // bound on the error of the session clock
  Nanoseconds clock_stepped_{0};                                    // sum of the session clock's steps that were logged
  ImageAges ages_;
  DroppedMessages dropped_;
  std::function<std::optional<Error>()> device_refusals_;  // see ConnectedRig; refers to the device in rig_
  std::optional<std::chrono::steady_clock::time_point> refusals_said_;

  const bool in_tick_;  // the surface is evaluated on the haptic thread, without a collision thread
  LatestValue<loop::TouchableSurface> slow_surfaces_;             // surface thread to collision thread, if it exists
  LatestValue<loop::TouchableSurface> surfaces_;                  // surface, collision or network to haptic thread
  LatestValue<Point<HapticBase>> device_to_surface_;              // haptic thread to surface thread
  TickRing ticks_;                                                // haptic thread to network thread
  loop::HapticLoop loop_;                                         // owner: haptic thread, once it runs
  std::unique_ptr<ports::Rig> rig_;                               // owner: haptic thread, once it runs
  std::optional<tracking::ViewerHandTracker::Taken> hand_taken_;  // last logged result of its hear()
  tracking::ViewerHandTracker*
      viewer_hand_tracker_;  // the tracker in rig_, or nullptr; its hear() is called on the network thread
  std::optional<Transform<HapticBase, DepthCamera>> haptic_from_camera_;  // nullopt before the first image
  std::optional<HapticThread> haptic_;
  TelemetryPublisher telemetry_;
  FaultMonitor faults_;
  std::optional<InsideThread> inside_thread_;         // only if the scene has layers or a probe
  std::optional<msg::InnerStructures> inside_;        // the surfaces of the layers, once inside_thread_ has made them
  loop::ObjectPlacements objects_{};                  // displacements in the newest StationCompensation
  std::chrono::steady_clock::time_point next_image_;  // when the next ultrasound image is due
  std::optional<CollisionThread> collision_;
  std::optional<SurfaceWorker> worker_;
  std::chrono::steady_clock::time_point started_;
  std::chrono::steady_clock::time_point ticking_since_;
  std::vector<msg::EffectCost> costs_;
  bool realtime_granted_ = false;  // both real-time priority and locked memory
  bool stopped_ = false;           // checked by timer handlers: a timer that has expired cannot be cancelled
};

}  // namespace telepalp::station
