#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <functional>
#include <utility>

#include "proto/wire/message.h"
#include "server/playback/player/player_commands.h"

namespace telepalp::playback {

/// Hands a player's messages to the network thread. The player's thread alone calls it.
class NetworkOutlet {
 public:
  using OnMessage = std::function<void(wire::Message)>;
  using OnEnd = std::function<void()>;

  NetworkOutlet(boost::asio::io_context& network, OnMessage on_message, OnEnd on_end)
      : network_(network), on_message_(std::move(on_message)), on_end_(std::move(on_end)) {}

  /// Waits while the network thread has 64 messages that it has not handled. Drops the message if the player stops.
  void hand_over(wire::Message message, const PlayerCommands& commands);
  void end();

 private:
  boost::asio::io_context& network_;
  OnMessage on_message_;
  OnEnd on_end_;
  std::atomic<int> on_the_way_{0};  // messages posted and not yet handled
};

}  // namespace telepalp::playback
