#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <filesystem>
#include <functional>
#include <future>
#include <string>

#include "haptic_station/station/control_socket.h"
#include "haptic_station/station/telemetry_publisher.h"
#include "proto/words/result.h"

namespace telepalp::station {

/// Where an operator and a fault meet: tells of it, keeps what led to it in a black box, and re-arms when asked, once
/// the cause is gone. Owner: network thread.
class FaultDesk {
 public:
  struct Handlers {
    std::function<SessionTime()> now;
    std::function<void()> rearm;  ///< asks the haptic thread to, which then tells by its ticks
  };

  /// `control`: of the socket that operators speak to; empty: there is none. `state_folder`: for black boxes.
  FaultDesk(boost::asio::io_context& io, TelemetryPublisher& telemetry, std::filesystem::path control,
            std::filesystem::path state_folder, std::string scene, Handlers handlers);

  [[nodiscard]] Result<void> listen();

  /// Tells of a fault at once; keeps what led to it when its letting go is in the black box too, or nothing more comes.
  void look(bool ending);

  void stop();

 private:
  void on_command(const std::string& command, const ControlSocket::Reply& reply);
  void rearm(const ControlSocket::Reply& reply);
  [[nodiscard]] bool is_faulted() const;
  [[nodiscard]] std::string how_to_rearm() const;

  TelemetryPublisher& telemetry_;
  std::filesystem::path control_;
  std::filesystem::path state_folder_;
  std::string scene_;
  Handlers handlers_;
  ControlSocket socket_;
  boost::asio::steady_timer rearm_timer_;
  std::future<Result<std::filesystem::path>> black_box_;  // being written
  bool stopped_ = false;                                  // a timer that has fired cannot be cancelled
};

}  // namespace telepalp::station
