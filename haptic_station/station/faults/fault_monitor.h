#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <filesystem>
#include <functional>
#include <future>
#include <string>

#include "haptic_station/station/faults/control_socket.h"
#include "haptic_station/station/faults/flight_recorder.h"
#include "haptic_station/station/telemetry/telemetry_publisher.h"
#include "proto/words/result.h"

namespace telepalp::station {

/// Detects faults among the ticks, announces them, writes the flight recorder to disk, and re-arms on an operator's
/// command once the cause is gone. Owner: network thread.
class FaultMonitor {
 public:
  struct Handlers {
    std::function<SessionTime()> now;
    std::function<void()> rearm;  ///< asks the haptic thread to re-arm; the next ticks show whether it did
    /// Handles each command that is not about faults; returns false for an unknown command.
    std::function<bool(const std::string& command, const ControlSocket::Reply& reply)> other_command{};
  };

  /// `control`: path of the socket for operators' commands; empty: no socket. `state_folder`: folder for the files of
  /// the flight recorder.
  FaultMonitor(boost::asio::io_context& io, TelemetryPublisher& telemetry, std::filesystem::path control,
               std::filesystem::path state_folder, std::string scene, Handlers handlers);

  /// Opens the socket for operators' commands. Without a socket, a fault ends only when the station is restarted.
  [[nodiscard]] Result<void> listen();

  /// Takes every tick, in order.
  void add(const loop::TickSample& sample) noexcept;

  /// Announces a new fault. Writes the flight recorder to disk on another thread, 0.5 s after the fault, so that the
  /// file shows how the force ended. If `ending` (the station stops): at once, and waits for the file.
  void look(bool ending);

  /// Re-arms after a fault for a person at another computer, `who`, and logs the outcome. Does nothing without a fault.
  void rearm_for(const std::string& who);

  void stop();

 private:
  /// Logs the path of the flight recorder's file once it is written. `wait`: waits for this.
  void say_when_written(bool wait);
  void on_command(const std::string& command, const ControlSocket::Reply& reply);
  void rearm(const ControlSocket::Reply& reply);
  [[nodiscard]] bool is_faulted() const;
  [[nodiscard]] std::string how_to_rearm() const;

  TelemetryPublisher& telemetry_;
  std::filesystem::path control_;
  std::filesystem::path state_folder_;
  std::string scene_;
  Handlers handlers_;
  FaultWatch watch_;
  loop::TickSample last_;
  bool has_ticked_ = false;
  ControlSocket socket_;
  boost::asio::steady_timer rearm_timer_;
  std::future<Result<std::filesystem::path>> flight_recorder_;  // while the file is written
  bool stopped_ = false;  // checked by handlers: a timer that has expired cannot be cancelled
};

}  // namespace telepalp::station
