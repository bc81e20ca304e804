#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "proto/wire/connection/connection.h"
#include "proto/wire/message.h"
#include "proto/words/time.h"

namespace telepalp::view {

/// Counts the messages that come from a server, topic by topic. Pure. Owner: one thread.
class LiveFigures {
 public:
  /// Counts `message`, which arrived at `now` (session time).
  void add(const wire::Message& message, SessionTime now);

  struct Topic {
    std::string name;
    double per_s = 0.0;
    double bytes_per_s = 0.0;
    double age_p50_ms = 0.0;  ///< from publishing to arrival
    double age_p99_ms = 0.0;
    std::uint64_t missed = 0;  ///< messages that were published and did not come
  };
  /// Figures of all messages counted so far, which arrived in `seconds`. `received`: the link's counts of received
  /// and missed messages, by topic.
  [[nodiscard]] std::vector<Topic> topics(double seconds,
                                          const std::map<std::string_view, wire::ReceivedCount>& received) const;

 private:
  struct Heard {
    std::uint64_t messages = 0;
    std::uint64_t bytes = 0;
    std::vector<float> ages_ms;  ///< of the first kMostAges messages
  };
  static constexpr std::size_t kMostAges = 100'000;
  std::map<std::string_view, Heard> topics_;
};

/// The figures as a table, or as JSON: {"seconds", "clock_uncertainty_ms", "topics": {NAME: {"per_s", …}}}.
[[nodiscard]] std::string in_table(const std::vector<LiveFigures::Topic>& topics, double clock_uncertainty_ms);
[[nodiscard]] std::string in_json(const std::vector<LiveFigures::Topic>& topics, double seconds,
                                  double clock_uncertainty_ms);

}  // namespace telepalp::view
