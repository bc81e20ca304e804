#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::link_check {

/// How a TCP port answered.
struct Port {
  enum class Answer { NotTried, Opens, Refuses, Silent };

  std::uint16_t number = 0;
  Answer answer = Answer::NotTried;
  double opens_after_ms = 0.0;
};

/// Depth images that came while the check listened.
struct Images {
  double per_s = 0.0;
  double Mbit_per_s = 0.0;  ///< of all topics
  double age_p50_ms = 0.0;  ///< from publication to arrival
  double age_p95_ms = 0.0;
  std::uint64_t missed = 0;  ///< published by the server, and not arrived
};

/// What a check of the network between this computer and a server has found.
struct Findings {
  std::string server{};                  ///< as the user named it
  std::vector<std::string> addresses{};  ///< of the server's or meeting point's name; empty: the name is unknown
  Port link{};                           ///< the server's port, or the meeting point's
  Port web{};                            ///< the port of the server's web page
  std::string key{};                     ///< whose key this program showed; empty: none
  std::optional<Error> no_session{};     ///< why no session began; nullopt: one began
  double round_trip_ms = 0.0;            ///< of the quickest probe
  enum class Udp { Unknown, Arrives, Blocked, NotOffered } udp = Udp::Unknown;
  std::string way{};               ///< the datagrams' way and its price, to a site behind a meeting point; empty: none
  bool relayed = false;            ///< this way leads over a relay
  std::string notice{};            ///< what is wrong, without which the session goes on; empty: nothing
  std::optional<Images> images{};  ///< nullopt: the check did not listen
  std::string why_no_images{};     ///< why it did not listen
};

/// True if a session begins here and brings images, or would if the check had listened.
[[nodiscard]] bool carries_a_session(const Findings& found);

/// At most ten lines for a person: one for each finding, and last what it means and what would help.
[[nodiscard]] std::string in_lines(const Findings& found);

}  // namespace telepalp::link_check
