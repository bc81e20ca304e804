#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "messages/playback.pb.h"
#include "proto/wire/mcap/reader.h"
#include "proto/words/result.h"
#include "proto/words/time.h"
#include "support/speech/session_speech.h"

namespace telepalp::playback {

/// The station's events of a whole session file, and where people speak in it, for an overview before it is played. A
/// separate thread reads them; the mutex guards the list, which the network thread copies. At most kMostEvents are
/// kept: the first ones. Where people speak is read at once from the recorder's own record. Only a file without one (of
/// an earlier release, repaired, cut or merged) is surveyed, after the events: that takes as long as reading most of
/// the file.
class SessionEvents {
 public:
  static constexpr int kMostEvents = 5000;

  using Say = std::function<void(const std::string& line)>;

  /// Begins to read. `begin`: session time of the session's first message, from which the events' times count. `say` is
  /// called at most once, on the thread that reads, when the list lacks events: what is left out, and why.
  SessionEvents(
      std::filesystem::path file, SessionTime begin, Say say = [](const std::string&) {});
  ~SessionEvents();
  SessionEvents(const SessionEvents&) = delete;
  SessionEvents& operator=(const SessionEvents&) = delete;

  /// The events so far. Any thread.
  [[nodiscard]] msg::SessionEvents events() const;

 private:
  /// What read_events() could not read.
  struct LeftOut {
    std::optional<Error> file;  ///< the whole file
    std::uint64_t damaged = 0;  ///< chunks and events
    bool too_many = false;      ///< the events after the first kMostEvents
  };
  void read(const std::filesystem::path& file, SessionTime begin, const Say& say);
  LeftOut read_events(wire::McapReader& reader, SessionTime begin);
  void show(const speech::Speech& speech, SessionTime begin);

  mutable std::mutex mutex_;
  msg::SessionEvents events_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;  // last member: the thread uses the others
};

}  // namespace telepalp::playback
