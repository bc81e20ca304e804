#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "messages/viewer.pb.h"
#include "proto/wire/message.h"
#include "proto/words/result.h"
#include "proto/words/time.h"
#include "server/gateway/foxglove_protocol.h"

namespace telepalp::gateway {

/// Accepts the messages of one viewer. Only two kinds are allowed. /viewer/hand: the position of the hand, letting it
/// go, handing it over to another viewer, and asking the station to re-arm. And speech, which ViewerVoice checks. Pure;
/// owner: the server's network thread.
class ViewerCommands {
 public:
  /// Error: a topic other than /viewer/hand and the spoken ones, an encoding other than protobuf, or more channels than
  /// a viewer may have.
  [[nodiscard]] Result<void> advertise(const foxglove::Request::Channel& channel);
  void unadvertise(std::uint32_t channel) { channels_.erase(channel); }

  struct Spoken {
    wire::Topic topic;
    std::string payload;  ///< not checked yet
  };
  /// The viewer's binary message, if it came on the channel of a spoken topic; nullopt: it came on another channel.
  [[nodiscard]] std::optional<Spoken> spoken(std::string_view bytes) const;

  /// True if the viewer's binary message lets go of the hand.
  [[nodiscard]] bool lets_go(std::string_view bytes) const;

  /// The viewer to which the viewer's binary message hands over the hand; nullopt: it does not.
  [[nodiscard]] std::optional<std::uint64_t> hands_over_to(std::string_view bytes) const;

  /// True if the viewer's binary message asks the station to re-arm after a fault.
  [[nodiscard]] bool asks_to_rearm(std::string_view bytes) const;

  /// True if the viewer's binary message accepts the object over the hand's place as skin.
  [[nodiscard]] bool accepts_object(std::string_view bytes) const;

  /// Converts a viewer's binary message to one of /viewer/hand with a time stamp and the id `viewer`. nullopt: the
  /// last one came less than 2 ms ago. Error: an unknown channel, no ViewerHand, or a hand over 10 m from the camera.
  [[nodiscard]] Result<std::optional<wire::Message>> hear(std::string_view bytes, std::uint64_t viewer,
                                                          SessionTime now);

 private:
  /// Parses a ViewerHand without a check of its position. nullopt: `bytes` is no ViewerHand on an advertised channel.
  [[nodiscard]] std::optional<msg::ViewerHand> read(std::string_view bytes) const;

  [[nodiscard]] bool is_hands(std::uint32_t channel) const;

  std::map<std::uint32_t, wire::Topic> channels_;
  std::optional<SessionTime> last_;
};

}  // namespace telepalp::gateway
