#include "codec/voice_playout.h"

#include <algorithm>
#include <utility>

#include "proto/words/numbers/quantile.h"

namespace telepalp::codec {
namespace {

constexpr std::size_t kTransits = 500;    // ten seconds
constexpr double kShareInTime = 0.995;    // of the frames
constexpr std::uint32_t kGiveUp = 10;     // missing frames in a row, after which nobody talks
constexpr double kSkipAbove = 1.2;        // frames; by one more than the next bound, and the jitter of the calls
constexpr double kSkipAtOnceAbove = 4.0;  // frames
constexpr double kStretchBelow = -0.2;    // frames; within kMargin, so that a frame is not played before it comes
constexpr std::uint32_t kSkipEvery = 5;   // calls: at most a fifth of the sound is left out
constexpr Nanoseconds kMargin = VoicePlayout::kLeastDelay;
constexpr std::uint32_t kRecent = 64;  // frames
constexpr Nanoseconds kJumpBack = std::chrono::milliseconds(200);
constexpr Nanoseconds kJumpOn = std::chrono::seconds(2);

constexpr Nanoseconds time_of(std::uint32_t number) noexcept {
  return std::int64_t{number} * Nanoseconds(kVoiceFrameTime);
}

std::span<const std::byte> bytes_of(const std::string& text) noexcept { return std::as_bytes(std::span(text)); }

}  // namespace

bool VoicePlayout::has_jumped(Nanoseconds transit) const noexcept {
  return !transits_.empty() && (transit < least_transit_ - kJumpBack || transit > least_transit_ + kJumpOn);
}

bool VoicePlayout::has_come(std::uint32_t number) const noexcept {
  if (recent_ == 0 || number > newest_) return false;
  const std::uint32_t before = newest_ - number;
  return before >= kRecent || (recent_ >> before & 1U) != 0;  // one that is so old is of no use either
}

void VoicePlayout::note_number(std::uint32_t number) noexcept {
  if (recent_ != 0 && number <= newest_) {
    recent_ |= std::uint64_t{1} << (newest_ - number);
    return;
  }
  const std::uint32_t further = recent_ == 0 ? kRecent : number - newest_;
  recent_ = (further < kRecent ? recent_ << further : 0) | 1U;
  newest_ = number;
}

void VoicePlayout::restart() {
  waiting_.clear();
  transits_.clear();
  next_.reset();
  is_playing_ = false;
  recent_ = 0;
  missing_ = 0;
  delay_ = kLeastDelay;
  decoder_.restart();
}

void VoicePlayout::add(VoicePacket packet, SessionTime arrived) {
  if (!is_voice_packet(bytes_of(packet.opus)) || packet.begun > packet.number) {
    ++counts_.refused;
    return;
  }
  const Nanoseconds transit = arrived.time_since_epoch() - time_of(packet.number);
  if (packet.talker != talker_) {
    restart();
    talker_ = packet.talker;
  } else if (has_jumped(transit)) {
    ++counts_.jumps;
    restart();
  }
  if (has_come(packet.number)) {
    ++counts_.duplicate;
    return;
  }
  note_transit(transit);
  // The frame before it, which is missing, can be restored from now on.
  const bool follows_gap = recent_ != 0 && packet.number > newest_ + 1 && packet.number > packet.begun;
  if (follows_gap) note_transit(transit + Nanoseconds(kVoiceFrameTime));
  note_number(packet.number);
  if (next_ && packet.number < *next_) {
    ++counts_.late;
    return;
  }
  const std::uint32_t number = packet.number;
  waiting_.emplace(number, std::move(packet));
  if (waiting_.size() > kMostWaiting) waiting_.erase(waiting_.begin());
}

void VoicePlayout::note_transit(Nanoseconds transit) {
  if (transits_.size() < kTransits) {
    transits_.push_back(transit);
  } else {
    newest_transit_ = (newest_transit_ + 1) % kTransits;
    transits_[newest_transit_] = transit;
  }
  std::vector<Nanoseconds> sorted = transits_;
  least_transit_ = std::ranges::min(sorted);
  // Frames that came even later than the longest delay are given up, so they must not lengthen the delay for the
  // others.
  std::erase_if(sorted, [&](Nanoseconds one) { return one > least_transit_ + kMostDelay; });
  delay_ = std::min(quantile_of(sorted, kShareInTime) - least_transit_ + kMargin, kMostDelay);
}

double VoicePlayout::behind(SessionTime now) const noexcept {
  const Nanoseconds turn = now.time_since_epoch() - least_transit_ - delay_ - time_of(*next_);
  return to_seconds(turn) / to_seconds(kVoiceFrameTime);
}

bool VoicePlayout::may_begin(SessionTime now) {
  if (waiting_.empty()) return false;
  const VoicePacket& first = waiting_.begin()->second;
  const std::optional<std::uint32_t> before = std::exchange(next_, first.number);
  if (behind(now) < 0.0) {
    next_ = before;
    return false;
  }
  if (before) counts_.concealed += first.number - std::clamp(first.begun, *before, first.number);  // lost in an outage
  // After an outage, what was said in it comes all at once: only the newest part of it is of use.
  while (waiting_.size() > 1 && behind(now) >= 1.0) {
    waiting_.erase(waiting_.begin());
    ++counts_.skipped;
    next_ = waiting_.begin()->first;
  }
  since_change_ = missing_ = 0;
  return is_playing_ = true;
}

bool VoicePlayout::decode_into(Played& played, const VoicePacket& packet) {
  const Result<VoiceSamples> samples = decoder_.decode(bytes_of(packet.opus));
  if (samples) played.samples = *samples;
  return samples.ok();
}

void VoicePlayout::skip_one() {
  since_change_ = 0;
  ++counts_.skipped;
  const Played left_out = play_next();  // the decoder needs each frame
  if (left_out.kind == Kind::Voice) --counts_.played;
  if (left_out.kind == Kind::Restored) --counts_.restored;
}

VoicePlayout::Played VoicePlayout::play_missing() {
  Played played{.samples = {}, .kind = Kind::Concealed, .number = (*next_)++};
  const auto after = waiting_.find(*next_);
  if (after != waiting_.end() && after->second.begun < *next_)
    if (const Result<VoiceSamples> restored = decoder_.restore(bytes_of(after->second.opus))) {
      played.samples = *restored;
      played.kind = Kind::Restored;
      ++counts_.restored;
      return played;
    }
  played.samples = decoder_.conceal();
  ++missing_;
  return played;
}

VoicePlayout::Played VoicePlayout::play_next() {
  const auto found = waiting_.find(*next_);
  if (found == waiting_.end()) return play_missing();
  const VoicePacket packet = std::move(found->second);
  waiting_.erase(found);
  // The missing frames were lost, but for those of the time in which the microphone was closed.
  counts_.concealed += std::min(missing_, packet.number - packet.begun);
  missing_ = 0;
  Played played{.samples = {}, .kind = Kind::Voice, .number = (*next_)++};
  if (decode_into(played, packet)) {
    ++counts_.played;
  } else {
    ++counts_.refused;
    ++counts_.concealed;
    played.kind = Kind::Concealed;
    played.samples = decoder_.conceal();
  }
  return played;
}

VoicePlayout::Played VoicePlayout::next(SessionTime now) {
  if (!is_playing_ && !may_begin(now)) return {};
  if (waiting_.empty() && missing_ >= kGiveUp) {
    is_playing_ = false;
    *next_ -= std::exchange(missing_, 0);
    return {};
  }
  ++since_change_;
  const double frames = behind(now);
  if (frames < kStretchBelow) {
    ++counts_.stretched;
    return {.samples = decoder_.conceal(), .kind = Kind::Stretched, .number = 0};
  }
  if (frames > kSkipAtOnceAbove || (frames > kSkipAbove && since_change_ >= kSkipEvery)) skip_one();
  return play_next();
}

}  // namespace telepalp::codec
