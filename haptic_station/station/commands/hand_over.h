#pragma once

#include <optional>
#include <string>

#include "haptic_station/station/faults/control_socket.h"
#include "proto/wire/client_link.h"

namespace telepalp::station {

/// Carries out an operator's commands that hand the touch (the permission to palpate as a station) to another doctor,
/// and passes on the server's answer. Owner: network thread.
class HandOver {
 public:
  explicit HandOver(wire::ClientLink& link) : link_(link) {}

  /// Takes `offer NAME`, `withdraw` and `accept`. Returns false for another command.
  bool on_command(const std::string& command, const ControlSocket::Reply& reply);
  /// The server has answered with `outcome`. `done`: false if it refuses or the connection ends before its answer.
  void on_answer(bool done, const std::string& outcome);

 private:
  void ask(const std::string& to, const ControlSocket::Reply& reply);

  wire::ClientLink& link_;
  std::optional<ControlSocket::Reply> waiting_;  // the operator who waits for the server's answer
};

/// `telepalp-station hand-over`: sends an offer, withdraw or accept command to the running station. `argv[0]` is
/// "hand-over". Returns the program's exit code.
int hand_over_command(int argc, const char* const* argv);

}  // namespace telepalp::station
