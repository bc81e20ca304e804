#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "proto/wire/session_clock.h"
#include "server/playback/impaired_path.h"
#include "server/playback/network_command.h"

namespace telepalp::playback {

/// Stands between a played session and its publication, and impairs its messages as a network would. While no
/// impairment is chosen, it passes them on at once. Owner: the network thread, whose timer it uses.
class SessionNetwork {
 public:
  /// `publish` takes each message that has arrived.
  SessionNetwork(boost::asio::io_context& io, wire::SessionClock clock, std::function<void(wire::Message)> publish);

  void send(wire::Message message);
  /// Carries out the JSON of a msg::NetworkCommand. Error: the command is wrong.
  [[nodiscard]] Result<void> apply(const std::string& json);
  [[nodiscard]] msg::NetworkState state() const;
  void stop();

 private:
  void pump();
  void wake_when_due();
  void arrive(wire::Message message);
  /// Sequence numbers of a topic with a deadline.
  struct Passing {
    std::uint64_t taken = 0;      ///< of the last message that send() took
    std::uint64_t published = 0;  ///< of the last message that was published; counted for predicted topics alone
  };
  [[nodiscard]] bool is_decodable(const wire::Message& message);
  void begin_counts();

  wire::SessionClock clock_;
  std::function<void(wire::Message)> publish_;
  boost::asio::steady_timer timer_;
  bool stopped_ = false;
  ChosenNetwork chosen_;
  std::optional<ImpairedPath> path_;             // set while the network impairs
  std::map<std::string_view, Passing> passing_;  // by topic

  // Counts since the last change of the settings are differences to these values.
  impaired::LinkStatistics packets_before_{};
  std::uint64_t late_before_ = 0;
  std::uint64_t images_before_ = 0;  // sequence of the last depth image taken before the change
  std::uint64_t images_arrived_ = 0;
  Nanoseconds image_delay_{0};
};

}  // namespace telepalp::playback
