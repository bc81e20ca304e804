#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "server/hub/hub.h"
#include "server/origin/origin.h"

namespace telepalp::origin {

/// What a reader opens for themselves.
struct ReadingSpec {
  std::string session{};         ///< name of a recording; empty: the session that the server plays for all
  std::optional<double> at_s{};  ///< the moment at which it stands, since the session's beginning; nullopt: it plays
};

/// An origin that one reader alone sees and moves, with a hub of its own. It begins when the reader has subscribed.
/// Owner: the network thread.
class Reading {
 public:
  /// `origin`: null for a reading that could not be opened, which publishes nothing.
  Reading(boost::asio::io_context& network, std::unique_ptr<Origin> origin);
  Reading(const Reading&) = delete;
  Reading& operator=(const Reading&) = delete;

  [[nodiscard]] hub::Hub& hub() noexcept { return hub_; }
  [[nodiscard]] hub::Hub& views() noexcept { return views_; }  ///< of the topics for Foxglove; nobody publishes there
  [[nodiscard]] const Offer& offer() const noexcept { return offer_; }

  /// Call it after the reader has subscribed.
  void subscriptions_changed();
  void stop();

 private:
  void look();

  hub::Hub hub_;
  hub::Hub views_;
  boost::asio::steady_timer timer_;
  std::unique_ptr<Origin> origin_;
  Offer offer_;
  bool started_ = false;
  bool stopped_ = false;
};

/// The readings of a server. A reading ends when nobody holds it. Owner: the network thread.
class Readings {
 public:
  using Open = std::function<Result<std::unique_ptr<Origin>>(const ReadingSpec&)>;
  static constexpr std::size_t kMost = 8;  ///< each has a thread, and sends what a camera sends

  /// `open`: unset: this server opens no session for a reader.
  Readings(boost::asio::io_context& network, Open open) : network_(network), open_(std::move(open)) {}

  /// The reading with the number `id`, which its reader made up at random; opens `asked` if there is none. Error: it
  /// cannot be opened, or kMost are open.
  [[nodiscard]] Result<std::shared_ptr<Reading>> join(const std::string& id, const ReadingSpec& asked);
  /// Null: there is none.
  [[nodiscard]] std::shared_ptr<Reading> find(const std::string& id) const;
  /// A reading that publishes nothing, for a reader whose session could not be opened.
  [[nodiscard]] std::shared_ptr<Reading> nothing() { return shared(nullptr); }

 private:
  [[nodiscard]] std::shared_ptr<Reading> shared(std::unique_ptr<Origin> origin);

  boost::asio::io_context& network_;
  Open open_;
  std::map<std::string, std::weak_ptr<Reading>> readings_;  // by id
};

}  // namespace telepalp::origin
