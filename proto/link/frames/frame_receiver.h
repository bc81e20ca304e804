#pragma once

#include <bitset>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "proto/link/frames/frame_sender.h"
#include "proto/link/frames/reed_solomon.h"

namespace telepalp::link {

struct ReceiverStatistics {
  std::uint64_t delivered = 0;
  std::uint64_t late = 0;         ///< delivered frames that came after a newer frame of their channel
  std::uint64_t incomplete = 0;   ///< frames given up because shards were missing
  std::uint64_t undecodable = 0;  ///< complete frames given up because the frame they depend on is missing
  std::uint64_t restored_shards = 0;
  std::uint64_t malformed = 0;  ///< refused fragments: frame size out of range, or header unlike the frame's first one
};

/// Assembles frames from fragments in any order. A frame is delivered once, when it is complete. A key frame waits for
/// no other frame; if it is complete only after a newer frame of its channel was delivered, Frame::newest is false, and
/// the caller must not show it. A dependent frame is delivered only after the frame before it, and never after a newer
/// one. Undelivered frames take at most `most_assembling_B` bytes, and are at most kMostFrames a channel: the oldest is
/// given up for a new one. A frame above `most_assembling_B` is refused. Pure: time is an argument. Owner: one thread.
class FrameReceiver {
 public:
  static constexpr std::size_t kMostAssembling_B = std::size_t{32} << 20U;
  static constexpr std::size_t kMostFrames = 16;

  explicit FrameReceiver(Nanoseconds deadline, std::size_t most_assembling_B = kMostAssembling_B)
      : deadline_(deadline), most_assembling_B_(most_assembling_B) {}

  void add(const Fragment& fragment, SessionTime now);
  /// Removes and returns a frame that can be delivered; nullopt: none.
  [[nodiscard]] std::optional<Frame> take();

  /// Gives up frames `deadline` after their newest fragment or three times `deadline` after their first one, and
  /// complete frames whose reference frame is lost. Call it before missing().
  void step(SessionTime now);
  /// Blocks that lack shards, of frames of which no fragment came for 5 ms (longer than packets overtake each other);
  /// by channel, then oldest frame first; at most kMostMissing.
  [[nodiscard]] std::vector<Missing> missing(SessionTime now) const;
  /// Bit n: channel n cannot deliver frames until a key frame comes.
  [[nodiscard]] std::uint16_t key_frames_wanted() const noexcept { return key_frames_wanted_; }

  [[nodiscard]] std::size_t assembling_B() const noexcept { return assembling_B_; }
  [[nodiscard]] const ReceiverStatistics& statistics() const noexcept { return statistics_; }

 private:
  struct Block {
    std::vector<bool> has_data;
    std::size_t data_received = 0;
    std::vector<RepairShard> repairs{};
    bool complete = false;
  };
  struct Assembly {
    FragmentHeader header;
    FrameLayout layout;
    std::vector<std::byte> body;
    std::vector<Block> blocks{};
    std::size_t blocks_complete = 0;
    SessionTime first_at;
    SessionTime last_at{};  ///< arrival of the newest fragment
    [[nodiscard]] bool complete() const noexcept { return blocks_complete == blocks.size(); }
  };
  /// Remembers which of a channel's newest kSize frame numbers were delivered.
  class Delivered {
   public:
    [[nodiscard]] bool contains(std::uint32_t number) const noexcept {
      return any_ && number <= newest_ && newest_ - number < kSize && seen_[number % kSize];
    }
    /// False: frame `number` was delivered, or is older than the newest delivered frame by kSize or more.
    [[nodiscard]] bool allows(std::uint32_t number) const noexcept {
      return is_newest(number) || (newest_ - number < kSize && !seen_[number % kSize]);
    }
    [[nodiscard]] bool is_newest(std::uint32_t number) const noexcept { return !any_ || number > newest_; }
    void insert(std::uint32_t number) noexcept;

   private:
    static constexpr std::uint32_t kSize = 64;
    bool any_ = false;
    std::uint32_t newest_ = 0;
    std::bitset<kSize> seen_;
  };
  struct Channel {
    std::map<std::uint32_t, Assembly> frames;  ///< by number
    Delivered delivered;
  };
  [[nodiscard]] Assembly* assembly_for(Channel& channel, const FragmentHeader& header, SessionTime now);
  void add_shard(Assembly& frame, const Fragment& fragment);
  void restore(Assembly& frame, std::size_t block);
  [[nodiscard]] Frame delivered_from(Channel& channel, const Assembly& done);
  [[nodiscard]] bool can_deliver(const Channel& channel, const Assembly& frame) const noexcept;
  std::map<std::uint32_t, Assembly>::iterator drop(Channel& channel, std::map<std::uint32_t, Assembly>::iterator frame);
  void give_up(Channel& channel, std::map<std::uint32_t, Assembly>::iterator frame);
  void make_room(Channel& channel, std::size_t bytes);

  Nanoseconds deadline_;
  std::size_t most_assembling_B_;
  std::map<std::uint8_t, Channel> channels_;
  std::size_t assembling_B_ = 0;
  std::uint16_t key_frames_wanted_ = 0;
  ReceiverStatistics statistics_;
};

}  // namespace telepalp::link
