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

namespace telepalp::server {

/// Makes kViewTopics from what `source` is given, and publishes them at `views`. It is a subscriber of `source` while
/// somebody at `views` wants one of them, and else costs nothing. Depth is decoded on a thread of its own, one image at
/// a time: what comes meanwhile is dropped by the hub, and the network thread goes on. Owner: the network thread.
class ViewMaker {
 public:
  ViewMaker(boost::asio::io_context& io, Hub& source, Hub& views);
  ~ViewMaker();
  ViewMaker(const ViewMaker&) = delete;
  ViewMaker& operator=(const ViewMaker&) = delete;

  /// Somebody at `views` subscribed, unsubscribed or left.
  void wishes_changed();

  /// Images decoded since the start.
  [[nodiscard]] std::uint64_t decoded() const noexcept { return decoded_; }

 private:
  struct Wishes {
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
  void decode(const wire::Message& message);
  void on_made(const wire::Message& depth, Made made);
  [[nodiscard]] Made make(const wire::Message& message, const std::optional<Intrinsics>& camera, Wishes wishes);

  boost::asio::io_context& io_;
  Hub& source_;
  Hub& views_;
  SubscriberId subscriber_ = 0;  // 0: nobody wants a view
  std::vector<std::string> topics_;
  std::optional<Intrinsics> camera_;
  bool decoding_ = false;
  std::uint64_t decoded_ = 0;
  codec::DepthDecoder decoder_;                                             // owner: the pool's one thread
  std::shared_ptr<const bool> alive_ = std::make_shared<const bool>(true);  // shared with posted results, as a sign
  boost::asio::thread_pool pool_{1};
};

}  // namespace telepalp::server
