#include "proto/link/frames/shared_frame.h"

#include <algorithm>
#include <utility>

#include "proto/link/frames/frame_body.h"
#include "proto/link/frames/reed_solomon.h"
#include "proto/words/demand.h"
#include "proto/words/little_endian.h"

namespace telepalp::link {

SharedFrame::SharedFrame(const Label& label, std::span<const std::byte> prefix, std::span<const std::byte> payload,
                         std::shared_ptr<const void> owner)
    : label_(label),
      payload_(payload),
      owner_(std::move(owner)),
      bytes_(kStampBytes + prefix.size() + payload.size()),
      layout_(bytes_),
      lead_(kStampBytes + prefix.size()),
      first_inside_((lead_ + layout_.shard_bytes - 1) / layout_.shard_bytes),
      end_inside_(std::max(first_inside_, bytes_ / layout_.shard_bytes)),
      repairs_(layout_.blocks) {
  demand(label.channel < kMostChannels && bytes_ > kStampBytes && bytes_ <= kMostFrameBytes,
         "a frame names a channel that exists, is not empty, and is not larger than a frame may be");
  const std::size_t shard_bytes = layout_.shard_bytes;
  head_.resize(first_inside_ * shard_bytes);
  gather(0, prefix, head_);
  if (end_inside_ >= layout_.data_shards) return;
  tail_.resize((layout_.data_shards - end_inside_) * shard_bytes);
  gather(end_inside_ * shard_bytes, prefix, tail_);
}

/// The frame's bytes from `from` on: time stamp, prefix, payload, zeros.
void SharedFrame::gather(std::size_t from, std::span<const std::byte> prefix, std::span<std::byte> into) const {
  std::vector<std::byte> lead(lead_);
  put_little_endian<std::int64_t>(lead.data(), to_nanoseconds(label_.captured));
  std::ranges::copy(prefix, lead.begin() + kStampBytes);
  const auto part = [&](std::span<const std::byte> bytes, std::size_t at) {
    const std::size_t begin = std::max(at, from);
    const std::size_t end = std::min(at + bytes.size(), from + into.size());
    if (begin < end)
      std::ranges::copy(bytes.subspan(begin - at, end - begin),
                        into.begin() + static_cast<std::ptrdiff_t>(begin - from));
  };
  part(lead, 0);
  part(payload_, lead_);
}

std::span<const std::byte> SharedFrame::data_shard(std::size_t place) const noexcept {
  const std::size_t size = layout_.shard_bytes;
  if (place < first_inside_) return std::span(head_).subspan(place * size, size);
  if (place < end_inside_) return payload_.subspan(place * size - lead_, size);
  return std::span(tail_).subspan((place - end_inside_) * size, size);
}

std::span<const std::byte> SharedFrame::shard(std::size_t block, std::size_t shard) const noexcept {
  const std::size_t data = layout_.data_in_block(block);
  return shard < data ? data_shard(shard * layout_.blocks + block)
                      : std::span<const std::byte>(repairs_[block][shard - data]);
}

void SharedFrame::make_repairs(std::size_t block, std::size_t rows) const {
  std::vector<std::vector<std::byte>>& made = repairs_[block];
  const std::size_t first = made.size();
  if (rows <= first) return;
  std::vector<const std::byte*> data;
  for (std::size_t i = 0; i < layout_.data_in_block(block); ++i) data.push_back(shard(block, i).data());
  made.resize(rows, std::vector<std::byte>(layout_.shard_bytes));
  std::vector<std::byte*> out;
  for (std::size_t row = first; row < rows; ++row) out.push_back(made[row].data());
  make_repair_shards(data, layout_.shard_bytes, first, out);
}

}  // namespace telepalp::link
