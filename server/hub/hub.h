#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "proto/wire/message.h"
#include "proto/wire/send_queue.h"
#include "server/hub/key_frame_state.h"

namespace telepalp::server {

using SubscriberId = std::uint64_t;

/// Takes every message published at this server and hands it to whoever asked for its topic. Encodes nothing and
/// copies nothing: all subscribers share one payload. What waits of the topics outside /camera/... is bounded for each
/// subscriber (SendQueue) and for all together (kMaxWaitingBytes). A subscriber that does not keep up loses its own
/// oldest messages, topic by topic, and nobody else notices. Owner: the server's network thread; no locks, no sockets,
/// no clock. A new subscriber is given the last message of each latched topic (/camera/info,
/// /camera/color/info, /camera/status, /viewer/hand_holder).
/// A message that does not stand alone goes only to who has the one before it; whoever lost its place is given nothing
/// of the topic until a message stands alone again, and the publisher is asked for one.
class Hub {
 public:
  /// Of the topics outside /camera/..., over all subscribers; a payload that waits for several counts once for each.
  static constexpr std::size_t kMaxWaitingBytes = std::size_t{64} << 20;

  /// `wake` is called, on the publishing call, when the subscriber's queue stops being empty.
  /// `sender`: the number of this peer in what it publishes; 0: it publishes nothing.
  SubscriberId join(std::string name, std::string address, std::function<void()> wake, std::uint32_t sender = 0);
  void leave(SubscriberId subscriber);

  /// Replaces what the subscriber listens to. A name ending in '*' is a prefix; unknown names are kept, for a
  /// publisher may come later.
  void subscribe(SubscriberId subscriber, const std::vector<std::string>& topics);

  /// Numbers `message` within its topic, so that a subscriber sees from the gap what it was not sent.
  void publish(wire::Message message);

  /// The subscriber could not read what was published on `topic` at `unreadable`, for want of the one before it.
  void want_key(SubscriberId subscriber, const wire::Topic& topic, SessionTime unreadable);

  /// Is called when somebody waits for a message of a topic that stands alone, once until one comes.
  void on_key_wanted(std::function<void(std::string_view topic)> handler) { key_wanted_ = std::move(handler); }

  /// The next message for this subscriber, oldest first; nullopt when none waits.
  [[nodiscard]] std::optional<wire::Message> next(SubscriberId subscriber);

  /// True when a subscriber asked for exactly `topic`, not by a prefix, and is not named `other_than`.
  [[nodiscard]] bool is_taken(std::string_view topic, std::string_view other_than) const noexcept;

  /// Whether a subscriber listens to `topic`.
  [[nodiscard]] bool is_wanted(std::string_view topic) const;

  /// Bytes that wait, counted as for kMaxWaitingBytes.
  [[nodiscard]] std::size_t waiting_bytes() const noexcept { return waiting_bytes_; }

  struct TopicCount {
    std::uint64_t published = 0;  ///< of a subscriber: offered to it
    std::uint64_t sent = 0;       ///< taken by a subscriber with next(); published = sent + dropped + still waiting
    std::uint64_t dropped = 0;    ///< overtaken in a subscriber's queue, waiting there when it left, or of no use to it
    std::uint64_t bytes = 0;      ///< published; of a subscriber: sent to it
  };
  using TopicCounts = std::map<std::string_view, TopicCount>;  // keys live in wire::kTopics
  struct SubscriberCount {
    std::string name;
    std::string address;
    std::uint32_t sender = 0;
    TopicCounts topics;
    [[nodiscard]] std::uint64_t sent() const noexcept;
    [[nodiscard]] std::uint64_t dropped() const noexcept;
  };
  [[nodiscard]] const TopicCounts& topic_counts() const noexcept { return topics_; }
  [[nodiscard]] std::vector<SubscriberCount> subscriber_counts() const;

 private:
  struct Subscriber {
    SubscriberCount count;
    std::vector<std::string> topics;
    wire::SendQueue queue;
    std::map<std::string_view, GroupPosition> places;  // by topic
    std::function<void()> wake;
  };
  void drop(SubscriberCount& subscriber, const wire::Message& message);
  void offer(Subscriber& subscriber, const wire::Message& message);
  std::vector<wire::Message> put_in_queue(Subscriber& subscriber, const wire::Message& message);
  void drop_beyond_the_bound();
  template <class Matches>
  void remove_waiting(Subscriber& subscriber, Matches matches);  ///< counted as dropped
  void forget_unwanted(Subscriber& subscriber);
  void ask_for_key(std::string_view topic);

  std::map<SubscriberId, Subscriber> subscribers_;
  TopicCounts topics_;
  std::map<std::string_view, wire::Message> latched_;
  std::map<std::string_view, KeyFrameState> wishes_;  // by topic
  std::function<void(std::string_view)> key_wanted_;
  SubscriberId last_id_ = 0;
  std::size_t waiting_bytes_ = 0;
};

}  // namespace telepalp::server
