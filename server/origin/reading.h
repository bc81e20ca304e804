#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "messages/playback.pb.h"
#include "server/hub/hub.h"
#include "server/origin/opening_pool.h"
#include "server/origin/origin.h"
#include "server/origin/state_publisher.h"

namespace telepalp::origin {

using OpenedOrigin = std::function<void(Result<std::unique_ptr<Origin>>)>;

/// What a reader opens for themselves.
struct ReadingSpec {
  std::string session{};         ///< name of a recording; empty: the session that the server plays for all
  std::optional<double> at_s{};  ///< the moment at which it stands, since the session's beginning; nullopt: it plays
};

/// An origin that one reader alone sees and moves, with a hub of its own. It is opened while the reader waits, and
/// begins when the reader has subscribed. Owner: the network thread.
class Reading {
 public:
  /// `session`: as ReadingSpec::session. `common`: resources of the server itself, which this reader sees, too. `now`
  /// reads the session clock.
  Reading(boost::asio::io_context& network, const std::string& session, const Resources& common,
          std::function<SessionTime()> now);
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  [[nodiscard]] hub::Hub& hub() noexcept { return hub_; }
  /// The hub of the topics that only viewers get. In a reading it carries the states of resources, and no views for
  /// Foxglove.
  [[nodiscard]] hub::Hub& views() noexcept { return views_; }
  [[nodiscard]] StatePublisher& states() noexcept { return states_; }
  [[nodiscard]] const Offer& offer() const noexcept { return offer_; }

  /// Opening: publishes nothing yet. Failed: publishes nothing; `problem` says why.
  [[nodiscard]] const msg::ReadingState& state() const noexcept { return state_; }
  void read_share(double share) { state_.set_read_share(share); }
  void open(Result<std::unique_ptr<Origin>> origin);

  /// Call it after the reader has subscribed.
  void subscriptions_changed();
  void stop();

 private:
  void look();

  hub::Hub hub_;
  hub::Hub views_;
  boost::asio::steady_timer timer_;
  std::unique_ptr<Origin> origin_;  // null until open(), and if it failed
  msg::ReadingState state_;
  Offer offer_;
  StatePublisher states_;
  bool awaited_ = false;  // the reader has subscribed
  bool started_ = false;
  bool stopped_ = false;
};

/// The readings of a server. A reading ends when nobody holds it. Owner: the network thread.
class Readings {
 public:
  /// Opens a session. `progress` and `done` are called on the network thread, `done` once, now or later.
  using Open = std::function<void(const ReadingSpec&, Progress progress, OpenedOrigin done)>;
  static constexpr std::size_t kMost = 8;  ///< each has a thread, and sends what a camera sends

  /// `open`: unset: this server opens no session for a reader. `common`, `now`: as for Reading.
  Readings(boost::asio::io_context& network, Open open, Resources common, std::function<SessionTime()> now)
      : network_(network), open_(std::move(open)), common_(std::move(common)), now_(std::move(now)) {}

  /// The reading with the number `id`, which its reader made up at random; begins to open `asked` if there is none. If
  /// kMost are open, the reading has failed.
  [[nodiscard]] std::shared_ptr<Reading> join(const std::string& id, const ReadingSpec& asked);
  /// Null: there is none.
  [[nodiscard]] std::shared_ptr<Reading> find(const std::string& id) const;
  /// A reading that publishes nothing, for a reader whose session cannot be opened.
  [[nodiscard]] std::shared_ptr<Reading> failed(const ReadingSpec& asked, const Error& why);

 private:
  [[nodiscard]] std::shared_ptr<Reading> made(const ReadingSpec& asked);

  boost::asio::io_context& network_;
  Open open_;
  Resources common_;
  std::function<SessionTime()> now_;
  std::map<std::string, std::weak_ptr<Reading>> readings_;  // by id
};

}  // namespace telepalp::origin
