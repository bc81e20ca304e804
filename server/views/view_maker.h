#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/thread_pool.hpp>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "codec/depth_stream.h"
#include "messages/camera.pb.h"
#include "proto/words/result.h"
#include "proto/words/rgbd_frame.h"
#include "server/hub/hub.h"

namespace telepalp::views {

/// Makes the messages of kViewTopics from the messages of the hub `source` and publishes them at the hub `views`. It
/// subscribes to `source` only while `views` has a subscriber of a view topic. A separate thread decodes depth, one
/// image at a time; the hub drops images that arrive meanwhile, so the network thread never waits. Owner: the network
/// thread.
class ViewMaker {
 public:
  ViewMaker(boost::asio::io_context& io, hub::Hub& source, hub::Hub& views);
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
  struct Made {
    bool readable = false;
    std::vector<wire::Message> messages;
  };
  [[nodiscard]] std::vector<std::string> topics_needed() const;
  void pull();
  void take(const wire::Message& message);
  void take_camera(const wire::Message& message);
  void take_station(const wire::Message& message);
  void take_ultrasound(const wire::Message& message);
  void decode(const wire::Message& message);
  void on_made(const wire::Message& depth, Made made);
  [[nodiscard]] Made make(const wire::Message& message, const std::optional<Intrinsics>& camera, WantedViews wanted);

  boost::asio::io_context& io_;
  hub::Hub& source_;
  hub::Hub& views_;
  hub::SubscriberId subscriber_ = 0;  // 0: `views` has no subscriber of a view topic
  std::vector<std::string> topics_;
  std::optional<Intrinsics> camera_;
  bool decoding_ = false;
  std::uint64_t decoded_ = 0;
  codec::DepthDecoder decoder_;                                             // owner: the pool's one thread
  std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);  // posted results hold weak_ptrs to it
  boost::asio::thread_pool pool_{1};
};

}  // namespace telepalp::views
