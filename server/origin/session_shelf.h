#pragma once

#include <boost/asio/io_context.hpp>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "messages/recording.pb.h"
#include "proto/wire/session_clock.h"
#include "proto/words/result.h"
#include "server/origin/opening_pool.h"
#include "server/origin/origin.h"
#include "server/origin/reading.h"
#include "server/playback/playback_command.h"

namespace telepalp::origin {

struct SessionSurvey;
class SessionInbox;

/// The recorded sessions that a server can play: the one of its source, and those of its folder of recordings. Owner:
/// the network thread. The files are opened on the threads of a pool.
class SessionShelf {
 public:
  static constexpr std::size_t kMostListed = 200;  ///< largest number of sessions that list() names

  struct Options {
    std::filesystem::path recordings{};  ///< a folder of sessions; empty: none
    std::filesystem::path compared{};    ///< a folder of sessions to compare a played one with; empty: none
    /// Gets a line for each part of a session that the list of events or a comparison leaves out, on the thread that
    /// reads it, and for each file that was not brought to its end.
    std::function<void(const std::string& line)> say{};
    /// Told of each file that a reader has brought, or that was refused: text for the audit log.
    std::function<void(const std::string& text)> on_brought{};
  };

  SessionShelf(boost::asio::io_context& network, const wire::SessionClock& clock, OpeningPool& pool, Options options);
  ~SessionShelf();

  /// The session that the server plays for all. `spec`: FILE.mcap and its options, as after `session:`. Waits until the
  /// file is open. Error: the options, the session, its notes or the folder of compared sessions cannot be used.
  [[nodiscard]] Result<std::unique_ptr<Origin>> play(const std::string& spec, bool loop);

  /// As play(), but for a recording of the folder, and without waiting. `name`: as list() names it.
  void play_later(const std::string& name, Progress progress, const OpenedOrigin& done);

  /// As play_later(), for the session of play().
  void play_again(Progress progress, const OpenedOrigin& done);

  /// Another source than a session is shown to all.
  void play_nothing() { played_ = {}; }

  /// A session for one reader alone, for Readings::Open. Error: the server plays none, its folder has none of this
  /// name, or it cannot be opened.
  void read_alone(const ReadingSpec& asked, Progress progress, const OpenedOrigin& done);

  /// Takes a part of a session file that the person `who` brings: JSON of a msg::SessionPart. Error: a name that is
  /// taken or cannot be listed, a part that does not follow the last one, a full disk, or no session file.
  void take(const std::string& json, const std::string& who, Resource::Done done);

  /// The recordings, newest first.
  [[nodiscard]] msg::SessionList list() const;

 private:
  struct Opened;
  [[nodiscard]] Result<std::unique_ptr<Origin>> origin_of(Opened opened, const playback::PlaybackSpec& spec,
                                                          bool is_endless);
  [[nodiscard]] Result<std::filesystem::path> recording_named(const std::string& name) const;
  [[nodiscard]] Result<playback::PlaybackSpec> spec_of(const ReadingSpec& asked) const;
  void open_later(const playback::PlaybackSpec& spec, bool loop, bool is_endless, Progress progress,
                  const OpenedOrigin& done);
  void play_for_all(const playback::PlaybackSpec& spec, Progress progress, const OpenedOrigin& done);

  boost::asio::io_context& network_;
  wire::SessionClock clock_;
  OpeningPool& pool_;
  Options options_;
  std::unique_ptr<SessionInbox> inbox_;
  std::optional<playback::PlaybackSpec> first_;                            // of play()
  bool loops_ = true;                                                      // as play() was told
  playback::PlaybackSpec played_;                                          // for all; file empty: none
  std::map<std::filesystem::path, std::weak_ptr<SessionSurvey>> surveys_;  // by file
};

}  // namespace telepalp::origin
