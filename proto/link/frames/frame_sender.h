#pragma once

#include <array>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "proto/link/format/fragment.h"
#include "proto/link/frames/shared_frame.h"
#include "proto/link/path/path_estimate.h"
#include "proto/words/time.h"

namespace telepalp::link {

/// A message that is worthless when it is late (topics: proto/wire/datagram_message.h), as FrameReceiver returns it.
struct Frame {
  std::uint8_t channel = 0;
  std::uint32_t number = 0;  ///< counts the channel's frames at the source
  bool key_frame = true;     ///< false: it needs frame `number - 1`
  SessionTime captured{};
  std::vector<std::byte> bytes{};
  bool newest = true;  ///< set by the receiver: no newer frame of the channel was delivered before
};

/// `frame`, to be sent.
[[nodiscard]] std::shared_ptr<const SharedFrame> shared(Frame frame);

struct SenderStatistics {
  std::uint64_t started = 0;
  std::uint64_t replaced = 0;  ///< dropped unsent, because a newer frame was offered
  /// Dropped unsent, because they would arrive later than 2 * `deadline` after their capture; or, if the one-way delay
  /// (half the least round trip) exceeds `deadline`, because they were older than `deadline`.
  std::uint64_t expired = 0;
  std::uint64_t data_shards = 0;
  std::uint64_t repair_shards = 0;
  std::uint64_t requested_shards = 0;  ///< repair shards that were sent on request
};

/// Times from the first datagrams of an echoed frame to its echoes, on a path with this share of losses. A burst that
/// lasts longer takes all of them; then the next voice messages help, because each repeats the speech of those before
/// it. With four echoes, hardly any burst takes more than two messages.
[[nodiscard]] std::span<const Nanoseconds> echoes_after(double loss) noexcept;

/// Cuts frames into fragments. At most one frame of each channel waits, and a newer one replaces it. A started frame is
/// sent completely; an urgent one (SharedFrame::Label) is sent before what is left of it. `deadline` counts from the
/// frame's capture. Pure: time and the path are arguments. Owner: one thread.
class FrameSender {
 public:
  explicit FrameSender(Nanoseconds deadline) : deadline_(deadline) {}

  /// The frame waits until the path has room. Returns the number of the waiting frame that it replaces.
  std::optional<std::uint32_t> offer(std::shared_ptr<const SharedFrame> frame);
  std::optional<std::uint32_t> offer(Frame frame) { return offer(shared(std::move(frame))); }

  /// The payload of the next datagram: a header, and a shard that is read in place.
  struct Next {
    std::array<std::byte, kFragmentHeaderBytes> header{};
    std::span<const std::byte> shard{};  ///< follows the header; lies in `frame`
    std::shared_ptr<const SharedFrame> frame{};
    [[nodiscard]] std::size_t bytes() const noexcept { return header.size() + shard.size(); }
    [[nodiscard]] std::vector<std::byte> joined() const;  ///< a copy of the payload, in one piece
  };
  /// nullopt: nothing to send, or no room on the path.
  [[nodiscard]] std::optional<Next> next(SessionTime now, PathEstimate& path);

  /// True when no frame waits and each started frame is sent, apart from requested repairs: a new frame can start.
  [[nodiscard]] bool idle() const noexcept { return first_round_.empty() && urgent_.empty() && waiting_.empty(); }
  /// True when an urgent frame that is offered now is sent before all others.
  [[nodiscard]] bool idle_for_urgent() const noexcept;
  /// True while fragments wait for room on the path.
  [[nodiscard]] bool holds_fragments() const noexcept {
    return !first_round_.empty() || !requested_.empty() || !urgent_.empty();
  }

  /// When the next echo is due; nullopt: none waits.
  [[nodiscard]] std::optional<SessionTime> echo_due() const noexcept {
    return echoes_.empty() ? std::nullopt : std::optional(echoes_.front().at);
  }

  /// Queues further repair shards for the blocks `missing`, if they can arrive before the frame's deadline. Ignores a
  /// block while shards of it are queued or on their way, because the receiver does not know of these.
  void on_missing(std::span<const Missing> missing, SessionTime now, const PathEstimate& path);

  [[nodiscard]] const SenderStatistics& statistics() const noexcept { return statistics_; }

 private:
  struct Block {
    std::size_t next_row = 0;  ///< row of the first repair shard that is not queued yet
    std::size_t unsent = 0;    ///< number of this block's shards that are queued and not sent
    SessionTime sent_at{};     ///< when this block's newest shard was sent
  };
  struct Outgoing {
    FragmentHeader header;
    std::shared_ptr<const SharedFrame> frame;  ///< shared with the other links that send it
    std::vector<Block> blocks;
  };
  struct Piece {
    std::uint64_t outgoing;  ///< index of the frame among all started frames
    std::uint8_t block;
    std::uint8_t shard;
  };
  struct Echo {
    SessionTime at;
    std::uint64_t outgoing;
  };
  void add_echo(const Echo& echo);
  void queue_echoes(SessionTime now);
  void drop_late(SessionTime now, const PathEstimate& path);
  void start_urgent(SessionTime now, const PathEstimate& path);
  void start_newest(SessionTime now, const PathEstimate& path);
  void start(std::shared_ptr<const SharedFrame> frame, SessionTime now, const PathEstimate& path,
             std::deque<Piece>& to);
  [[nodiscard]] std::deque<Piece>& next_queue() noexcept;
  void queue_repairs(std::uint64_t place, Outgoing& outgoing, std::size_t block, std::size_t count,
                     std::deque<Piece>& to);
  [[nodiscard]] Next send(const Piece& piece, SessionTime now);
  [[nodiscard]] std::optional<std::size_t> find(const Missing& missing) const noexcept;
  void forget_old();

  Nanoseconds deadline_;
  std::map<std::uint8_t, std::shared_ptr<const SharedFrame>> waiting_;  ///< by channel
  std::uint8_t last_channel_ = kMostChannels;  ///< channel of the frame started last: channels take turns
  std::deque<Outgoing> sent_;                  ///< started frames, kept for repairs
  std::uint64_t forgotten_ = 0;                ///< number of frames removed from the front of sent_
  std::deque<Piece> urgent_;                   ///< of urgent frames, with their echoes
  std::deque<Piece> first_round_;
  std::deque<Piece> requested_;
  std::deque<Echo> echoes_;
  SenderStatistics statistics_;
};

}  // namespace telepalp::link
