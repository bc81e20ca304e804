#pragma once

#include <optional>
#include <string>

#include "haptic_station/station/faults/control_socket.h"
#include "proto/wire/client/client_link.h"

namespace telepalp::station {

/// Carries out an operator's commands that offer, withdraw or accept the touch (the permission to palpate as a
/// station), and sends the operator the server's answer. Owner: network thread.
class HandOver {
 public:
  explicit HandOver(wire::ClientLink& link) : link_(link) {}

  /// Carries out `offer NAME`, `withdraw` and `accept`, and then replies. Returns false for any other command.
  bool on_command(const std::string& command, const ControlSocket::Reply& reply);
  /// Logs the server's answer `outcome` and sends it to the operator. `done`: false if the server refused or was lost.
  void on_answer(bool done, const std::string& outcome);

 private:
  void ask(const std::string& to, const ControlSocket::Reply& reply);

  wire::ClientLink& link_;
  std::optional<ControlSocket::Reply> waiting_;  // to the operator who waits for the server's answer
};

/// `telepalp-station hand-over`: sends an offer, withdraw or accept command to the running station. `argv[0]` is
/// "hand-over". Returns the program's exit code.
int hand_over_command(int argc, const char* const* argv);

}  // namespace telepalp::station
