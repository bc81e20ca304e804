#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "haptic_station/core/window/window_requests.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/faults/fault_monitor.h"
#include "haptic_station/station/parts/core_threads.h"
#include "haptic_station/station/parts/depth_choice.h"
#include "haptic_station/station/parts/image_log.h"
#include "haptic_station/station/parts/inside_view.h"
#include "haptic_station/station/parts/station_link.h"
#include "haptic_station/station/parts/viewer_hand_input.h"
#include "haptic_station/station/rigs/rig_choice.h"
#include "haptic_station/station/rigs/static_patient.h"
#include "haptic_station/station/signals/station_signals.h"
#include "haptic_station/station/telemetry/stiffness_notice.h"
#include "haptic_station/station/telemetry/telemetry_publisher.h"
#include "proto/wire/client/client_link.h"
#include "support/program/patience.h"

namespace telepalp::station {

/// Options of the command line.
struct StationOptions {
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;
  std::string site{};  ///< site that is reached through the meeting point `host`; empty: `host` is the server
  std::shared_ptr<const keys::KeyFile> key{};  ///< null: the server is on this machine
  bool accepts_touch = false;                  ///< accepts the touch (permission to palpate) whenever it is offered
  double seconds = 0.0;                        ///< run time of the haptic loop; 0: until a signal
  program::Patience patience;                  ///< time limit for the server's first image
  Realtime realtime = Realtime::Prefer;
  std::filesystem::path control;       ///< path of the socket for operators' commands; empty: no socket
  bool control_is_asked_for = false;   ///< the user named the socket: without it, run() fails
  std::filesystem::path state_folder;  ///< folder for the files of the flight recorder
  bool asks_window = false;            ///< takes depth that is exact only around the hand (/camera/depth/window)
  std::optional<StaticPatient> model = std::nullopt;  ///< the hand touches this model instead of a server's surface
  JournalThread* journal = nullptr;  ///< keeps all that the core is given; outlives the station; nullptr: none
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
  /// A timer that has expired cannot be cancelled, so the handlers of both check Progress::stopped.
  struct Timers {
    explicit Timers(boost::asio::io_context& io) : every_10_ms(io), every_second(io) {}
    boost::asio::steady_timer every_10_ms;
    boost::asio::steady_timer every_second;
  };
  /// What the first images have shown.
  struct Seen {
    std::optional<Intrinsics> camera;
    std::optional<Transform<HapticBase, DepthCamera>> haptic_from_camera;
  };
  struct Progress {
    std::chrono::steady_clock::time_point started;
    std::chrono::steady_clock::time_point ticking_since;
    bool stopped = false;
    std::optional<Error> failure;
  };

  /// What the device's protocol has refused, see ConnectedRig; `newest` refers to the device in core_.
  struct DeviceRefusals {
    std::function<std::optional<Error>()> newest;
    std::optional<std::chrono::steady_clock::time_point> said;
  };

  void on_message(const wire::Message& message);
  void on_camera_status(const wire::Message& message);
  void on_camera_info(const wire::Message& message);
  void on_depth(const wire::Message& message);
  void choose_depth(const wire::Message& message);
  void subscribe();
  void on_dropped(const Error& error);
  void on_unreadable(const wire::Message& message);
  void on_viewer_hand(const wire::Message& message);
  void on_link(wire::LinkState state, const std::string& detail);
  void on_datagrams(const std::string& detail);
  void on_surface(const msg::SurfaceReport& report);
  void publish_inside();
  void ask_window(const loop::TickSample& tick);
  void touch_model();
  void start_surface_thread(const surface::SurfaceSettings& surface);
  void start_haptic_thread();
  void start_inside_view();
  void end_threads();
  void every_10_ms();
  void every_second();
  void serve_haptic_thread(HapticThread& haptic);
  void say_device_refusals();
  void look_at_clock();
  void publish_totals();
  void look_at_signals();
  void stop(const std::string& reason);
  void give_up(const Error& error);
  void lose_patience();
  [[nodiscard]] SessionTime now() const noexcept { return link_.now(); }

  StationOptions options_;
  scenes::Scene scene_;
  boost::asio::io_context& io_;  // of the network thread
  StationSignals& signals_;
  Timers timers_;
  DepthChoice depth_choice_;
  std::string camera_detail_;  // newest CaptureStatus::detail
  StationLink link_;
  CoreThreads core_;
  TelemetryPublisher telemetry_;
  FaultMonitor faults_;
  InsideView inside_;
  ViewerHandInput viewer_hand_;
  DeviceRefusals refusals_;
  StiffnessNotice stiffness_notice_;
  core::WindowRequests window_requests_;
  ImageLog images_;
  Seen seen_;
  Progress progress_;
};

}  // namespace telepalp::station
