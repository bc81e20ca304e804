#include "proto/link/frames/frame_sender.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace telepalp::link {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t kMostKept = 32;  ///< started frames that are kept for repair requests
/// While so many started frames are kept, no urgent one starts: an image that never gets its turn must not let them
/// grow without bound.
constexpr std::size_t kMostBesideAnImage = 2 * kMostKept;

/// A path that loses more gets echoes, and one that loses more than kManyEchoesLoss gets more of them.
constexpr double kEchoLoss = 0.02;
constexpr double kManyEchoesLoss = 0.05;
constexpr std::array<Nanoseconds, 2> kEchoesAfter{7ms, 14ms};
constexpr std::array<Nanoseconds, 4> kManyEchoesAfter{3ms, 6ms, 10ms, 15ms};

}  // namespace

std::shared_ptr<const SharedFrame> shared(Frame frame) {
  const auto bytes = std::make_shared<const std::vector<std::byte>>(std::move(frame.bytes));
  return std::make_shared<const SharedFrame>(
      SharedFrame::Label{
          .channel = frame.channel, .number = frame.number, .key_frame = frame.key_frame, .captured = frame.captured},
      std::span<const std::byte>{}, std::span(*bytes), bytes);
}

std::span<const Nanoseconds> echoes_after(double loss) noexcept {
  if (loss <= kEchoLoss) return {};
  return loss <= kManyEchoesLoss ? std::span<const Nanoseconds>(kEchoesAfter) : kManyEchoesAfter;
}

std::vector<std::byte> FrameSender::Next::joined() const {
  std::vector<std::byte> payload(header.begin(), header.end());
  payload.insert(payload.end(), shard.begin(), shard.end());
  return payload;
}

std::optional<std::uint32_t> FrameSender::offer(std::shared_ptr<const SharedFrame> frame) {
  const auto [place, is_new] = waiting_.try_emplace(frame->label().channel);
  const std::optional<std::uint32_t> replaced = is_new ? std::nullopt : std::optional(place->second->label().number);
  if (replaced) ++statistics_.replaced;
  place->second = std::move(frame);
  return replaced;
}

std::optional<FrameSender::Next> FrameSender::next(SessionTime now, PathEstimate& path) {
  queue_echoes(now);
  drop_late(now, path);
  start_urgent(now, path);
  if (first_round_.empty()) start_newest(now, path);
  std::deque<Piece>& from = next_queue();
  if (from.empty()) return std::nullopt;
  if (&from == &urgent_ ? !path.has_room_for_urgent(now) : !path.has_room(now)) return std::nullopt;
  Next next = send(from.front(), now);
  from.pop_front();
  return next;
}

/// In order of time: the first echo of a frame may be due before the second one of the frame before it.
void FrameSender::add_echo(const Echo& echo) {
  const auto later =
      std::find_if(echoes_.begin(), echoes_.end(), [&](const Echo& other) { return other.at > echo.at; });
  echoes_.insert(later, echo);
}

/// An echo has as many repair shards as the frame has data shards: it replaces the first datagrams if all were lost.
void FrameSender::queue_echoes(SessionTime now) {
  for (; !echoes_.empty() && echoes_.front().at <= now; echoes_.pop_front()) {
    const std::uint64_t place = echoes_.front().outgoing;
    if (place < forgotten_) continue;
    Outgoing& outgoing = sent_[place - forgotten_];
    for (std::size_t block = 0; block < outgoing.blocks.size(); ++block)
      queue_repairs(place, outgoing, block, outgoing.frame->layout().data_in_block(block), urgent_);
  }
}

/// A frame is dropped unsent when it would arrive after twice the deadline. Over a path whose one-way delay exceeds the
/// deadline, as by satellite, a frame is dropped when it is older than the deadline: a late image is better than none.
void FrameSender::drop_late(SessionTime now, const PathEstimate& path) {
  const Nanoseconds oldest = std::max(2 * deadline_ - path.least_round_trip() / 2, deadline_);
  std::erase_if(waiting_, [&](const auto& entry) {
    const bool late = now - entry.second->label().captured > oldest;
    if (late) ++statistics_.expired;
    return late;
  });
}

bool FrameSender::idle_for_urgent() const noexcept {
  return urgent_.empty() && sent_.size() < kMostBesideAnImage &&
         std::none_of(waiting_.begin(), waiting_.end(), [](const auto& entry) { return entry.second->label().urgent; });
}

void FrameSender::start_urgent(SessionTime now, const PathEstimate& path) {
  for (auto next = waiting_.begin(); next != waiting_.end() && sent_.size() < kMostBesideAnImage;) {
    const auto one = next++;
    if (one->second->label().urgent) start(waiting_.extract(one).mapped(), now, path, urgent_);
  }
}

std::deque<FrameSender::Piece>& FrameSender::next_queue() noexcept {
  if (!urgent_.empty()) return urgent_;
  return requested_.empty() ? first_round_ : requested_;
}

void FrameSender::start_newest(SessionTime now, const PathEstimate& path) {
  if (waiting_.empty()) return;
  auto turn = waiting_.upper_bound(last_channel_);
  if (turn == waiting_.end()) turn = waiting_.begin();
  last_channel_ = turn->first;
  start(waiting_.extract(turn).mapped(), now, path, first_round_);
}

/// Queues the frame's shards in `to`.
void FrameSender::start(std::shared_ptr<const SharedFrame> frame, SessionTime now, const PathEstimate& path,
                        std::deque<Piece>& to) {
  const SharedFrame::Label& label = frame->label();
  const FrameLayout& layout = frame->layout();
  // Nobody asks for repairs of a frame of one shard that was lost: its receiver does not know of it.
  const bool can_ask = layout.data_shards > 1 && can_repair(deadline_ - (now - label.captured), path);
  const std::span<const Nanoseconds> echoes = label.echoed ? echoes_after(path.loss()) : std::span<const Nanoseconds>{};
  // Echoes are better repairs: a burst that takes the first datagrams takes repairs beside them, too.
  const std::size_t repairs =
      echoes.size() > 2 ? 0 : repair_shards(layout.data_in_block(0), path.loss(), path.burst_packets(), can_ask);
  Outgoing outgoing{.header = {.channel = label.channel,
                               .key_frame = label.key_frame,
                               .frame = label.number,
                               .frame_bytes = static_cast<std::uint32_t>(frame->bytes()),
                               .repair_shards = static_cast<std::uint8_t>(repairs)},
                    .frame = frame,
                    .blocks = std::vector<Block>(layout.blocks)};
  const std::uint64_t place = forgotten_ + sent_.size();
  for (std::size_t i = 0; i < layout.data_shards; ++i) {
    const std::size_t block = i % layout.blocks;
    to.push_back({place, static_cast<std::uint8_t>(block), static_cast<std::uint8_t>(i / layout.blocks)});
    ++outgoing.blocks[block].unsent;
  }
  for (std::size_t block = 0; block < layout.blocks; ++block) queue_repairs(place, outgoing, block, repairs, to);
  for (const Nanoseconds after : echoes) add_echo({now + after, place});
  ++statistics_.started;
  statistics_.data_shards += layout.data_shards;
  sent_.push_back(std::move(outgoing));
  forget_old();
}

/// Appends `count` repair shards that were not sent before, as far as the code has them.
void FrameSender::queue_repairs(std::uint64_t place, Outgoing& outgoing, std::size_t block, std::size_t count,
                                std::deque<Piece>& to) {
  const std::size_t first = outgoing.blocks[block].next_row;
  count = std::min(count, kMostRepairShards - first);
  const std::size_t data = outgoing.frame->layout().data_in_block(block);
  outgoing.frame->make_repairs(block, first + count);
  for (std::size_t i = 0; i < count; ++i)
    to.push_back({place, static_cast<std::uint8_t>(block), static_cast<std::uint8_t>(data + first + i)});
  outgoing.blocks[block].next_row += count;
  outgoing.blocks[block].unsent += count;
  statistics_.repair_shards += count;
}

FrameSender::Next FrameSender::send(const Piece& piece, SessionTime now) {
  Outgoing& outgoing = sent_[piece.outgoing - forgotten_];
  --outgoing.blocks[piece.block].unsent;
  outgoing.blocks[piece.block].sent_at = now;
  FragmentHeader header = outgoing.header;
  header.block = piece.block;
  header.shard = piece.shard;
  Next next{.shard = outgoing.frame->shard(piece.block, piece.shard), .frame = outgoing.frame};
  write_fragment_header(header, next.header);
  return next;
}

std::optional<std::size_t> FrameSender::find(const Missing& missing) const noexcept {
  const auto found = std::find_if(sent_.begin(), sent_.end(), [&](const Outgoing& frame) {
    return frame.header.channel == missing.channel && frame.header.frame == missing.frame &&
           missing.block < frame.frame->layout().blocks;
  });
  if (found == sent_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - sent_.begin());
}

void FrameSender::on_missing(std::span<const Missing> missing, SessionTime now, const PathEstimate& path) {
  const Nanoseconds there_and_back = path.least_round_trip() + path.queue_delay();
  for (const Missing& one : missing) {
    const std::optional<std::size_t> place = find(one);
    if (!place) continue;
    Outgoing& frame = sent_[*place];
    if (now + path.least_round_trip() / 2 > frame.frame->label().captured + deadline_) continue;
    Block& block = frame.blocks[one.block];
    if (block.unsent > 0 || now - block.sent_at < there_and_back) continue;
    const double spare = 1.0 + 2.0 * path.loss() * (2.0 * path.burst_packets() - 1.0);
    const auto count = static_cast<std::size_t>(std::ceil(one.shards * spare)) + (path.loss() > 0.02 ? 1 : 0);
    const std::uint64_t before = statistics_.repair_shards;
    queue_repairs(forgotten_ + *place, frame, one.block, count, requested_);
    statistics_.requested_shards += statistics_.repair_shards - before;
  }
}

/// Keeps a bounded number of frames, and each frame of which fragments wait.
void FrameSender::forget_old() {
  while (sent_.size() > kMostKept) {
    const auto waits = [this](const std::deque<Piece>& pieces) {
      return std::any_of(pieces.begin(), pieces.end(),
                         [this](const Piece& piece) { return piece.outgoing == forgotten_; });
    };
    if (waits(urgent_) || waits(first_round_) || waits(requested_)) return;
    sent_.pop_front();
    ++forgotten_;
  }
}

}  // namespace telepalp::link
