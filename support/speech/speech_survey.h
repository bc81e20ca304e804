#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "proto/wire/message.h"
#include "support/speech/loud_spans.h"

namespace telepalp::speech {

/// Where somebody speaks on one side of the conversation.
struct SideSpeech {
  std::vector<Spoken> spans{};  ///< in order, at most LoudSpans::kMost
  std::uint64_t messages = 0;   ///< of which this was found
};

/// Where people speak in a session, by the name of the topic: only spoken ones, and only those that have messages.
using Speech = std::map<std::string_view, SideSpeech>;

/// Finds where people speak from the messages of speech, in the order of their time. It decodes each 20 ms once: about
/// 1 ms of computing time for each second of an open microphone. A damaged message
/// is counted and otherwise ignored, because a message may be anybody's.
class SpeechSurvey {
 public:
  SpeechSurvey();
  ~SpeechSurvey();
  SpeechSurvey(SpeechSurvey&&) noexcept;
  SpeechSurvey& operator=(SpeechSurvey&&) noexcept;

  /// A message of any topic; only those of spoken topics are read.
  void add(const wire::Message& message);
  [[nodiscard]] Speech speech() const;

 private:
  class Side;
  std::map<std::string_view, Side> sides_;  // by topic
};

}  // namespace telepalp::speech
