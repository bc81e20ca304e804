#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <functional>
#include <optional>
#include <string>
#include <thread>

#include "messages/playback.pb.h"
#include "proto/wire/session_clock.h"
#include "server/playback/playback_command.h"
#include "server/playback/player/network_outlet.h"
#include "server/playback/player/played_voice.h"
#include "server/playback/player/player_commands.h"
#include "server/playback/retimed.h"
#include "server/playback/timeline.h"

namespace telepalp::playback {

/// Publishes a recorded session again: images as recorded, times mapped to the present session time, a pause of more
/// than 2 s cut to 2 s. Speech is published at speed 1 alone (PlayedVoice). A separate thread reads the file and waits
/// until each message is due; commands wake it. It uses a mutex and a condition variable, because it must sleep until
/// the next message or command; no real-time thread waits for it.
class SessionPlayer {
 public:
  struct Handlers {
    std::function<void(wire::Message)> on_message;  ///< on the network thread
    std::function<void()> on_end;                   ///< on the network thread, once, at the end unless `loop`
  };

  /// Reads the index of the file, which takes long on a slow disk. `progress`: told how much has been read. Error: the
  /// file cannot be read, or the session is shorter than `spec.from_s`.
  [[nodiscard]] static Result<std::unique_ptr<SessionPlayer>> open(const PlaybackSpec& spec, bool loop,
                                                                   wire::SessionClock clock,
                                                                   const wire::mcap::Progress& progress = {});
  ~SessionPlayer();
  SessionPlayer(const SessionPlayer&) = delete;
  SessionPlayer& operator=(const SessionPlayer&) = delete;

  void start(boost::asio::io_context& network, Handlers handlers);
  void stop();

  /// Carries the command out as soon as possible. Error: a position beyond the session's end, or the session is over:
  /// it has reached its end while playing without `loop`. Any thread.
  [[nodiscard]] Result<void> apply(const msg::PlaybackCommand& command);
  /// While paused, publishes the present depth image, the images from which it is predicted and the camera models
  /// again, for a subscriber that joined later. At most once a second. Any thread.
  void show_again();
  [[nodiscard]] msg::PlaybackState state() const;  ///< any thread
  /// Session time of the first message of the session file.
  [[nodiscard]] SessionTime begin() const noexcept { return begin_; }
  [[nodiscard]] std::uint64_t depth_images() const noexcept { return depth_images_; }  ///< published; any thread

 private:
  /// The newest published depth image, or any message before the first one. Times are those of the recording.
  struct Shown {
    bool is_picture;
    SessionTime instant;  ///< capture of the image, or publishing time of another message
    SessionTime published;
    TimeMap map;  ///< with which it was published
  };
  /// The status published last.
  struct Status {
    std::optional<std::string> text = {};
    SessionTime at{};
  };
  SessionPlayer(Timeline timeline, const PlaybackSpec& spec, bool loop, wire::SessionClock clock);
  void run();
  void carry_out(const msg::PlaybackCommand& command);
  void go_to(SessionTime at);
  void anchor();
  void step(std::uint32_t pictures);
  void step_back(std::uint32_t pictures);
  void show_first_picture();
  void repeat_picture();
  void play_next();
  [[nodiscard]] bool at_end();
  [[nodiscard]] bool finish();
  void publish(const wire::Message& recorded);
  void note_shown(const wire::Message& recorded);
  void publish_status_when_due();
  [[nodiscard]] bool wait_until(SessionTime due);
  void show_state();

  Timeline timeline_;  // after start(): the player's thread alone uses it and the members up to outlet_
  const std::string file_;
  const SessionTime begin_;  // begin() reads it on any thread
  const wire::SessionClock clock_;
  TimeMap map_;
  std::optional<wire::Message> next_;
  SessionTime position_{};
  bool playing_ = true;
  bool loop_ = true;
  double speed_ = 1.0;
  bool color_registered_ = true;
  bool ended_ = false;
  bool picture_shown_ = false;  // a depth image was published since the last seek
  std::optional<Shown> shown_;
  Status status_;
  SessionTime repeated_at_{};
  PlayedVoice voice_;
  std::optional<NetworkOutlet> outlet_;  // from start() on

  PlayerCommands commands_;
  std::atomic<std::uint64_t> depth_images_{0};
  std::thread thread_;  // last member: the thread uses the others
};

}  // namespace telepalp::playback
