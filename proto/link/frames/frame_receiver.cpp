#include "proto/link/frames/frame_receiver.h"

#include <algorithm>
#include <utility>

#include "proto/link/frames/frame_body.h"

namespace telepalp::link {
namespace {

using namespace std::chrono_literals;

/// After this time without a fragment of a frame, its missing fragments count as lost: packets overtake each other by
/// less.
constexpr Nanoseconds kReordering = 5ms;
constexpr int kMostDeadlines = 3;  ///< after this many deadlines, a frame is given up even if fragments come

std::uint16_t bit_of(std::uint8_t channel) noexcept { return static_cast<std::uint16_t>(1U << channel); }

}  // namespace

void FrameReceiver::add(const Fragment& fragment, SessionTime now) {
  Channel& channel = channels_[fragment.header.channel];
  if (!channel.delivered.allows(fragment.header.frame)) return;
  Assembly* const frame = assembly_for(channel, fragment.header, now);
  if (frame == nullptr) return;
  frame->last_at = now;
  add_shard(*frame, fragment);
}

/// The frame that the fragment belongs to, a new one if needed; nullptr: the fragment contradicts the frame.
FrameReceiver::Assembly* FrameReceiver::assembly_for(Channel& channel, const FragmentHeader& header, SessionTime now) {
  if (const auto known = channel.frames.find(header.frame); known != channel.frames.end()) {
    const FragmentHeader& first = known->second.header;
    const bool agrees = first.frame_bytes == header.frame_bytes && first.key_frame == header.key_frame;
    if (!agrees) ++statistics_.malformed;
    return agrees ? &known->second : nullptr;
  }
  const FrameLayout layout(header.frame_bytes);
  const std::size_t bytes = layout.data_shards * layout.shard_bytes;
  if (header.frame_bytes <= kStampBytes || bytes > most_assembling_B_) {
    ++statistics_.malformed;
    return nullptr;
  }
  make_room(channel, bytes);
  assembling_B_ += bytes;
  Assembly frame{.header = header, .layout = layout, .body = std::vector<std::byte>(bytes), .first_at = now};
  for (std::size_t block = 0; block < layout.blocks; ++block)
    frame.blocks.push_back({.has_data = std::vector<bool>(layout.data_in_block(block))});
  return &channel.frames.emplace(header.frame, std::move(frame)).first->second;
}

/// Gives up the oldest frames of the channel, then of the others, until `bytes` more fit.
void FrameReceiver::make_room(Channel& channel, std::size_t bytes) {
  while (channel.frames.size() >= kMostFrames) give_up(channel, channel.frames.begin());
  for (const bool of_this : {true, false})
    for (auto& [number, other] : channels_)
      while ((&other == &channel) == of_this && assembling_B_ + bytes > most_assembling_B_ && !other.frames.empty())
        give_up(other, other.frames.begin());
}

void FrameReceiver::add_shard(Assembly& frame, const Fragment& fragment) {
  Block& block = frame.blocks[fragment.header.block];
  if (block.complete) return;
  const std::size_t shard = fragment.header.shard;
  if (shard < block.has_data.size()) {
    if (block.has_data[shard]) return;
    block.has_data[shard] = true;
    ++block.data_received;
    std::copy(fragment.shard.begin(), fragment.shard.end(),
              frame.body.data() + frame.layout.offset(fragment.header.block, shard));
  } else {
    const auto row = static_cast<std::uint8_t>(shard - block.has_data.size());
    for (const RepairShard& known : block.repairs)
      if (known.row == row) return;
    block.repairs.push_back({row, {fragment.shard.begin(), fragment.shard.end()}});
  }
  if (block.data_received + block.repairs.size() < block.has_data.size()) return;
  restore(frame, fragment.header.block);
  block.complete = true;
  ++frame.blocks_complete;
}

void FrameReceiver::restore(Assembly& frame, std::size_t number) {
  Block& block = frame.blocks[number];
  std::vector<std::byte*> data;
  std::vector<std::uint8_t> missing;
  for (std::size_t i = 0; i < block.has_data.size(); ++i) {
    data.push_back(frame.body.data() + frame.layout.offset(number, i));
    if (!block.has_data[i]) missing.push_back(static_cast<std::uint8_t>(i));
  }
  restore_data_shards(data, missing, frame.layout.shard_bytes, block.repairs);
  statistics_.restored_shards += missing.size();
  block.repairs.clear();
}

void FrameReceiver::Delivered::insert(std::uint32_t number) noexcept {
  if (is_newest(number)) {
    const std::uint32_t skipped = any_ ? std::min(number - newest_, kSize) : kSize;
    for (std::uint32_t i = 0; i < skipped; ++i) seen_[(number - i) % kSize] = false;
    newest_ = number;
    any_ = true;
  }
  seen_[number % kSize] = true;
}

bool FrameReceiver::can_deliver(const Channel& channel, const Assembly& frame) const noexcept {
  if (!frame.complete()) return false;
  const std::uint32_t number = frame.header.frame;
  return frame.header.key_frame || (channel.delivered.is_newest(number) && channel.delivered.contains(number - 1));
}

std::optional<Frame> FrameReceiver::take() {
  for (auto& [number, channel] : channels_) {
    const auto next = std::find_if(channel.frames.begin(), channel.frames.end(),
                                   [this, &of = channel](const auto& entry) { return can_deliver(of, entry.second); });
    if (next == channel.frames.end()) continue;
    Frame frame = delivered_from(channel, next->second);
    drop(channel, next);
    return frame;
  }
  return std::nullopt;
}

Frame FrameReceiver::delivered_from(Channel& channel, const Assembly& done) {
  const std::uint32_t number = done.header.frame;
  const bool newest = channel.delivered.is_newest(number);
  channel.delivered.insert(number);
  ++statistics_.delivered;
  if (newest)
    key_frames_wanted_ = static_cast<std::uint16_t>(key_frames_wanted_ & ~bit_of(done.header.channel));
  else
    ++statistics_.late;
  return {.channel = done.header.channel,
          .number = number,
          .key_frame = done.header.key_frame,
          .captured = stamp_of(done.body),
          .bytes = {done.body.begin() + kStampBytes, done.body.begin() + done.header.frame_bytes},
          .newest = newest};
}

std::map<std::uint32_t, FrameReceiver::Assembly>::iterator FrameReceiver::drop(
    Channel& channel, std::map<std::uint32_t, Assembly>::iterator frame) {
  assembling_B_ -= frame->second.body.size();
  return channel.frames.erase(frame);
}

void FrameReceiver::give_up(Channel& channel, std::map<std::uint32_t, Assembly>::iterator frame) {
  ++(frame->second.complete() ? statistics_.undecodable : statistics_.incomplete);
  if (!frame->second.header.key_frame && channel.delivered.is_newest(frame->first))
    key_frames_wanted_ |= bit_of(frame->second.header.channel);
  drop(channel, frame);
}

void FrameReceiver::step(SessionTime now) {
  for (auto& [number, channel] : channels_)
    for (auto frame = channel.frames.begin(); frame != channel.frames.end();) {
      const auto next = std::next(frame);
      const Assembly& one = frame->second;
      const bool chain_broken = one.complete() && !can_deliver(channel, one) && now - one.last_at > kReordering &&
                                !channel.frames.contains(frame->first - 1);
      const bool late = now - one.last_at > deadline_ || now - one.first_at > kMostDeadlines * deadline_;
      if (late || chain_broken) give_up(channel, frame);
      frame = next;
    }
}

std::vector<Missing> FrameReceiver::missing(SessionTime now) const {
  std::vector<Missing> list;
  for (const auto& [number, channel] : channels_)
    for (const auto& [frame_number, frame] : channel.frames) {
      if (frame.complete() || now - frame.last_at < kReordering) continue;
      for (std::size_t i = 0; i < frame.blocks.size() && list.size() < kMostMissing; ++i) {
        const Block& block = frame.blocks[i];
        const std::size_t lacks =
            block.has_data.size() - std::min(block.has_data.size(), block.data_received + block.repairs.size());
        if (lacks > 0)
          list.push_back({number, frame_number, static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(lacks)});
      }
    }
  return list;
}

}  // namespace telepalp::link
