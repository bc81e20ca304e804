#include "server/playback/player/network_outlet.h"

#include <boost/asio/post.hpp>
#include <chrono>
#include <thread>

namespace telepalp::playback {
namespace {

constexpr int kMostOnTheWay = 64;  // messages; reading pauses while the network thread has more unhandled ones

}  // namespace

void NetworkOutlet::hand_over(wire::Message message, const PlayerCommands& commands) {
  while (on_the_way_ >= kMostOnTheWay) {
    if (commands.is_stopping()) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  ++on_the_way_;
  boost::asio::post(network_, [this, message = std::move(message)]() mutable {
    --on_the_way_;
    on_message_(std::move(message));
  });
}

void NetworkOutlet::end() { boost::asio::post(network_, on_end_); }

}  // namespace telepalp::playback
