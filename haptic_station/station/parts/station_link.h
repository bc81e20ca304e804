#pragma once

#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "haptic_station/station/commands/hand_over.h"
#include "proto/wire/client/client_link.h"

namespace telepalp::station {

/// The station's link to the server, with what an operator is told of it: its states, the error of the session clock
/// and the clock's steps. Owner: network thread; only now() may be called on other threads.
class StationLink {
 public:
  /// `own_clock`: the station touches a model, whose time stamps are this computer's own.
  StationLink(boost::asio::io_context& io, wire::ClientLink::Options options, wire::ClientLink::Handlers handlers,
              bool own_clock);

  void start() { link_.start(); }
  void stop(const std::string& reason) { link_.stop(reason); }
  void publish(wire::Message message) { (void)link_.publish(std::move(message)); }
  void subscribe(std::vector<std::string> topics) { link_.subscribe(std::move(topics)); }
  void request_key_frame(const wire::Message& unreadable) { link_.request_key_frame(unreadable); }
  [[nodiscard]] SessionTime now() const noexcept { return link_.clock().now(); }
  [[nodiscard]] Nanoseconds clock_offset() const noexcept { return link_.clock().offset(); }
  [[nodiscard]] const wire::ClientLink& client() const noexcept { return link_; }
  [[nodiscard]] HandOver& hand_over() noexcept { return hand_over_; }

  /// The line for the log about a state; nullopt: it was said before. Repeated attempts to connect are logged once
  /// until one succeeds.
  [[nodiscard]] std::optional<std::string> line_of(wire::LinkState state, const std::string& detail);
  /// Reads the bound on the clock's error again.
  void look_at_clock() noexcept;
  [[nodiscard]] double clock_error_s() const noexcept { return clock_error_s_; }  ///< infinite: not known
  /// What an operator is told when the session clock has stepped since the last call, else nullopt. It may step when a
  /// server restarts, by as much as the wall clock of the server's computer was changed.
  [[nodiscard]] std::optional<std::string> clock_step();

 private:
  const bool own_clock_;
  wire::ClientLink link_;
  HandOver hand_over_;
  std::set<std::string> said_of_trying_;
  double clock_error_s_ = std::numeric_limits<double>::infinity();
  Nanoseconds clock_stepped_{0};  // sum of the steps that were logged
};

}  // namespace telepalp::station
