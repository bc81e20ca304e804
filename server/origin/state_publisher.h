#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/time.h"
#include "server/hub/hub.h"
#include "server/origin/resources.h"

namespace telepalp::origin {

/// Publishes the states of resources as latched topics (kStateTopics), each when it has changed. It compares states
/// instead of being told of each change, because many of them count what other threads do. A state that nobody has
/// subscribed to is not looked at. Owner: the network thread.
class StatePublisher {
 public:
  /// The period of look().
  static constexpr std::chrono::milliseconds kLook{100};

  /// `now` reads the session clock. `hub` and `resources` must outlive this object.
  StatePublisher(hub::Hub& hub, const Resources& resources, std::function<SessionTime()> now)
      : hub_(hub), resources_(resources), now_(std::move(now)) {}

  /// Publishes the states that are due (StateTopic::every); call it each kLook.
  void look();
  /// Publishes all states at once, because a visitor's command may have changed any of them.
  void commanded();
  /// Call it before somebody subscribes to `topics`, so that the hub has their newest states.
  void expect_subscriber(const std::vector<std::string>& topics);

  /// When the newest state of the resource at `path` was published; 0: it was not.
  [[nodiscard]] SessionTime published_at(std::string_view path) const;

 private:
  struct Published {
    std::string state;
    SessionTime at{};
    std::chrono::steady_clock::time_point looked_at{};
  };
  void publish_if_changed(const StateTopic& row);

  hub::Hub& hub_;
  const Resources& resources_;
  std::function<SessionTime()> now_;
  std::map<std::string_view, Published> published_;  // by path
};

}  // namespace telepalp::origin
