#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::record {

/// Facts about a session file, found in one pass over it. Its texts come unchecked from the file: escape them before
/// printing.
struct SessionFacts {
  struct Topic {
    std::string name;
    std::string type;
    std::uint64_t messages = 0;
    std::uint64_t bytes = 0;            ///< sum of the payloads
    double rate_Hz = 0.0;               ///< mean over the whole session; 0: fewer than two messages
    double longest_gap_s = 0.0;         ///< between two messages
    std::uint64_t lost = 0;             ///< missing sequence numbers: lost between publisher and file
    std::uint64_t back_in_time = 0;     ///< messages with an earlier time than a message before them in the file
    std::uint64_t unreadable = 0;       ///< messages that do not parse as `type`
    bool is_ours = false;               ///< a topic of telepalp, with its type
    bool has_other_version = false;     ///< the type's definition differs from this program's
    bool begins_with_key_frame = true;  ///< false: its first messages cannot be decoded
  };
  /// A peer that published through the server, or read from it.
  struct Peer {
    std::uint32_t sender = 0;  ///< number in its messages; 0: it published nothing
    std::string name;          ///< from /server/stats; empty: not listed in /server/stats
    std::string address;
    std::uint64_t messages = 0;           ///< published by it, in the file
    std::uint64_t dropped_before_it = 0;  ///< messages that the server dropped for the peer, which read too slowly
    std::uint64_t dropped_by_it = 0;      ///< frames and ticks that the peer reported as dropped
  };
  /// The server's wall clock compared with its session clock.
  struct Clock {
    double drift_ppm = 0.0;        ///< of the wall clock against the session clock, over the whole file
    double largest_step_ms = 0.0;  ///< largest change of the clocks' difference between two messages of /clock
  };

  double seconds = 0.0;  ///< from the first message to the last
  std::uint64_t messages = 0;
  std::uint64_t chunks = 0;
  std::uint64_t bytes = 0;  ///< size of the file
  std::string program;      ///< program that wrote the file; empty: not stated
  std::string version;
  std::string commit;
  std::string source;         ///< the recorded server or file
  std::string recorded_by;    ///< for example "doctor anna"; empty: not stated
  std::string consent;        ///< the patient's consent, as the operator stated it; empty: not stated
  std::string voice_consent;  ///< the patient's consent to record speech; empty: not stated
  std::string depth;          ///< bound on the depth error, as text; empty: no depth
  std::map<std::string, std::string> recording;  ///< the recorder's notes: gaps, dropped messages, clock
  std::vector<std::string> repairs;              ///< each repair that led to this file, and what it lost, in words
  std::vector<std::string> attachments;
  std::vector<Topic> topics;  ///< sorted by name
  std::vector<Peer> peers;
  std::optional<Clock> clock;        ///< nullopt: fewer than two messages of /clock
  std::vector<std::string> damages;  ///< places that cannot be read, with offsets; at most kMostDamages
  std::uint64_t damages_in_all = 0;
};
inline constexpr std::size_t kMostDamages = 100;

/// Reads the whole file once, one chunk at a time. Error: the file has no readable index.
[[nodiscard]] Result<SessionFacts> inspect(const std::filesystem::path& file);

/// The facts as text for a terminal, with the texts of the file escaped.
[[nodiscard]] std::string in_words(const SessionFacts& facts);

/// The facts as JSON.
[[nodiscard]] std::string in_json(const SessionFacts& facts);

/// Warnings about the session, one line each, not escaped: lost messages, times that go back, other versions.
[[nodiscard]] std::vector<std::string> notes_on(const SessionFacts& facts);

}  // namespace telepalp::record
