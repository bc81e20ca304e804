#pragma once

#include <map>
#include <string>
#include <utility>

#include "clients/record/facts/session_facts.h"
#include "messages/clock.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/mcap/reading/stream_reader.h"

namespace telepalp::record {

/// Collects the facts of a session's messages. The caller add()s all messages in the order of the file.
class SessionSurvey {
 public:
  void add(const wire::mcap::StoredMessage& message);
  /// Moves the collected facts into `facts`. The caller has set `facts.seconds`.
  void finish(SessionFacts& facts);

 private:
  struct TopicSoFar {
    SessionFacts::Topic topic;
    std::uint32_t last_sequence = 0;
    std::uint64_t newest_time = 0;
  };
  struct DropsOfPeer {
    std::uint32_t sender = 0;
    std::uint64_t first = 0;
    std::uint64_t last = 0;
  };
  struct ClockSoFar {
    msg::Clock first, last;
    std::int64_t largest_step_ns = 0;
    std::uint64_t count = 0;
  };
  void count(TopicSoFar& so_far, const wire::mcap::MessageRecord& record);
  void read(TopicSoFar& so_far, const wire::mcap::StoredMessage& stored);
  void note_sender(const std::string& payload);
  void note_server_stats(const std::string& payload);
  void note_station_stats(const std::string& payload);
  void note_clock(const std::string& payload);

  std::map<std::string, TopicSoFar> topics_;
  std::map<std::uint32_t, SessionFacts::Peer> senders_;
  std::map<std::pair<std::string, std::string>, DropsOfPeer> dropped_for_;  // by name and address
  ClockSoFar clock_;
};

}  // namespace telepalp::record
