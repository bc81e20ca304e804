#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <vector>

#include "messages/playback.pb.h"
#include "proto/words/result.h"
#include "proto/words/time.h"

namespace telepalp::playback {

/// The hand-off between a player's thread and the threads that command it: commands in, state out. The player's thread
/// sleeps in it until it is commanded.
class PlayerCommands {
 public:
  /// `first`: waits from the beginning.
  explicit PlayerCommands(const msg::PlaybackCommand& first) : commands_{first} {}

  // Any thread.

  /// Error: a position beyond the session's end, or end() has been called.
  [[nodiscard]] Result<void> add(const msg::PlaybackCommand& command);
  void ask_again();  ///< asks for the present picture once more
  void stop();
  [[nodiscard]] msg::PlaybackState state() const;  ///< PlaybackState.pending: add() was called since the last show()
  [[nodiscard]] bool is_stopping() const;

  // The player's thread.

  struct Taken {
    std::vector<msg::PlaybackCommand> commands;  ///< in the order in which they came
    bool again = false;                          ///< ask_again() was called since
  };
  /// What came since the last call. Nullopt: the player must stop.
  [[nodiscard]] std::optional<Taken> take();
  void show(msg::PlaybackState state);
  /// Sleeps for `patience`. False: a command came, or the player must stop.
  [[nodiscard]] bool wait_for(Nanoseconds patience);
  /// From here on, no command is accepted. False: one is waiting, and nothing has changed.
  [[nodiscard]] bool end();

 private:
  mutable std::mutex mutex_;  // guards all members
  std::condition_variable changed_;
  std::vector<msg::PlaybackCommand> commands_;
  msg::PlaybackState state_;
  bool carrying_out_ = false;  // what take() gave
  bool again_ = false;
  bool over_ = false;
  bool stopping_ = false;
};

}  // namespace telepalp::playback
