#pragma once

#include <cstddef>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "support/nats/nats_connection.h"

namespace telepalp::replay {

/// Notes from the library's threads, until the program's thread takes them. Beyond kMost_B, notes are dropped: answers
/// are found again in their stream, and presences are repeated.
class Inbox {
 public:
  static constexpr std::size_t kMost_B = std::size_t{64} << 20U;
  struct Note {
    std::string subject;
    std::string payload;
  };

  void put(const nats::NatsConnection::Note& note) {
    const std::size_t bytes = sizeof(Note) + note.subject.size() + note.payload.size();
    const std::scoped_lock lock(mutex_);
    if (bytes_ + bytes > kMost_B) return;
    bytes_ += bytes;
    notes_.push_back({std::string(note.subject), std::string(note.payload)});
  }
  [[nodiscard]] std::vector<Note> take() {
    const std::scoped_lock lock(mutex_);
    bytes_ = 0;
    return std::exchange(notes_, {});
  }

 private:
  std::mutex mutex_;
  std::vector<Note> notes_;  // guarded by mutex_
  std::size_t bytes_ = 0;    // guarded by mutex_
};

}  // namespace telepalp::replay
