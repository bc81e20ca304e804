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

#include "proto/wire/key_frame_request.h"
#include "proto/wire/message.h"
#include "proto/wire/send_queue.h"
#include "server/plan/grade.h"

namespace telepalp::hub {

using SubscriberId = std::uint64_t;

/// Distributes each published message to the subscribers of its topic. It does not encode or copy: all subscribers
/// share one payload. A slow subscriber loses its own oldest messages, topic by topic; other subscribers are not
/// affected. A new subscriber gets the last message of each latched topic (wire::Topic). A predicted frame goes only to
/// subscribers that have its reference frame. A subscriber that missed a frame gets no message of that topic until the
/// next key frame, which the hub requests from the publisher. Camera images may come in several grades (plan::Grade),
/// of which each subscriber gets one. Owner: the server's network thread; no locks, no sockets, no clock.
class Hub {
 public:
  /// Limit of the bytes that wait for TCP on all topics of Lane::Others, over all subscribers. A payload that is
  /// queued for several subscribers counts once for each.
  static constexpr std::size_t kMaxWaitingBytes = std::size_t{64} << 20;

  /// Adds a subscriber. `wake` is called when the subscriber's empty queue gets a message, and at each message while
  /// send_by_datagram() is on. `sender`: the number that marks the messages that this peer publishes; 0: it publishes
  /// none.
  SubscriberId join(std::string name, std::string address, std::function<void()> wake, std::uint32_t sender = 0);
  /// Adds `way`, by which the subscriber's images go, to its address in /server/stats; it replaces the last one.
  void note_way(SubscriberId id, std::string_view way);
  void leave(SubscriberId subscriber);

  /// Replaces the subscriber's topics. A name ending in '*' is a prefix, which covers all topics but those that are
  /// only_by_name. Unknown names are kept, because their
  /// publisher may come later.
  void subscribe(SubscriberId subscriber, const std::vector<std::string>& topics);

  /// Gives `message` the topic's next sequence number and offers it to the subscribers, which see dropped messages as
  /// gaps. A message that has a number already comes through a connection: if it is predicted and the number before it
  /// is missing, its reference frame is lost, and it is offered to nobody.
  /// `grade`: of a camera image, which goes only to the subscribers that get this grade. Full for other topics.
  void publish(wire::Message message, plan::Grade grade = plan::Grade::Full);
  /// From now on, the subscriber gets the camera images of `grade`; before the first call, those of Full. The sequence
  /// numbers that it sees go on without a gap. The first image of the new grade that it gets is a key frame.
  void give(SubscriberId subscriber, plan::Grade grade);
  /// Notes for subscriber_counts() that the subscriber shows images to a person.
  void note_shows_images(SubscriberId subscriber);
  /// From now on, numbered messages keep their numbers: those of the server upstream, of which this one is an edge.
  void keep_numbers() noexcept { keeps_numbers_ = true; }

  /// A subscriber requests a key frame: it could not decode the message of `topic` published at `undecodable`.
  void request_key_frame(SubscriberId subscriber, const wire::Topic& topic, SessionTime undecodable);

  /// Sets the function that requests a key frame of a topic from its publisher. After a call for a topic, it is not
  /// called again for this topic until a key frame comes. `topic` has predicted messages.
  void on_key_frame_request(std::function<void(std::string_view topic)> handler) {
    key_frame_requested_ = std::move(handler);
  }

  /// Takes the next message from the subscriber's queue. Lane::First goes first; while both wait, the other topics get
  /// a quarter of its bytes (SendQueue::pop()). nullopt when the queue is empty.
  [[nodiscard]] std::optional<wire::Message> next(SubscriberId subscriber);

  /// While `on`, datagrams carry the deadline topics (camera images, station state, viewer's hand: a late message is of
  /// no use) to the subscriber: next_for_datagram() takes them, and next() the other topics. A change drops the queued
  /// messages of the deadline topics, and the next message of a topic with predicted frames is a key frame.
  void send_by_datagram(SubscriberId subscriber, bool on);
  /// Takes the newest key frame of a deadline topic, of those `wanted`, else its oldest message; drops older ones
  /// (SendQueue::pop_newest()).
  [[nodiscard]] std::optional<wire::Message> next_for_datagram(SubscriberId subscriber, wire::Wanted wanted);
  /// Keeps, for subscriber_counts(), what other flows leave of the subscriber's line.
  void note_share(SubscriberId subscriber, std::optional<double> share_B_per_s);
  /// The subscriber cannot decode the predicted frames of `topic`: the next one that it gets is a key frame.
  void restart_group(SubscriberId subscriber, const wire::Topic& topic);

  /// True when a subscriber not named `other_than` has subscribed to `topic` by its full name, not by a prefix.
  [[nodiscard]] bool is_taken(std::string_view topic, std::string_view other_than) const noexcept;

  /// True when at least one subscriber has subscribed to `topic`.
  [[nodiscard]] bool is_wanted(std::string_view topic) const;
  /// True when at least one subscriber that gets `grade` has subscribed to `topic`.
  [[nodiscard]] bool is_wanted(std::string_view topic, plan::Grade grade) const;

  /// True when a subscriber to `topic` has not been offered a message of it yet.
  [[nodiscard]] bool is_missed(std::string_view topic) const;

  /// Queued bytes, counted as for kMaxWaitingBytes.
  [[nodiscard]] std::size_t waiting_bytes() const noexcept { return waiting_bytes_; }

  struct TopicCount {
    std::uint64_t published = 0;  ///< messages published; for one subscriber: messages offered to it
    std::uint64_t sent = 0;       ///< taken from the queue; for one subscriber, published = sent + dropped + queued
    std::uint64_t dropped = 0;    ///< dropped from a queue, left in it by a leaving subscriber, or not decodable
    std::uint64_t bytes = 0;      ///< published bytes; for one subscriber: bytes sent to it
  };
  using TopicCounts = std::map<std::string_view, TopicCount>;  // keys point to the names in wire::kTopics
  struct SubscriberCount {
    std::string name;
    std::string address;
    std::uint32_t sender = 0;
    bool by_datagram = false;               ///< datagrams carry the deadline topics, TCP the others
    std::optional<double> share_B_per_s{};  ///< what other flows leave of its line; nullopt: none was noticed
    plan::Grade grade = plan::Grade::Full;
    bool shows_images = false;      ///< to a person, so that it may get a grade other than Full
    std::uint64_t images = 0;       ///< decodable camera images that were offered to it
    std::uint64_t crowded_out = 0;  ///< of these, images that were dropped because its line had no room
    TopicCounts topics;
    [[nodiscard]] std::uint64_t sent() const noexcept;
    [[nodiscard]] std::uint64_t dropped() const noexcept;
  };
  [[nodiscard]] const TopicCounts& topic_counts() const noexcept { return topics_; }
  [[nodiscard]] std::vector<SubscriberCount> subscriber_counts() const;
  /// True when the subscriber has subscribed to `topic`.
  [[nodiscard]] bool takes(SubscriberId subscriber, std::string_view topic) const;
  [[nodiscard]] std::vector<SubscriberId> subscribers() const;
  /// The counts of one of subscribers().
  [[nodiscard]] const SubscriberCount& count_of(SubscriberId subscriber) const {
    return subscribers_.at(subscriber).count;
  }
  /// The subscriber's counts of `topic`; zeros if it is unknown.
  [[nodiscard]] TopicCount topic_count(SubscriberId subscriber, std::string_view topic) const;

 private:
  /// The messages of one topic in one grade.
  struct Stream {
    std::uint64_t published = 0;
    wire::KeyFrameState keys;
  };
  /// How far a subscriber is in a topic. Sequence numbers are those that the subscriber sees.
  struct Position {
    wire::GroupPosition group;
    std::uint64_t offered = 0;  ///< number of the newest message that was offered to it
    std::int64_t shift = 0;     ///< added to a message's number in its stream, so that a new grade makes no gap
    bool is_new_grade = false;  ///< true until the first message of a new grade, which sets `shift`
  };
  struct Subscriber {
    SubscriberCount count;
    std::vector<std::string> topics;
    wire::SendQueue queue;
    std::map<std::string_view, Position> positions;  // by topic
    std::function<void()> wake;
  };
  void drop(SubscriberCount& subscriber, const wire::Message& message);
  void crowd_out(SubscriberCount& subscriber, const wire::Message& message);
  void count_sent(Subscriber& subscriber, const wire::Message& message);
  void offer(Subscriber& subscriber, wire::Message message);
  std::vector<wire::Message> put_in_queue(Subscriber& subscriber, const wire::Message& message);
  void drop_beyond_the_bound();
  template <class Matches>
  void remove_waiting(Subscriber& subscriber, Matches matches);  ///< counted as dropped
  void start_anew(Subscriber& subscriber, const wire::Topic& topic);
  void forget_references(const wire::Topic& topic, plan::Grade grade);
  Stream& stream_for(const Subscriber& subscriber, const wire::Topic& topic);
  void forget_unwanted(Subscriber& subscriber);
  void request_from_publisher(const Subscriber& subscriber, const wire::Topic& topic);

  std::map<SubscriberId, Subscriber> subscribers_;
  TopicCounts topics_;
  std::map<std::string_view, wire::Message> latched_;
  std::map<std::pair<std::string_view, plan::Grade>, Stream> streams_;
  std::function<void(std::string_view)> key_frame_requested_;
  bool keeps_numbers_ = false;
  SubscriberId last_id_ = 0;
  std::size_t waiting_bytes_ = 0;
};

}  // namespace telepalp::hub
