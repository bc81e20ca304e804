#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "proto/link/frames/frame_receiver.h"
#include "proto/link/frames/frame_sender.h"
#include "proto/link/path/content_level.h"
#include "proto/link/path/loss_meter.h"
#include "proto/link/path/path_estimate.h"
#include "proto/link/seal/sealed_channel.h"

namespace telepalp::link {

enum class End { Client, Server };

struct DatagramLinkSettings {
  SealSettings seal;
  /// A frame is repaired until `deadline` after its capture; its fragments are kept for `deadline` after the first one.
  Nanoseconds deadline = std::chrono::milliseconds(100);
  bool takes_frames = true;  ///< false: fragments from the peer are ignored, and take no memory
  std::size_t most_assembling_B = FrameReceiver::kMostAssembling_B;  ///< bound on the memory of incomplete frames [B]
};

/// One end of a sealed (encrypted and authenticated) link that carries frames with a deadline, in both directions.
/// Pure: the caller sends and receives the datagrams, and passes session time, which is equal at both ends. Owner: one
/// thread.
class DatagramLink {
 public:
  DatagramLink(const DatagramLinkSettings& settings, End end);

  /// Queues a frame; returns the number of the waiting frame that it replaces; nullopt: none. If a frame was replaced
  /// and frames of its channel depend on each other, the next frame that is offered must be a key frame.
  std::optional<std::uint32_t> offer(std::shared_ptr<const SharedFrame> frame) {
    return sender_.offer(std::move(frame));
  }
  std::optional<std::uint32_t> offer(Frame frame) { return sender_.offer(std::move(frame)); }

  /// True when a frame that is offered now starts at once: no other frame waits, and the path has room. A caller with a
  /// queue of its own offers a frame only then, so that it can still replace a queued frame by a newer one.
  [[nodiscard]] bool ready_for_frame(SessionTime now) noexcept { return sender_.idle() && path_.has_room(now); }
  /// The same for an urgent frame (SharedFrame::Label), which does not wait for the frames that have started.
  [[nodiscard]] bool ready_for_urgent(SessionTime now) noexcept {
    return sender_.idle_for_urgent() && path_.has_room_for_urgent(now);
  }

  /// Lets next() return a report (Feedback in format/fragment.h) although nothing was received. Reports in both
  /// directions keep a NAT's mapping and show that the path works.
  void want_report() noexcept { unreported_ = true; }

  /// When to call next() again if nothing is received; nullopt: only after offer() or want_report().
  [[nodiscard]] std::optional<SessionTime> due(SessionTime now) const noexcept;

  /// The next datagram to send now; nullopt: nothing to send. Call again at due(), and after offer() or received().
  [[nodiscard]] std::optional<Datagram> next(SessionTime now);
  /// The same, into memory of the caller, to which the seal writes. False: nothing to send.
  [[nodiscard]] bool next(SessionTime now, Datagram& into);

  /// Writes a challenge with `nonce` into `into`, for an address at which the peer has not proved yet that it receives.
  /// False: the sender is silent, because it has used all its keys.
  [[nodiscard]] bool challenge(std::uint64_t nonce, SessionTime now, Datagram& into);
  /// The nonce of the peer's newest response to a challenge; nullopt: none since the last call.
  [[nodiscard]] std::optional<std::uint64_t> take_response() noexcept { return std::exchange(response_, std::nullopt); }

  /// Processes a received datagram. nullopt: it is forged, damaged or repeated; the caller must not answer. True: it is
  /// the peer's newest so far, so its source address may become the peer's address. False: it is older.
  std::optional<bool> received(std::span<const std::byte> datagram, SessionTime now);

  /// The next complete frame; nullopt: none.
  [[nodiscard]] std::optional<Frame> take(SessionTime now);

  /// Bit n: the peer needs a key frame of channel n. The call clears all bits.
  [[nodiscard]] std::uint16_t key_frames_wanted() noexcept { return std::exchange(peer_wants_, std::uint16_t{0}); }

  [[nodiscard]] const PathEstimate& path() const noexcept { return path_; }
  [[nodiscard]] const SenderStatistics& sender() const noexcept { return sender_.statistics(); }
  [[nodiscard]] const ReceiverStatistics& receiver() const noexcept { return receiver_.statistics(); }
  [[nodiscard]] const OpenerStatistics& opener() const noexcept { return opener_.statistics(); }

 private:
  [[nodiscard]] bool seal(std::span<const std::byte> head, std::span<const std::byte> tail, SessionTime now,
                          Datagram& into);
  [[nodiscard]] std::optional<std::vector<std::byte>> feedback_due(SessionTime now);
  void count(const Opened& opened, std::size_t bytes, SessionTime now);

  Sealer sealer_;
  Opener opener_;
  FrameSender sender_;
  FrameReceiver receiver_;
  bool takes_frames_;
  PathEstimate path_;
  LossMeter losses_;
  std::uint64_t highest_sequence_ = 0;
  std::uint64_t received_bytes_ = 0;
  SessionTime highest_at_{};
  SessionTime reported_at_{};
  bool unreported_ = false;
  Nanoseconds newest_age_{0};
  std::uint16_t peer_wants_ = 0;
  std::optional<std::uint64_t> challenged_;  // nonce of the peer's challenge, not answered yet
  std::optional<std::uint64_t> response_;
};

}  // namespace telepalp::link
