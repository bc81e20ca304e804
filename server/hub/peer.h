#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "messages/station.pb.h"
#include "proto/link/datagram_link.h"
#include "proto/wire/connection/connection.h"
#include "server/access/access.h"
#include "server/access/unproven.h"
#include "server/hub/hub.h"
#include "server/hub/peer_datagrams.h"
#include "server/hub/peer_touch.h"
#include "server/hub/places.h"
#include "server/hub/upstream.h"

namespace telepalp::hub {

/// How a peer's connection has come to this server.
enum class Way {
  Port,          ///< to the server's port
  MeetingPoint,  ///< through the meeting point, so that the server's UDP port is probably out of the peer's reach
};

/// What a peer needs of the server around it. All functions are called on the network thread.
struct PeerSite {
  boost::asio::io_context& io;
  Hub& hub;
  DatagramPort& datagrams;
  access::Access& access;
  std::string server_name;
  const std::optional<Error>& no_stations;  ///< why this server takes no stations; nullopt: it takes them
  PlaceLimits places;
  IdleLimits idle;
  std::function<SessionTime()> now;                               ///< session time
  std::function<std::size_t(PlaceKind)> taken;                    ///< number of peers that occupy a place of this kind
  std::function<std::uint32_t(std::uint64_t run)> sender_number;  ///< for a peer that states this run; free
  /// Doctor `who` has accepted the touch, so the peer of this number loses it.
  std::function<void(std::uint64_t peer, const keys::Identity& who)> hand_over;
  std::function<void(const std::string&)> note;          ///< a log line
  std::function<void(const std::string&)> note_refusal;  ///< a log line about a refused peer
  /// The connection of a peer that never joined has ended, for `reason`. Many such peers share one line of the log.
  std::function<void(const std::string& happened, const std::string& reason)> note_stranger_gone;
  std::function<std::vector<msg::IceRelay>()> relays;        ///< for peers behind the meeting point
  std::function<void(const Error&)> note_relay;              ///< logs once why the relay is of no use
  std::function<void(const msg::WindowRequest&)> on_window;  ///< a station asks for a window of exact depth
  std::function<void()> on_invalid;                          ///< a message was dropped because it is invalid
  std::function<void()> on_over_rate;                        ///< a message was dropped because of its topic's rate
  std::function<void()> on_leaving;                          ///< before a peer and its counts leave the hub
  std::function<void(std::uint64_t peer)> forget;            ///< the peer's connection has ended
};

/// One peer: connects its network connection with its subscription in the hub.
class Peer : private wire::ConnectionOwner {
 public:
  using Clock = std::chrono::steady_clock;

  /// `number`: differs for each peer of the server. `arrival`: from where and when its connection came. `site` must
  /// outlive the peer.
  Peer(const PeerSite& site, std::uint64_t number, const access::Unproven& arrival,
       std::unique_ptr<wire::ByteStream> stream, Way way);
  ~Peer() override;
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  void close(const std::string& reason) { connection_->close(reason); }
  /// Doctor `who` at another peer has the touch (the right to publish as a station) now: by accepting this peer's
  /// offer, or because the station of this peer has connected again.
  void give_touch_to(const keys::Identity& who) {
    connection_->close(touch_.lose_to(who, who_ && who_->serial == who.serial));
  }
  [[nodiscard]] std::uint32_t sender() const noexcept { return sender_; }
  [[nodiscard]] std::string from() const { return connection_->peer(); }  ///< ADDRESS:PORT

  [[nodiscard]] const access::Unproven& arrival() const noexcept { return arrival_; }

  /// The kind of place (places.h: a connection that counts against a limit) that the peer occupies; nullopt: no Hello
  /// yet, or refused.
  [[nodiscard]] std::optional<PlaceKind> place() const noexcept { return place_; }

  /// Ends the connection when the peer's key has expired or is revoked.
  void check_key();
  [[nodiscard]] bool references_arrive() const noexcept { return !datagrams_ || datagrams_->references_arrive(); }
  [[nodiscard]] std::optional<double> share_B_per_s() const noexcept {
    return datagrams_ ? datagrams_->share_B_per_s() : std::nullopt;
  }
  [[nodiscard]] SubscriberId subscriber() const noexcept { return subscriber_; }  ///< 0: not in the hub
  /// Standing queue of the path of the datagrams; 0 while TCP carries the images.
  [[nodiscard]] Nanoseconds queue() const noexcept { return datagrams_ ? datagrams_->queue() : Nanoseconds{0}; }
  /// Share of the last depth images that the peer's line had no room for.
  [[nodiscard]] double dropped() noexcept;
  /// Tells the hub what other flows leave, for /server/stats: at most what arrived in the last second.
  void note_share() {
    site_.hub.note_share(subscriber_, datagrams_ ? datagrams_->delivered_share_B_per_s() : std::nullopt);
  }
  [[nodiscard]] bool is_idle(Clock::time_point now) const noexcept;

 private:
  bool accepts(const wire::Topic& topic) override;
  void on_ready(const msg::Hello& peer) override;
  void on_message(wire::Message message) override;
  void on_subscribe(std::vector<std::string> topics) override;
  void on_clock(const wire::ClockSample&) override {}  // the server's clock is the session clock: it sends no probes
  void on_key_frame_request(const wire::Topic& topic, SessionTime published) override;
  void on_closed(const std::string& reason) override;
  void on_hand_over(const msg::HandOver& request) override;
  void on_ice_path(const msg::IcePath& message) override {
    if (datagrams_) datagrams_->on_ice_path(message);
  }
  std::optional<wire::Message> next_to_send() override { return site_.hub.next(subscriber_); }
  SessionTime session_now() override { return site_.now(); }

  void audit(access::AuditEvent event, const std::string& more = {});
  void deny(const Error& why);
  void refuse(const std::string& reason);
  [[nodiscard]] Result<keys::Identity> whose(const msg::Hello& peer) const;
  [[nodiscard]] bool may_be_station() const;
  [[nodiscard]] bool may_hear() const;
  void show_revocations();
  void join(PlaceKind kind, const msg::Hello& peer);
  void offer_datagrams(const msg::Hello& peer);
  [[nodiscard]] std::function<void(wire::Message)> messages_by_datagram();
  void note_images(wire::DatagramPhase phase);
  void wake();
  [[nodiscard]] bool takes_touch(bool accepts);
  void on_over_rate(const wire::Topic& topic);
  void note_window(const wire::Message& message);
  void end_datagrams();
  void leave_hub();

  const PeerSite& site_;
  std::uint64_t number_;
  access::Unproven arrival_;
  Way way_;
  std::string name_;
  std::optional<keys::Identity> who_;  // nullopt: not known yet, or refused
  std::optional<PlaceKind> place_;
  PeerTouch touch_;
  std::uint64_t stream_ = 0;                 // its number in access::People
  std::optional<std::uint64_t> list_shown_;  // number of the list of revoked keys that the peer has seen
  bool may_record_voice_ = false;            // the patient consents to it, as the peer has stated
  bool audited_ = false;                     // the audit log already has the reason for this peer's refusal
  bool advertised_ = false;                  // the peer has advertised an allowed topic
  bool subscribed_ = false;                  // the peer is subscribed to at least one topic
  Clock::time_point useful_{};               // when it last published, ended its subscriptions or sent its Hello
  UpstreamRates rates_;
  link::DropShare drops_;
  bool over_rate_noted_ = false;
  std::uint32_t sender_ = 0;                      // 0: no Hello yet
  SubscriberId subscriber_ = 0;                   // 0: not in the hub
  std::unique_ptr<PeerDatagrams> datagrams_;      // null: not offered
  std::shared_ptr<wire::Connection> connection_;  // shared with its pending operations
};

}  // namespace telepalp::hub
