#pragma once

#include <cstddef>
#include <vector>

#include "codec/voice.h"
#include "proto/words/time.h"

namespace telepalp::speech {

/// A time in which somebody speaks on one side.
struct Spoken {
  SessionTime from{};
  SessionTime until{};
  int loudest_dB = 0;  ///< of the loudest 20 ms, relative to a sine of full scale; at most 0

  friend bool operator==(const Spoken&, const Spoken&) = default;
};

/// The level of 20 ms of sound relative to a sine of full scale [dB], -100 to 0.
[[nodiscard]] double level_dB(const codec::VoiceSamples& samples) noexcept;

/// Finds where somebody speaks from the levels of one microphone, 20 ms at a time. A frame is speech if its level is
/// above -50 dB and 10 dB above the room's noise, which is the lowest recent level. Pauses up to half a second do not
/// end a span. At most kMost spans are kept: of more, those that lie closest together are joined. Pure.
class LoudSpans {
 public:
  static constexpr std::size_t kMost = 1000;

  /// The 20 ms from `at` on. A frame that lies before the end of the newest one is left out.
  void add(SessionTime at, double frame_dB);

  /// The spans so far, in order; none shorter than 60 ms, such as the click of a switch.
  [[nodiscard]] std::vector<Spoken> spans() const;

 private:
  void join_closest();

  std::vector<Spoken> spans_;
  double noise_dB_ = -60.0;
  SessionTime end_{};  // of the newest frame
};

}  // namespace telepalp::speech
