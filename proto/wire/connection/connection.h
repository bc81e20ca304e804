#pragma once

#include <array>
#include <boost/asio/steady_timer.hpp>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "messages/control.pb.h"
#include "proto/wire/byte_stream.h"
#include "proto/wire/clock_sync.h"
#include "proto/wire/connection/incoming_channels.h"
#include "proto/wire/connection/outgoing_frames.h"
#include "proto/wire/connection/read_pace.h"
#include "proto/wire/frame.h"
#include "proto/wire/message.h"

namespace telepalp::wire {

inline constexpr std::chrono::seconds kHandshakeDeadline{5};  ///< from the start of the connection to the peer's Hello
inline constexpr std::chrono::seconds kSilenceDeadline{5};    ///< longest time between two complete frames of the peer

/// Callbacks of a Connection. All are called on the connection's thread.
class ConnectionOwner {
 public:
  virtual ~ConnectionOwner() = default;
  /// True if this peer may publish `topic`. A peer that advertises a forbidden topic is disconnected.
  virtual bool accepts(const Topic& topic) = 0;
  /// A valid Hello has arrived from the peer. Messages may follow.
  virtual void on_ready(const msg::Hello& peer) = 0;
  virtual void on_message(Message message) = 0;
  virtual void on_subscribe(std::vector<std::string> topics) = 0;
  virtual void on_clock(const ClockSample& sample) = 0;
  /// The peer requests a key frame: it could not decode the message of `topic` published at `published`.
  virtual void on_key_frame_request(const Topic& topic, SessionTime published) = 0;
  /// The connection has ended; no callback follows. `reason`: text for a log line.
  virtual void on_closed(const std::string& reason) = 0;
  /// Returns the next message to send; nullopt: no message waits, and the owner calls wake() when there is one. The
  /// owner holds the bounded queue; the connection holds only the message being written.
  virtual std::optional<Message> next_to_send() = 0;
  /// A client asks to hand over the touch (the permission to publish as a station), or a server answers.
  virtual void on_hand_over(const msg::HandOver&) {}
  /// The server at the other end offers sealed datagrams. A server makes one offer on a connection.
  virtual void on_datagram_offer(const msg::DatagramOffer&) {}
  /// The other end looks for a path for datagrams; the message's sizes are checked, not its content.
  virtual void on_ice_path(const msg::IcePath&) {}
  /// A part of the server's list of revoked keys.
  virtual void on_revocation_list(const msg::RevocationList&) {}
  /// Current session time, for the replies to the peer's clock probes.
  virtual SessionTime session_now() = 0;
};

/// One connection to one peer with the protocol of WIRE.md, over any ByteStream. Owner: the stream's thread; no locks.
/// It is held by shared_ptr because pending Asio operations may outlive the owner's reference; each operation keeps the
/// connection alive until the operation ends.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  struct Options {
    std::string name{};     ///< name of the program, sent to the peer
    std::string role{};     ///< technician, doctor, recorder, viewer, qa, server
    std::string token{};    ///< of a client without a certificate, proved in Hello (keys::prove_token); empty: none
    std::string consent{};  ///< the patient's, as whoever watches or records states it
    std::string voice_consent{};  ///< the patient's consent to record speech; empty: not stated
    std::uint64_t run = 0;        ///< random number of this run of the program; 0: none
    msg::DatagramCipher datagrams =
        msg::DATAGRAM_CIPHER_NONE;                     ///< of a client: its fastest cipher; NONE: wants no datagrams
    bool finds_paths = false;                          ///< of a client: takes part in on_ice_path()
    bool accepts_touch = false;                        ///< of a station: accepts an offered touch (on_hand_over())
    std::vector<Topic> publishes{};                    ///< topics that next_to_send() may return
    std::size_t max_payload_bytes = kMaxPayloadBytes;  ///< largest payload from this peer after its Hello
    /// Limit on the rate of reading; 0: no limit. Bytes above it stay in the kernel's receive buffer until they are
    /// due, so that TCP's flow control slows this peer alone.
    std::size_t max_read_bytes_per_s = 0;
  };

  /// `owner` must live until on_closed() is called. An owner that is destroyed earlier calls abandon() before.
  Connection(std::unique_ptr<ByteStream> stream, Options options, ConnectionOwner& owner);

  void start();                                            ///< sends Hello, reads, and checks the deadlines
  void wake();                                             ///< call it when next_to_send() has a message again
  void subscribe(const std::vector<std::string>& topics);  ///< replaces the earlier subscription
  void probe_clock();                                      ///< the reply comes to on_clock()
  /// Requests a key frame from the peer, because `unreadable` cannot be decoded without its reference frame.
  void request_key_frame(const Message& unreadable);
  void offer_datagrams(const msg::DatagramOffer& offer);
  void find_path(const msg::IcePath& message);   ///< the message comes to on_ice_path()
  void hand_over(const msg::HandOver& request);  ///< a client's request, or a server's answer to one
  void show_revocations(std::string_view list);  ///< sends a client the list of revoked keys (PEM)
  /// Takes a message that came by datagram as if it had come on this connection: counts it and calls on_message(), or
  /// drops it when a newer one of its topic came before.
  void take_datagram(Message message);
  /// Sends the remaining messages of next_to_send() and a Goodbye, and closes, within 0.5 s. `final`: tells the peer
  /// that another attempt would fail the same way.
  void close(const std::string& reason, bool final = false);
  /// Closes at once; no callback follows.
  void abandon() noexcept;

  [[nodiscard]] bool ready() const noexcept { return phase_ == Phase::Open; }
  /// The reason why another attempt to connect would fail too: the peer speaks another protocol version, or refuses
  /// this end's key or role. nullopt: another attempt may succeed. Error::where is empty.
  [[nodiscard]] const std::optional<Error>& refusal() const noexcept { return refusal_; }
  /// The reason that the peer gave in its Goodbye, as the peer wrote it; nullopt: the peer sent none.
  [[nodiscard]] const std::optional<std::string>& peers_goodbye() const noexcept { return peers_goodbye_; }
  [[nodiscard]] std::string peer() const { return stream_->peer(); }
  [[nodiscard]] bool is_sealed() const { return stream_->is_sealed(); }
  [[nodiscard]] std::optional<keys::Identity> identity() const { return stream_->identity(); }
  [[nodiscard]] std::optional<keys::ServerCertificate> server_certificate() const {
    return stream_->server_certificate();
  }
  /// The TLS exporter's secret for `label`, equal at both ends, from on_ready() on; nullopt without TLS.
  [[nodiscard]] std::optional<std::array<std::byte, 32>> keying_material(std::string_view label) const {
    return stream_->keying_material(label);
  }
  [[nodiscard]] const std::map<std::string_view, ReceivedCount>& received() const noexcept {
    return channels_.received();
  }

 private:
  enum class Phase { Greeting, Open, Leaving, Closed };
  /// How this end closes: its Goodbye (WIRE.md), and what goes before it.
  struct Farewell {
    std::string reason{};
    bool is_final = false;        ///< the Goodbye tells the peer not to try again
    bool after_messages = false;  ///< the owner's queued messages are sent before the Goodbye
    bool is_said = false;
  };

  void read();
  void read_when_due(std::size_t bytes_before);
  void on_bytes(std::span<const std::byte> bytes);
  [[nodiscard]] Result<void> on_frame(Frame frame);
  [[nodiscard]] Result<void> on_control(const Frame& frame);
  [[nodiscard]] Result<void> on_hello(const msg::Hello& hello);
  [[nodiscard]] Result<void> on_subscription(const msg::Subscribe& subscribe);
  [[nodiscard]] Result<void> on_datagram_offer(const msg::DatagramOffer& offer);
  [[nodiscard]] Result<void> on_hand_over(const msg::HandOver& request);
  [[nodiscard]] Result<void> on_ice_path(const msg::IcePath& message);
  [[nodiscard]] Result<void> on_data(Frame frame);
  [[nodiscard]] Result<void> agree_on_version(const msg::Hello& peer);

  void say_hello();
  void send(msg::Control control);
  void write();
  [[nodiscard]] bool begin_frame();
  void leave(const std::string& reason);  ///< sends a Goodbye as farewell_ says, and closes
  void watch(std::chrono::steady_clock::duration patience, std::string reason);
  void finish(const std::string& reason) noexcept;
  void on_lost(const boost::system::error_code& code) noexcept;

  std::unique_ptr<ByteStream> stream_;
  Options options_;
  ConnectionOwner* owner_;  // null once closed or abandoned
  boost::asio::steady_timer deadline_;
  Phase phase_ = Phase::Greeting;
  Farewell farewell_;
  std::optional<Error> refusal_;
  std::optional<std::string> peers_goodbye_;

  std::array<std::byte, 64 << 10> incoming_{};
  boost::asio::steady_timer read_again_;
  ReadPace pace_;
  FrameParser parser_;
  IncomingChannels channels_;
  bool has_offer_ = false;  // a datagram offer was received; a second one would reuse its keys and nonces

  OutgoingFrames outgoing_;
};

}  // namespace telepalp::wire
