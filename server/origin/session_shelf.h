#pragma once

#include <boost/asio/io_context.hpp>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "messages/recording.pb.h"
#include "proto/wire/session_clock.h"
#include "proto/words/result.h"
#include "server/origin/origin.h"
#include "server/origin/reading.h"
#include "server/playback/playback_command.h"

namespace telepalp::origin {

struct SessionSurvey;

/// The recorded sessions that a server can play: the one of its source, and those of its folder of recordings. Owner:
/// the network thread, which waits while a file is opened.
class SessionShelf {
 public:
  static constexpr std::size_t kMostListed = 200;  ///< largest number of sessions that list() names

  using Say = std::function<void(const std::string& line)>;

  /// `recordings`: a folder of sessions; empty: none. `compared`: a folder of sessions to compare a played one with;
  /// empty: none. `say`: gets a line for each part of a session that the list of events or a comparison leaves out, on
  /// the thread that reads it.
  SessionShelf(boost::asio::io_context& network, const wire::SessionClock& clock, std::filesystem::path recordings,
               std::filesystem::path compared, Say say);
  ~SessionShelf();

  /// The session that the server plays for all. `spec`: FILE.mcap and its options, as after `session:`. Error: the
  /// options, the session, its notes or the folder of compared sessions cannot be used.
  [[nodiscard]] Result<std::unique_ptr<Origin>> play(const std::string& spec, bool loop);

  /// A session for one reader alone. Error: the server plays none, its folder has none of this name, or it cannot be
  /// opened.
  [[nodiscard]] Result<std::unique_ptr<Origin>> read_alone(const ReadingSpec& asked);

  /// Takes a part of a session file that a reader brings: JSON of a msg::SessionPart. Error: a name
  /// that is taken or cannot be listed, a part that does not follow the last one, a full disk, or no session file.
  [[nodiscard]] Result<void> take(const std::string& json);

  /// The recordings, newest first.
  [[nodiscard]] msg::SessionList list() const;

 private:
  [[nodiscard]] Result<std::unique_ptr<Origin>> open(const playback::PlaybackSpec& spec, bool loop, bool is_endless);
  [[nodiscard]] Result<std::filesystem::path> recording_named(const std::string& name) const;

  boost::asio::io_context& network_;
  wire::SessionClock clock_;
  std::filesystem::path recordings_;
  std::filesystem::path compared_;
  Say say_;
  playback::PlaybackSpec played_;                                          // by play(); file empty: none
  std::map<std::filesystem::path, std::weak_ptr<SessionSurvey>> surveys_;  // by file
};

}  // namespace telepalp::origin
