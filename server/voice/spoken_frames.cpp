#include "server/voice/spoken_frames.h"

#include <algorithm>
#include <utility>

#include "proto/wire/voice/voice_message.h"

namespace telepalp::voice {

wire::Message SpokenFrames::message_of(HeardFrame heard, SessionTime now) {
  if (heard.number != newest_ + 1) earlier_.clear();
  earlier_.resize(std::min<std::size_t>(earlier_.size(), heard.number - heard.begun));
  msg::VoiceFrame frame;
  frame.set_captured_ns(static_cast<std::uint64_t>(to_nanoseconds(heard.spoken)));
  frame.set_talker(talker_);
  frame.set_number(heard.number);
  frame.set_begun(heard.begun);
  frame.set_opus(heard.opus);
  for (const std::string& packet : earlier_) frame.add_earlier(packet);
  newest_ = heard.number;
  earlier_.push_front(std::move(heard.opus));
  if (earlier_.size() > static_cast<std::size_t>(wire::kMaxEarlierVoicePackets)) earlier_.pop_back();
  return wire::make_message(wire::kPatientVoice, now, frame);
}

}  // namespace telepalp::voice
