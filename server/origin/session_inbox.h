#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "messages/recording.pb.h"
#include "proto/wire/mcap/writing/output_file.h"
#include "proto/wire/session_clock.h"
#include "server/origin/opening_pool.h"
#include "server/origin/resources.h"

namespace telepalp::origin {

/// True for a name of a session that an address can carry as it is: letters, digits, '.', '_' and '-'.
[[nodiscard]] bool is_plain_name(std::string_view name);

/// Takes session files that readers bring in parts to the folder of recordings. A file grows as NAME.mcap.part.partial,
/// encrypted with the site's key if one is given, is checked as NAME.mcap.part, and gets its name once its index has
/// been read. A file of which no part has come for kAbandoned is removed; so are those that an earlier run of the
/// server has left. Owner: the network thread.
class SessionInbox {
 public:
  static constexpr std::chrono::seconds kAbandoned{60};

  struct Options {
    std::filesystem::path folder;  ///< empty: takes no files
    std::function<void(const std::string& line)> say{};
    std::function<void(const std::string& text)> on_brought{};  ///< as SessionShelf::Options
    std::chrono::milliseconds abandoned{kAbandoned};
  };
  SessionInbox(boost::asio::io_context& network, const wire::SessionClock& clock, OpeningPool& pool, Options options);

  /// As SessionShelf::take().
  void take(const std::string& json, const std::string& who, Resource::Done done);

 private:
  struct Growing {
    std::optional<wire::mcap::OutputFile> file{};  ///< nullopt: it is checked
    std::uint64_t bytes = 0;                       // that were brought; an encrypted file has more
    std::chrono::steady_clock::time_point last_part{};
    bool is_checked = false;  // its last part has come, and a thread of the pool reads its index
  };
  [[nodiscard]] Result<void> append(const msg::SessionPart& part);
  void check(const msg::SessionPart& last, const std::string& who, const Resource::Done& done);
  [[nodiscard]] Result<void> accept(const std::string& name, const Result<bool>& readable);
  void look_for_abandoned();
  void remove(const std::string& name, const char* why);
  /// False: there was none.
  bool remove_part(const std::string& name) const;
  void note(const std::string& name, const std::string& who, const Result<void>& outcome) const;
  [[nodiscard]] std::filesystem::path part_of(const std::string& name) const;

  wire::SessionClock clock_;
  OpeningPool& pool_;
  Options options_;
  boost::asio::steady_timer look_;
  std::map<std::string, Growing> growing_;  // by name, without ".part"
};

}  // namespace telepalp::origin
