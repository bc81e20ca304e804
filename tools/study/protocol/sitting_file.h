#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "haptic_station/core/outbox/outbox.h"
#include "proto/wire/mcap/writer.h"
#include "tools/study/protocol/hands/person_trial.h"

namespace telepalp::study {

/// The session file of one sitting: the ticks of each penetration as a station's, and what began and ended as events
/// and notes. Owner: the network thread. The first failed write is kept for close(); later ones are left out.
class SittingFile {
 public:
  /// OUT/sessions/PARTICIPANT-0001.mcap, or the next free number. Error: the file cannot be created.
  [[nodiscard]] static Result<SittingFile> open(const std::filesystem::path& out, const std::string& participant,
                                                const std::string& protocol);

  /// A penetration begins, `now`.
  void begin(const std::string& what, SessionTime now);
  /// Its next ticks, which get numbers and times.
  void add(PersonTrial::Ticks& ticks);
  /// It has ended.
  void end(const std::string& what, const std::string& who);
  /// Completes the file, or removes it if no penetration began. Error: something could not be written.
  [[nodiscard]] Result<void> close();
  [[nodiscard]] const std::filesystem::path& name() const noexcept { return writer_.name(); }

 private:
  explicit SittingFile(wire::McapWriter writer) noexcept : writer_(std::move(writer)) {}
  [[nodiscard]] SessionTime newest() const noexcept;
  void write(const wire::Message& message);

  wire::McapWriter writer_;
  core::Outbox outbox_;
  std::uint64_t number_ = 0;  // of the next tick
  std::int64_t next_ns_ = 0;  // its session time
  bool begun_ = false;
  std::optional<Error> failed_;
};

}  // namespace telepalp::study
