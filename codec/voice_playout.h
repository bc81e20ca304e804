#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "codec/voice.h"
#include "proto/words/time.h"

namespace telepalp::codec {

/// One coded frame of a talker. Frames are numbered by the talker's clock: one more for each 20 ms, also while nothing
/// is sent.
struct VoicePacket {
  std::uint64_t talker = 0;
  std::uint32_t number = 0;
  std::uint32_t begun = 0;  ///< number of the first frame since the talker opened the microphone
  std::string opus{};
};

/// The jitter buffer between a network and a loudspeaker. Packets come late, twice, in another order, or never; the
/// loudspeaker takes 20 ms of sound at a time. The delay follows the path: with it, 99.5 % of the frames of the last
/// ten seconds would have been there when their turn came, in their own packet or repeated in the next one. A missing
/// frame is restored from the next one, or concealed. Where the delay no longer fits, or the two clocks drift apart,
/// single frames are skipped or stretched. Holds at most one second of frames. Pure: times are arguments, of any steady
/// clock of the listener.
class VoicePlayout {
 public:
  static constexpr Nanoseconds kLeastDelay = std::chrono::milliseconds(5);
  static constexpr Nanoseconds kMostDelay = std::chrono::milliseconds(400);
  static constexpr std::uint32_t kMostWaiting = 50;  ///< frames

  /// Takes a packet that arrived at `arrived`.
  void add(VoicePacket packet, SessionTime arrived);

  enum class Kind : std::uint8_t {
    Voice,      ///< decoded from its own packet
    Restored,   ///< its packet was lost; decoded from the repetition in the next packet
    Concealed,  ///< its packet was lost; made up from the sound before
    Stretched,  ///< no frame: the sound before goes on, because the delay has grown
    Silence,    ///< nobody talks
  };
  struct Played {
    VoiceSamples samples{};
    Kind kind = Kind::Silence;
    std::uint32_t number = 0;  ///< of the frame; unless Stretched or Silence
  };
  /// The sound of the 20 ms from `now` on. To be called each 20 ms.
  [[nodiscard]] Played next(SessionTime now);

  struct Counts {
    std::uint64_t played = 0;     ///< frames decoded from their own packets
    std::uint64_t restored = 0;   ///< frames decoded from repetitions
    std::uint64_t concealed = 0;  ///< frames that were lost, or came too late
    std::uint64_t late = 0;       ///< packets that came after their turn
    std::uint64_t duplicate = 0;
    std::uint64_t skipped = 0;    ///< frames left out to shorten the delay
    std::uint64_t stretched = 0;  ///< 20 ms made up to lengthen the delay
    std::uint64_t refused = 0;    ///< damaged packets
    std::uint64_t jumps = 0;      ///< times that the talker's or the listener's clock jumped
  };
  [[nodiscard]] const Counts& counts() const noexcept { return counts_; }
  /// What the buffer adds to the delay of the fastest frames.
  [[nodiscard]] Nanoseconds delay() const noexcept { return delay_; }

 private:
  [[nodiscard]] bool has_come(std::uint32_t number) const noexcept;
  void note_number(std::uint32_t number) noexcept;
  [[nodiscard]] bool has_jumped(Nanoseconds transit) const noexcept;
  void note_transit(Nanoseconds transit);
  void restart();
  /// How many frames the turn at `now` is ahead of the next frame to play.
  [[nodiscard]] double behind(SessionTime now) const noexcept;
  [[nodiscard]] bool may_begin(SessionTime now);
  void skip_one();
  [[nodiscard]] Played play_next();
  [[nodiscard]] Played play_missing();
  [[nodiscard]] bool decode_into(Played& played, const VoicePacket& packet);

  std::uint64_t talker_ = 0;
  std::map<std::uint32_t, VoicePacket> waiting_;  // by number; at most kMostWaiting
  std::optional<std::uint32_t> next_;             // the frame whose turn is next; nullopt: nobody has talked yet
  bool is_playing_ = false;
  std::uint32_t newest_ = 0;           // number of the newest frame that came
  std::uint64_t recent_ = 0;           // bit i: frame newest_ - i has come; 0: none has
  std::uint32_t missing_ = 0;          // frames since the last one that came; counted once a later one has come
  std::uint32_t since_change_ = 0;     // calls of next() since a frame was skipped
  std::vector<Nanoseconds> transits_;  // of the newest frames: arrival minus the talker's time; a ring
  std::size_t newest_transit_ = 0;     // its place in the ring
  Nanoseconds least_transit_{};        // of transits_
  Nanoseconds delay_ = kLeastDelay;
  VoiceDecoder decoder_;
  Counts counts_;
};

}  // namespace telepalp::codec
