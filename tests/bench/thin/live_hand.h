#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "codec/video.h"
#include "haptic_station/core/surface_stage.h"
#include "haptic_station/core/window/window_requests.h"
#include "proto/wire/client/client_link.h"

namespace telepalp::bench {

/// What arrived at a LiveHand. Times are since its start [s].
struct HandRecord {
  struct Touchable {
    double captured_s = 0.0;
    double at_s = 0.0;
    bool inside = false;  ///< the surface is exact where the hand was
  };
  std::vector<Touchable> surfaces;
  std::vector<double> color_s;    ///< when a colour image was decoded
  std::vector<std::string> said;  ///< the server's sentences of what is given up, each once when it came
  std::uint64_t unreadable = 0;   ///< depth and colour images that could not be decoded
};

/// Receives as a station with a doctor's picture does: it asks for exact depth around a hand that moves in a circle,
/// builds touchable surfaces, and decodes colour as video. Network and surfaces have a thread each, as in the station.
class LiveHand {
 public:
  /// `port`: of the server, or of an impaired link in front of it, on this machine.
  explicit LiveHand(std::uint16_t port);
  ~LiveHand();

  [[nodiscard]] double now_s() const;
  /// Ends both threads.
  [[nodiscard]] HandRecord end();

 private:
  void on_message(const wire::Message& message);
  void on_depth(const wire::Message& message);
  void on_color(const wire::Message& message);
  void ask_often();
  void make_surfaces();
  void look_at(const DepthImage& image);
  void keep(const core::SurfaceStage::Result& made);
  [[nodiscard]] Point<DepthCamera> hand_at(double at_s) const;

  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  boost::asio::io_context io_{1};
  boost::asio::steady_timer ask_timer_{io_};
  wire::ClientLink link_;
  core::WindowRequests requests_;  // owned by the network thread, as link_ and video_
  codec::ColorVideoDecoder video_;
  std::uint64_t color_number_ = 0;
  std::optional<Intrinsics> camera_;
  bool stopped_ = false;
  core::SurfaceStage stage_;  // owned by the surface thread, except admit()
  bool has_looked_ = false;
  std::mutex mutex_;  // guards the members below
  std::condition_variable came_;
  std::vector<core::ArrivedDepth> waiting_;
  std::optional<wire::Message> unreadable_;
  double distance_m_ = 1.0;  ///< of the skin in the middle of the image
  double newest_captured_s_ = 0.0;
  bool ended_ = false;
  HandRecord record_;
  std::thread network_, surfaces_;
};

}  // namespace telepalp::bench
