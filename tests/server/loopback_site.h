#pragma once

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/write.hpp>
#include <memory>
#include <string>
#include <vector>

#include "messages/station.pb.h"
#include "proto/wire/client/client_link.h"
#include "server/hub/peer_listener.h"

namespace telepalp::server {

using namespace std::chrono_literals;

/// A server and its clients on one io_context, all on this thread, over real sockets on loopback.
struct Site {
  boost::asio::io_context io;
  hub::Hub hub;
  wire::SessionClock clock = wire::SessionClock::anchored_to_wall_clock();
  std::vector<std::string> notes;  // the server's log lines
  std::unique_ptr<hub::PeerListener> listener = listen(0);

  std::unique_ptr<hub::PeerListener> listen(std::uint16_t port, hub::PlaceLimits places = {},
                                            hub::IdleLimits idle = {}) {
    auto made = hub::PeerListener::listen(
        io, hub, clock, {.port = port, .places = places, .idle = idle, .on_note = [this](const std::string& note) {
                           notes.push_back(note);
                         }});
    EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
    return std::move(made).value();
  }

  /// Address of the peer `name`, from the log lines.
  std::string address_of(const std::string& name) const {
    for (const std::string& note : notes)
      if (note.starts_with(name + " (") && note.find("joined from ") != std::string::npos)
        return note.substr(note.find("joined from ") + 12);
    return "nowhere";
  }

  /// Runs the network until `done()` is true, at most `patience`. Returns the last result of `done()`.
  template <class Done>
  bool run_until(Done done, std::chrono::milliseconds patience = 5s) {
    const auto limit = std::chrono::steady_clock::now() + patience;
    while (!done() && std::chrono::steady_clock::now() < limit) io.run_one_for(5ms);
    return done();
  }
};

struct Client {
  std::vector<wire::Message> messages;
  std::vector<std::string> states;
  std::vector<std::string> details;
  wire::ClientLink link;

  Client(Site& site, std::vector<std::string> topics, std::string name = "test", std::uint16_t port = 0,
         std::string role = "viewer", bool datagrams = false)
      : link(site.io,
             {.port = port != 0 ? port : site.listener->port(),
              .name = std::move(name),
              .role = std::move(role),
              .subscribes = std::move(topics),
              .publishes = {wire::kStationState, wire::kStationEvents},
              .datagrams = datagrams},
             {.on_message = [this](const wire::Message& message) { messages.push_back(message); },
              .on_state =
                  [this](wire::LinkState state, const std::string& detail) {
                    states.emplace_back(wire::name(state));
                    details.push_back(detail);
                  }}) {
    link.start();
  }
  bool connected() const { return link.state() == wire::LinkState::Connected; }
};

inline wire::Message message(const wire::Topic& topic, const std::string& payload) {
  return {topic, session_time(1), std::make_shared<const std::string>(payload), 0, true};
}

inline wire::Message station_state(std::int64_t stamp_ns) {
  msg::StationState state;
  state.set_stamp_ns(static_cast<std::uint64_t>(stamp_ns));
  return wire::make_message(wire::kStationState, session_time(stamp_ns), state);
}

/// The bytes of a frame, for peers that do not use Connection.
inline std::string frame_bytes(const wire::FrameHeader& header, const std::string& payload) {
  const wire::HeaderBytes bytes = wire::encode_header(header);
  return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()) + payload;
}
inline std::string control_frame(const msg::Control& control) {
  const std::string payload = control.SerializeAsString();
  return frame_bytes({.payload_bytes = static_cast<std::uint32_t>(payload.size())}, payload);
}
inline std::string data_frame(std::uint32_t channel, const std::string& payload) {
  return frame_bytes(
      {.payload_bytes = static_cast<std::uint32_t>(payload.size()), .kind = wire::FrameKind::Data, .channel = channel},
      payload);
}

}  // namespace telepalp::server
