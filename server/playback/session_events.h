#pragma once

#include <atomic>
#include <filesystem>
#include <mutex>
#include <thread>

#include "messages/playback.pb.h"
#include "proto/words/time.h"

namespace telepalp::playback {

/// The station's events of a whole session file, for an overview before it is played. A separate thread reads them; the
/// mutex guards the list, which the network thread copies. At most kMostEvents are kept: the first ones.
class SessionEvents {
 public:
  static constexpr int kMostEvents = 5000;

  /// Begins to read. `begin`: session time of the session's first message, from which the events' times count.
  SessionEvents(std::filesystem::path file, SessionTime begin);
  ~SessionEvents();
  SessionEvents(const SessionEvents&) = delete;
  SessionEvents& operator=(const SessionEvents&) = delete;

  /// The events so far. Any thread.
  [[nodiscard]] msg::SessionEvents events() const;

 private:
  void read(const std::filesystem::path& file, SessionTime begin);
  void read_events(const std::filesystem::path& file, SessionTime begin);

  mutable std::mutex mutex_;
  msg::SessionEvents events_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;  // last member: the thread uses the others
};

}  // namespace telepalp::playback
