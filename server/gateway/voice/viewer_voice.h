#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "proto/keys/role.h"
#include "proto/wire/message.h"
#include "server/access/token_bucket.h"

namespace telepalp::gateway {

/// Why what a viewer says is not passed on. The page looks for the words before " fix:".
inline constexpr std::string_view kMayNotSpeak =
    "this person may not speak here. fix: sign in with a doctor's token to speak as the doctor, or with a technician's "
    "to speak at the patient's side";
inline constexpr std::string_view kPlayedSession =
    "a recorded session is shown, in which nobody can speak. fix: open the page of a server with a camera";
inline constexpr std::string_view kAnotherSpeaks =
    "another page speaks on this side, and is heard until it has been silent for 0.3 s. fix: wait until it ends";
inline constexpr std::string_view kNotSpeech =
    "the message is not speech, or messages come faster than a microphone's. fix: send telepalp.msg.VoiceFrame, one "
    "each 20 ms, with Opus packets of 20 ms of one channel";

/// The right that a person needs to speak on `topic`, a spoken one.
[[nodiscard]] keys::Operation operation_to_speak(const wire::Topic& topic) noexcept;

/// Checks what one viewer says. Pure; owner: the server's network thread.
class ViewerVoice {
 public:
  /// The payload of a viewer's message as a message of `topic`, with the id `viewer`. nullopt: it is not speech, or the
  /// viewer has sent more than kMessages_per_s. A time of the microphone that differs from `now` by more than 10 s is
  /// replaced.
  [[nodiscard]] std::optional<wire::Message> hear(const wire::Topic& topic, const std::string& payload,
                                                  std::uint64_t viewer, SessionTime now);

  /// Says `why`, unless this was the last thing that was said.
  void refuse(std::string_view why, const std::function<void(const std::string&)>& say);

 private:
  static constexpr double kMessages_per_s = 60.0;  // a microphone has 50, by a clock that may be wrong
  static constexpr double kBurst = 50.0;           // what a page sends after it did not run for a second

  access::TokenBucket rate_{kMessages_per_s, kBurst};
  std::string_view said_;
};

}  // namespace telepalp::gateway
