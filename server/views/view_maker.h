#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/thread_pool.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "codec/depth_stream.h"
#include "messages/inside.pb.h"
#include "messages/station.pb.h"
#include "proto/words/repeats/repeated_errors.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"
#include "server/hub/hub.h"

namespace telepalp::views {

/// Makes the messages of kViewTopics from the messages of the hub `source` and publishes them at the hub `views`. It
/// subscribes to `source` only while `views` has a subscriber of a view topic. A separate thread decodes depth, one
/// image at a time; the hub drops images that arrive meanwhile, so the network thread never waits. The server publishes
/// colour a few milliseconds behind depth: for a cloud, depth waits until the colour of the same exposure arrives, but
/// at most 0.1 s. Owner: the network thread.
class ViewMaker {
 public:
  /// Takes a line about messages from which no view can be made; see RepeatedErrors for how often it is called.
  using Say = std::function<void(const std::string& line)>;

  ViewMaker(
      boost::asio::io_context& io, hub::Hub& source, hub::Hub& views, Say say = [](const std::string&) {});
  ~ViewMaker();
  ViewMaker(const ViewMaker&) = delete;
  ViewMaker& operator=(const ViewMaker&) = delete;

  /// Call it after a client of `views` has subscribed, unsubscribed or left.
  void subscriptions_changed();

  /// Number of images decoded since the start.
  [[nodiscard]] std::uint64_t decoded() const noexcept { return decoded_; }

 private:
  struct WantedViews {
    bool image = false;
    bool cloud = false;
  };
  /// A colour image that is still compressed.
  struct Color {
    std::int64_t captured_ns = 0;
    bool registered = true;
    std::string jpeg;
  };
  struct Job {
    wire::Message depth;
    WantedViews wanted;
    std::optional<Color> color;
    std::optional<Intrinsics> depth_camera;
    std::optional<Intrinsics> color_camera;
  };
  struct Made {
    std::optional<Error> unreadable{};  ///< why the depth image could not be decoded
    std::optional<Error> left_out{};    ///< why a view lacks a part, or is not made
    std::vector<wire::Message> messages{};
  };
  [[nodiscard]] std::vector<std::string> topics_needed() const;
  void pull();
  void take(const wire::Message& message);
  void take_camera(const wire::Message& message);
  void take_color_camera(const wire::Message& message);
  void take_station(const wire::Message& message);
  void take_ultrasound(const wire::Message& message);
  void take_inside(const wire::Message& message);
  void take_depth(const wire::Message& message);
  void take_color(const wire::Message& message);
  void stop_waiting();  ///< decodes the depth image that waits for its colour, if there is one
  void decode(const wire::Message& depth, std::int64_t captured_ns);
  void on_made(const wire::Message& depth, Made made);
  void on_unreadable(const wire::Message& depth, const Error& error);
  void say(const Error& error);
  void say_unreadable(const wire::Message& message);
  [[nodiscard]] Made make(const Job& job);
  void add_cloud(Made& made, const Job& job, RgbdFrame frame) const;

  boost::asio::io_context& io_;
  hub::Hub& source_;
  hub::Hub& views_;
  Say say_;
  RepeatedErrors errors_;
  std::optional<std::chrono::steady_clock::time_point> unreadable_since_;  // no depth image has been decoded since then
  hub::SubscriberId subscriber_ = 0;  // 0: `views` has no subscriber of a view topic
  std::vector<std::string> topics_;
  std::optional<Intrinsics> depth_camera_;
  std::optional<Intrinsics> color_camera_;
  std::optional<Color> color_;  // the newest
  struct Waiting {
    wire::Message depth;
    std::int64_t captured_ns = 0;
  };
  std::optional<Waiting> waiting_;  // for its colour
  boost::asio::steady_timer patience_;
  msg::InnerStructures inside_;
  msg::StationCompensation compensation_;
  bool decoding_ = false;
  std::uint64_t decoded_ = 0;
  codec::DepthDecoder decoder_;                                             // owner: the pool's one thread
  std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);  // posted results hold weak_ptrs to it
  boost::asio::thread_pool pool_{1};
};

}  // namespace telepalp::views
