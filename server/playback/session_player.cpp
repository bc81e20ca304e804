#include "server/playback/session_player.h"

#include <algorithm>
#include <utility>

#include "messages/camera.pb.h"
#include "proto/words/counted.h"
#include "server/playback/retimed.h"

namespace telepalp::playback {
namespace {

using namespace std::chrono_literals;

constexpr Nanoseconds kStatusEvery = 1s;
constexpr Nanoseconds kRepeatedEvery = 1s;  // least time between two repeats of the picture while paused
/// A player that is later than this (slow disk, computer was asleep) continues at normal speed instead of catching up.
constexpr Nanoseconds kLatest = 500ms;
constexpr Nanoseconds kBetweenRounds{33'333'333};  // from the last message to the repeated first one
constexpr Nanoseconds kLongestPause = 2s;          // a longer pause in a recording is cut to this

double seconds_between(SessionTime from, SessionTime to) { return to_seconds(to - from); }

msg::PlaybackCommand seek_to(double at_s) {
  msg::PlaybackCommand command;
  command.set_seek_s(at_s);
  return command;
}

SessionTime captured_at(const wire::Message& depth) {
  msg::DepthImage image;
  (void)image.ParseFromString(*depth.payload);  // retimed() has read it
  return session_time(static_cast<std::int64_t>(image.captured_ns()));
}

}  // namespace

Result<std::unique_ptr<SessionPlayer>> SessionPlayer::open(const PlaybackSpec& spec, bool loop,
                                                           wire::SessionClock clock,
                                                           const wire::mcap::Progress& progress) {
  Result<Timeline> timeline = Timeline::open(spec.file, spec.topics, progress);
  if (!timeline) return timeline.error();
  const double duration_s = seconds_between(timeline->begin(), timeline->end());
  if (spec.from_s > duration_s)
    return Error{.what = "the session lasts only " + std::to_string(duration_s) + " s",
                 .where = "from_s=" + std::to_string(spec.from_s),
                 .fix = "give a time from 0 s to the length of the session"};
  return std::unique_ptr<SessionPlayer>(new SessionPlayer(std::move(*timeline), spec, loop, clock));
}

SessionPlayer::SessionPlayer(Timeline timeline, const PlaybackSpec& spec, bool loop, wire::SessionClock clock)
    : timeline_(std::move(timeline)),
      file_(spec.file),
      begin_(timeline_.begin()),
      clock_(clock),
      playing_(!spec.paused),
      loop_(loop),
      speed_(spec.speed),
      commands_(seek_to(spec.from_s)) {
  position_ = timeline_.begin();
  show_state();
}

SessionPlayer::~SessionPlayer() { stop(); }

void SessionPlayer::start(boost::asio::io_context& network, Handlers handlers) {
  outlet_.emplace(network, std::move(handlers.on_message), std::move(handlers.on_end));
  thread_ = std::thread([this] { run(); });
}

void SessionPlayer::stop() {
  commands_.stop();
  if (thread_.joinable()) thread_.join();
}

Result<void> SessionPlayer::apply(const msg::PlaybackCommand& command) { return commands_.add(command); }

void SessionPlayer::show_again() { commands_.ask_again(); }

msg::PlaybackState SessionPlayer::state() const { return commands_.state(); }

void SessionPlayer::show_state() {
  msg::PlaybackState state;
  state.set_file(file_);
  state.set_position_s(seconds_between(timeline_.begin(), position_));
  state.set_duration_s(seconds_between(timeline_.begin(), timeline_.end()));
  state.set_speed(speed_);
  state.set_loop(loop_);
  state.set_playing(playing_);
  state.set_damaged(timeline_.damaged());
  state.set_begin_ns(static_cast<std::uint64_t>(to_nanoseconds(timeline_.begin())));
  if (shown_) {
    state.set_shown_ns(static_cast<std::uint64_t>(to_nanoseconds(shown_->map(shown_->instant))));
    state.set_shown_s(seconds_between(timeline_.begin(), shown_->instant));
    state.set_shown_speed(shown_->map.speed);
  }
  commands_.show(std::move(state));
}

/// Sleeps until `due`, at most until the next status. False: a command came, or the player stops.
bool SessionPlayer::wait_until(SessionTime due) {
  return commands_.wait_for(std::min(due, status_.at + kStatusEvery) - clock_.now());
}

void SessionPlayer::run() {
  while (const std::optional<PlayerCommands::Taken> taken = commands_.take()) {
    for (const msg::PlaybackCommand& command : taken->commands) carry_out(command);
    if (playing_ && at_end()) {
      if (finish()) return outlet_->end();
      continue;  // a command came meanwhile: it may seek
    }
    if (taken->again && !playing_) repeat_picture();
    publish_status_when_due();
    show_state();
    if (playing_)
      play_next();
    else
      (void)wait_until(clock_.now() + kStatusEvery);
  }
}

/// True if the session has ended and is not repeated; else it has a next message.
bool SessionPlayer::at_end() {
  if (!next_ && loop_) {
    go_to(timeline_.begin());
    map_.now += kBetweenRounds;
  }
  return !next_;
}

/// From here on, no command is accepted. False: one is waiting.
bool SessionPlayer::finish() {
  if (!commands_.end()) return false;
  ended_ = true;
  publish_status_when_due();
  playing_ = false;
  show_state();
  return true;
}

void SessionPlayer::carry_out(const msg::PlaybackCommand& command) {
  if (command.has_loop()) loop_ = command.loop();
  if (command.has_speed()) speed_ = command.speed();
  if (command.has_play()) playing_ = command.play();
  if (command.has_step() || command.has_step_back()) playing_ = false;
  anchor();
  if (command.has_seek_s()) go_to(timeline_.begin() + Nanoseconds(static_cast<std::int64_t>(command.seek_s() * 1e9)));
  if (command.has_seek_s() && !playing_ && !command.has_step() && !command.has_step_back()) show_first_picture();
  if (command.has_step()) step(command.step());
  if (command.has_step_back()) step_back(command.step_back());
}

/// Maps the present position to now, at the present speed.
void SessionPlayer::anchor() {
  map_ = {.recorded = position_, .now = clock_.now(), .speed = speed_};
  voice_.jumped();
}

void SessionPlayer::go_to(SessionTime at) {
  const std::vector<wire::Message> needed = timeline_.seek(at);
  next_ = timeline_.next();
  position_ = at;
  picture_shown_ = false;
  anchor();
  for (const wire::Message& message : needed) publish(message);
}

/// At a position before the first picture, goes on to that picture, so that a paused session is never empty.
void SessionPlayer::show_first_picture() {
  if (picture_shown_) return;
  const SessionTime at = position_;
  step(1);
  if (!picture_shown_) go_to(at);
}

/// Publishes the messages that a receiver needs at the present position. The picture keeps the time stamp of its first
/// publication: with a newer one, a station would let the hand touch a picture that stands still.
void SessionPlayer::repeat_picture() {
  if (clock_.now() - repeated_at_ < kRepeatedEvery) return;
  repeated_at_ = clock_.now();
  const std::optional<wire::Message> before = next_;
  const std::vector<wire::Message> needed =
      timeline_.seek(before ? before->published : timeline_.end() + Nanoseconds(1));
  const auto is_as_before = [&] {
    return !before || !next_ || (next_->topic.name == before->topic.name && next_->sequence == before->sequence);
  };
  do next_ = timeline_.next();
  while (!is_as_before());
  const TimeMap present = std::exchange(map_, shown_ ? shown_->map : map_);
  for (const wire::Message& message : needed) publish(message);
  map_ = present;
}

/// Shows the depth image that comes `pictures` after the shown one, with all that a receiver needs beside it. One
/// anchor maps them all: the station's states of the picture's instant were published before the picture.
void SessionPlayer::step(std::uint32_t pictures) {
  const auto is_depth = [&] { return next_ && next_->topic.name == wire::kCameraDepth.name; };
  for (std::uint32_t passed = 0; next_ && !(passed == pictures && is_depth()); next_ = timeline_.next())
    if (is_depth()) ++passed;
  go_to(next_ ? next_->published : timeline_.end() + Nanoseconds(1));
  position_ = std::min(position_, timeline_.end());
}

/// Shows the depth image that comes `pictures` before the shown one, or the first one. A seek to the instant at which
/// an image was published shows the image before it.
void SessionPlayer::step_back(std::uint32_t pictures) {
  for (; pictures > 0 && shown_ && shown_->is_picture; --pictures) go_to(shown_->published);
  show_first_picture();
}

void SessionPlayer::play_next() {
  if (next_->published - position_ > kLongestPause) {
    position_ = next_->published - kLongestPause;
    anchor();
  }
  const SessionTime due = map_(next_->published);
  if (due > clock_.now() && !wait_until(due)) return;
  if (due > clock_.now()) return;  // woken for the status
  position_ = std::max(position_, next_->published);
  if (clock_.now() - due > kLatest) anchor();
  publish(*next_);
  next_ = timeline_.next();
}

void SessionPlayer::publish(const wire::Message& recorded) {
  if (recorded.topic.name == wire::kCameraStatus.name) {
    msg::CaptureStatus status;
    if (status.ParseFromString(*recorded.payload)) color_registered_ = status.color_registered();
    return;  // the player states its own status
  }
  if (recorded.topic.spoken && map_.speed != 1.0) return;
  std::optional<wire::Message> message = retimed(recorded, map_);
  if (message && recorded.topic.spoken) message = voice_.as_played(*message);
  if (!message) return;
  note_shown(recorded);
  outlet_->hand_over(std::move(*message), commands_);
}

void SessionPlayer::note_shown(const wire::Message& recorded) {
  const bool is_picture = recorded.topic.name == wire::kCameraDepth.name;
  if (is_picture) {
    picture_shown_ = true;
    ++depth_images_;
  } else if (shown_ && shown_->is_picture) {
    return;
  }
  shown_ = {.is_picture = is_picture,
            .instant = is_picture ? captured_at(recorded) : recorded.published,
            .published = recorded.published,
            .map = map_};
}

void SessionPlayer::publish_status_when_due() {
  const SessionTime now = clock_.now();
  const std::string how = ended_ ? "at its end" : playing_ ? "playing" : "paused";
  const std::string speed = speed_ == 1.0 ? ""
                                          : ", speed " + std::to_string(speed_).substr(0, 4) +
                                                (timeline_.has_speech() ? ", without the voices" : "");
  if (status_.text == how + speed && now - status_.at < kStatusEvery) return;
  status_ = {.text = how + speed, .at = now};
  msg::CaptureStatus status;
  status.set_stamp_ns(static_cast<std::uint64_t>(to_nanoseconds(now)));
  status.set_state(ended_ ? msg::CAPTURE_STATE_ENDED : playing_ ? msg::CAPTURE_STATE_LIVE : msg::CAPTURE_STATE_WAITING);
  status.set_source("session:" + file_);
  status.set_detail("recorded session " + file_ + ", " + how + speed);
  if (const auto damaged = timeline_.damaged(); damaged > 0)
    status.set_detail(status.detail() + "; " + counted(damaged, "damaged part skipped", "damaged parts skipped"));
  status.set_frames(depth_images_);
  status.set_color_registered(color_registered_);
  outlet_->hand_over(wire::make_message(wire::kCameraStatus, now, status), commands_);
}

}  // namespace telepalp::playback
