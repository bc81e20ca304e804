#include "server/playback/player/player_commands.h"

#include <string>
#include <utility>

namespace telepalp::playback {

using namespace std::chrono_literals;

Result<void> PlayerCommands::add(const msg::PlaybackCommand& command) {
  const std::scoped_lock lock(mutex_);
  if (over_)
    return Error{.what = "the session is over, and the server ends",
                 .where = "playback",
                 .fix = "start the server again; with --loop yes it plays the session again and again"};
  if (command.has_seek_s() && command.seek_s() > state_.duration_s())
    return Error{.what = "the session lasts only " + std::to_string(state_.duration_s()) + " s",
                 .where = "seek_s",
                 .fix = "give a time from 0 s to the length of the session"};
  commands_.push_back(command);
  changed_.notify_one();
  return {};
}

void PlayerCommands::ask_again() {
  const std::scoped_lock lock(mutex_);
  again_ = true;
  changed_.notify_one();
}

void PlayerCommands::stop() {
  const std::scoped_lock lock(mutex_);
  stopping_ = true;
  changed_.notify_one();
}

msg::PlaybackState PlayerCommands::state() const {
  const std::scoped_lock lock(mutex_);
  msg::PlaybackState state = state_;
  state.set_pending(carrying_out_ || !commands_.empty());
  return state;
}

bool PlayerCommands::is_stopping() const {
  const std::scoped_lock lock(mutex_);
  return stopping_;
}

std::optional<PlayerCommands::Taken> PlayerCommands::take() {
  const std::scoped_lock lock(mutex_);
  if (stopping_) return std::nullopt;
  carrying_out_ = carrying_out_ || !commands_.empty();
  return Taken{.commands = std::exchange(commands_, {}), .again = std::exchange(again_, false)};
}

void PlayerCommands::show(msg::PlaybackState state) {
  const std::scoped_lock lock(mutex_);
  state_ = std::move(state);
  carrying_out_ = false;
}

bool PlayerCommands::wait_for(Nanoseconds patience) {
  std::unique_lock lock(mutex_);
  if (patience > 0ns) changed_.wait_for(lock, patience, [&] { return stopping_ || again_ || !commands_.empty(); });
  return !stopping_ && commands_.empty();
}

bool PlayerCommands::end() {
  const std::scoped_lock lock(mutex_);
  if (!commands_.empty()) return false;
  over_ = true;
  return true;
}

}  // namespace telepalp::playback
