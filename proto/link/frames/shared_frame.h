#pragma once

#include <memory>
#include <span>
#include <vector>

#include "proto/link/format/fragment.h"
#include "proto/words/time.h"

namespace telepalp::link {

/// A frame that is sent, cut into shards. Several links may send it at the same time: they share its payload, which is
/// not copied, and its repair shards, which are computed once. Only the shards at both ends, which hold more than
/// payload, have bytes of their own. Owner: one thread.
class SharedFrame {
 public:
  struct Label {
    std::uint8_t channel = 0;
    std::uint32_t number = 0;  ///< as Frame::number
    bool key_frame = true;
    SessionTime captured{};
    /// On a path with losses, it is sent again after kEchoesAfter: for short frames that are soon too late.
    bool echoed = false;
    /// It overtakes the unsent datagrams of frames that have started: for short frames that must not wait for an image.
    bool urgent = false;
  };
  /// `prefix`: bytes before the payload. `owner` keeps the memory of `payload`, which does not change. Aborts if the
  /// channel is not below kMostChannels, there are no bytes, or they exceed kMostFrameBytes with the time stamp's
  /// bytes.
  SharedFrame(const Label& label, std::span<const std::byte> prefix, std::span<const std::byte> payload,
              std::shared_ptr<const void> owner);

  [[nodiscard]] const Label& label() const noexcept { return label_; }
  [[nodiscard]] const FrameLayout& layout() const noexcept { return layout_; }
  [[nodiscard]] std::size_t bytes() const noexcept { return bytes_; }  ///< with time stamp, without padding

  /// A data shard of the block, or from data_in_block() on a repair shard, which make_repairs() has made. Valid while
  /// this object lives.
  [[nodiscard]] std::span<const std::byte> shard(std::size_t block, std::size_t shard) const noexcept;
  /// Makes the repair shards of the block in rows below `rows` that no link has needed before.
  void make_repairs(std::size_t block, std::size_t rows) const;

 private:
  void gather(std::size_t from, std::span<const std::byte> prefix, std::span<std::byte> into) const;
  [[nodiscard]] std::span<const std::byte> data_shard(std::size_t place) const noexcept;

  Label label_;
  std::span<const std::byte> payload_;
  std::shared_ptr<const void> owner_;
  std::size_t bytes_;
  FrameLayout layout_;
  std::size_t lead_;          // bytes before the payload
  std::size_t first_inside_;  // the shards [first_inside_, end_inside_), in order of the frame, lie in the payload
  std::size_t end_inside_;
  std::vector<std::byte> head_;                                       // the shards before them
  std::vector<std::byte> tail_;                                       // the shards behind them, padded by zeros
  mutable std::vector<std::vector<std::vector<std::byte>>> repairs_;  // by block and row
};

}  // namespace telepalp::link
