#pragma once

#include <array>
#include <boost/asio/steady_timer.hpp>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "messages/control.pb.h"
#include "proto/wire/byte_stream.h"
#include "proto/wire/clock_sync.h"
#include "proto/wire/frame.h"
#include "proto/wire/message.h"

namespace telepalp::wire {

inline constexpr std::chrono::seconds kHandshakeDeadline{5};  ///< from the first byte possible to the peer's Hello
inline constexpr std::chrono::seconds kSilenceDeadline{5};    ///< between two whole frames of a peer

/// What a Connection tells its owner, and asks of it. All calls come on the connection's thread.
class ConnectionOwner {
 public:
  virtual ~ConnectionOwner() = default;
  /// Whether this peer may publish `topic` at all; a peer that advertises another one is left.
  virtual bool accepts(const Topic& topic) = 0;
  /// The peer's Hello has come and fits. Messages may follow.
  virtual void on_ready(const msg::Hello& peer) = 0;
  virtual void on_message(Message message) = 0;
  virtual void on_subscribe(std::vector<std::string> topics) = 0;
  virtual void on_clock(const ClockSample& sample) = 0;
  /// The peer could not read the message of `topic` published at `published`, for want of the one before it.
  virtual void on_want_key(const Topic& topic, SessionTime published) = 0;
  /// The last call: nothing is asked or told after it. `reason` is for people.
  virtual void on_closed(const std::string& reason) = 0;
  /// The next message to send; nullopt: none now, and wake() follows when there is one. The owner's bounded
  /// queue is the only one: the connection holds just the message that it is writing.
  virtual std::optional<Message> next_to_send() = 0;
  /// The session time with which the peer's clock probes are answered.
  virtual SessionTime session_now() = 0;
};

/// What a connection has seen of one topic.
struct ReceivedCount {
  std::uint64_t messages = 0;
  std::uint64_t missed = 0;  ///< gaps in the numbers: what the sender dropped for us
};

/// One conversation of WIRE.md with one peer, over any ByteStream. Owner: the stream's thread; no locks.
/// Held by shared_ptr because operations pending in the io_context outlive the owner's wish to be rid of it: each
/// keeps the connection alive until it has ended.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  struct Options {
    std::string name{};                                ///< of the program, told to the peer
    std::string role{};                                ///< technician, doctor, viewer, qa, server
    std::uint64_t run = 0;                             ///< random number of this run of the program; 0: none
    std::vector<Topic> publishes{};                    ///< the topics that next_to_send() may give
    std::size_t max_payload_bytes = kMaxPayloadBytes;  ///< taken from this peer once its Hello has come
    /// More is left in the kernel until its time comes, so that the peer is held up and nobody else; 0: no limit.
    std::size_t max_read_bytes_per_s = 0;
  };

  /// `owner` outlives the connection's on_closed(), or calls abandon() first.
  Connection(std::unique_ptr<ByteStream> stream, Options options, ConnectionOwner& owner);

  void start();                                            ///< greets, reads, watches the deadlines
  void wake();                                             ///< there is something to send
  void subscribe(const std::vector<std::string>& topics);  ///< replaces what was asked for before
  void probe_clock();
  /// Asks the peer for a message that stands alone, since `unreadable` does not.
  void want_key(const Message& unreadable);
  /// Sends what next_to_send() still has, says Goodbye and closes, at the latest after half a second.
  void close(const std::string& reason);
  /// Closes at once; the owner hears nothing more.
  void abandon() noexcept;

  [[nodiscard]] bool ready() const noexcept { return phase_ == Phase::Open; }
  /// True once the peer's first frame or its Hello told another protocol version: another try would end the same way.
  [[nodiscard]] bool peer_has_other_version() const noexcept { return other_version_; }
  [[nodiscard]] std::string peer() const { return stream_->peer(); }
  [[nodiscard]] const std::map<std::string_view, ReceivedCount>& received() const noexcept { return received_; }

 private:
  enum class Phase { Greeting, Open, Leaving, Closed };
  struct Incoming {
    std::optional<Topic> topic;  ///< none: a topic that this end does not know; its messages are passed over
    std::uint64_t last_sequence = 0;
  };

  void read();
  void read_when_due(std::size_t bytes_before);
  void on_bytes(std::span<const std::byte> bytes);
  [[nodiscard]] Result<void> on_frame(Frame frame);
  [[nodiscard]] Result<void> on_control(const Frame& frame);
  [[nodiscard]] Result<void> on_hello(const msg::Hello& hello);
  [[nodiscard]] Result<void> on_advertise(const msg::Advertise& advertise);
  [[nodiscard]] Result<void> on_subscription(const msg::Subscribe& subscribe);
  void on_clock_reply(const msg::ClockReply& reply);
  [[nodiscard]] Result<void> on_data(Frame frame);

  void send(msg::Control control);
  void write();
  void write_control(msg::Control control);
  void write_frame(FrameHeader header, std::shared_ptr<const std::string> payload);
  void leave(const std::string& reason);  ///< the same without sending what is queued: the peer is not to be trusted
  void watch(std::chrono::steady_clock::duration patience, std::string reason);
  void finish(const std::string& reason) noexcept;
  void on_lost(const boost::system::error_code& code) noexcept;

  std::unique_ptr<ByteStream> stream_;
  Options options_;
  ConnectionOwner* owner_;  // null once closed or abandoned
  boost::asio::steady_timer deadline_;
  boost::asio::steady_timer read_again_;
  std::chrono::steady_clock::time_point read_due_{};  // by max_read_bytes_per_s
  Phase phase_ = Phase::Greeting;
  std::string leaving_because_;
  bool other_version_ = false;

  std::array<std::byte, 64 << 10> incoming_{};
  FrameParser parser_;
  std::map<std::uint32_t, Incoming> channels_;
  std::map<std::string_view, ReceivedCount> received_;

  std::deque<msg::Control> control_;  // bounded: a peer that asks and does not listen is left
  std::uint64_t control_sequence_ = 0;
  bool writing_ = false;
  bool drains_ = false;  // while leaving: the owner's queue goes out before the Goodbye
  bool said_goodbye_ = false;
  HeaderBytes header_being_written_{};
  std::shared_ptr<const std::string> payload_being_written_;
  std::deque<Nanoseconds> asked_;  // of the clock probes under way, oldest first; bounded
};

}  // namespace telepalp::wire
