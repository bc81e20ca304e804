#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <boost/asio/buffer.hpp>

#include "messages/control.pb.h"
#include "proto/wire/clock_sync.h"
#include "proto/wire/frame.h"
#include "proto/wire/message.h"

namespace telepalp::wire {

/// The writing side of one connection: one frame at a time, control messages before data. Clock probes are part of it,
/// because they are stamped when they are written. No socket.
class OutgoingFrames {
 public:
  /// `publishes`: the topics of begin(Message); their channels are their positions from 1. `session_now`: session time,
  /// for the replies to the peer's clock probes.
  OutgoingFrames(std::vector<Topic> publishes, std::function<SessionTime()> session_now)
      : publishes_(std::move(publishes)), session_now_(std::move(session_now)) {}

  /// The version of the frames from now on; before, the oldest.
  void speak(std::uint8_t version) noexcept { version_ = version; }

  /// The message that tells the peer of the topics.
  [[nodiscard]] msg::Control advertise() const;

  /// Queues a control message. False: kMaxWaiting wait, because the peer reads none.
  [[nodiscard]] bool add(msg::Control control);

  [[nodiscard]] bool is_writing() const noexcept { return payload_ != nullptr; }
  /// The oldest control message becomes the frame that is written. False: none waits.
  [[nodiscard]] bool begin_control();
  void begin(msg::Control control);
  void begin(Message message);
  /// Header and payload of the frame that is written; valid until end().
  [[nodiscard]] std::vector<boost::asio::const_buffer> buffers() const;
  void end() noexcept { payload_.reset(); }

  /// The sample of a probe and its reply, which came at `heard` on the local clock; nullopt: no probe of this
  /// connection, or an impossible time.
  [[nodiscard]] std::optional<ClockSample> sample(const msg::ClockReply& reply, Nanoseconds heard);

 private:
  static constexpr std::size_t kMaxWaiting = 64;
  void begin(FrameHeader header, std::shared_ptr<const std::string> payload);

  std::vector<Topic> publishes_;
  std::function<SessionTime()> session_now_;
  std::uint8_t version_ = kOldestProtocolVersion;
  std::deque<msg::Control> control_;  // bounded: a peer that sends requests without reading replies is disconnected
  std::uint64_t control_sequence_ = 0;
  std::deque<Nanoseconds> asked_;  // send times of unanswered clock probes, oldest first; bounded
  HeaderBytes header_{};
  std::shared_ptr<const std::string> payload_;  // null: nothing is written
};

}  // namespace telepalp::wire
