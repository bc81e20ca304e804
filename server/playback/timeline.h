#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "proto/wire/mcap/reader.h"

namespace telepalp::playback {

/// Reads the messages of a session file in order of time, from any instant on. Only the chunks that hold the current
/// instant are in memory.
class Timeline {
 public:
  /// `topics`: full names, or prefixes that end in '*'. `progress`: as for McapReader::open(). Error: not a session
  /// file, or no message on these topics.
  [[nodiscard]] static Result<Timeline> open(const std::filesystem::path& file, std::vector<std::string> topics,
                                             const wire::mcap::Progress& progress = {});

  [[nodiscard]] SessionTime begin() const noexcept { return begin_; }
  [[nodiscard]] SessionTime end() const noexcept { return end_; }

  /// Moves to `at`: next() then returns the messages from `at` on. Returns the earlier messages that a receiver needs
  /// at `at`, in order of time: the last camera models, the last colour image, the depth images since the last key
  /// frame, and the station's states of the last 150 ms. Looks for them in the second before `at`; if one is missing
  /// there, in the 10 s before `at`; and in both cases from the last key frame on, if the file marks key frames.
  [[nodiscard]] std::vector<wire::Message> seek(SessionTime at);
  /// The next message; nullopt at the end. Damaged parts are skipped and counted.
  [[nodiscard]] std::optional<wire::Message> next();

  /// True if speech is among the messages that are played.
  [[nodiscard]] bool has_speech() const;
  [[nodiscard]] std::uint64_t damaged() const noexcept { return damaged_; }

 private:
  Timeline(wire::McapReader reader, std::vector<std::string> topics);
  [[nodiscard]] bool is_played(std::string_view topic) const;
  [[nodiscard]] std::vector<std::string> needed_topics() const;
  [[nodiscard]] SessionTime begin_of_seek(SessionTime at, Nanoseconds back);

  wire::McapReader reader_;
  std::vector<std::string> topics_;
  SessionTime begin_;
  SessionTime end_;
  std::uint64_t damaged_ = 0;
};

}  // namespace telepalp::playback
