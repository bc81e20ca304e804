#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "messages/playback.pb.h"
#include "proto/wire/topics.h"
#include "proto/words/result.h"
#include "proto/words/time.h"

namespace telepalp::gateway::foxglove {

/// The supported subprotocols. telepalp uses parts that are equal in both, and playback control, which only the first
/// has.
inline constexpr std::array<std::string_view, 2> kSubprotocols{"foxglove.sdk.v1", "foxglove.websocket.v1"};

/// The first supported subprotocol in the client's Sec-WebSocket-Protocol header; nullopt if there is none.
[[nodiscard]] std::optional<std::string_view> choose_subprotocol(std::string_view offered);

/// The topic of a channel. Channel ids count the entries of wire::kTopics, then of kViewTopics (view_topics.h), then of
/// kStateTopics (resources.h), from 1.
[[nodiscard]] std::optional<wire::Topic> topic_of_channel(std::uint32_t channel);

/// Text messages from the server. `session_id` differs for each start of the server, `viewer` for each client. `role`
/// is the name of the client's role; telepalp's viewer shows the view for this role, and leaves out what the role may
/// not do. `played`: the session whose playback the client may control; nullopt: none. `may`: the paths of the
/// resources to which the client may POST commands, with commas between them.
[[nodiscard]] std::string server_info(std::string_view name, std::string_view session_id, std::uint64_t viewer,
                                      std::string_view role, const std::optional<msg::PlaybackState>& played = {},
                                      std::string_view may = {});
using Chosen = std::function<bool(const wire::Topic&)>;
/// Texts that offer, or withdraw, the channels of the topics for which `chosen` returns true.
[[nodiscard]] std::string advertise(const Chosen& chosen);
[[nodiscard]] std::string unadvertise(const Chosen& chosen);
enum class Level : std::uint32_t { Info = 0, Warning = 1, Error = 2 };
[[nodiscard]] std::string status(Level level, std::string_view text);

/// The header of a binary message: 01 | subscription u32 | time u64 [ns], little-endian. The payload follows.
inline constexpr std::size_t kMessageHeaderBytes = 13;
[[nodiscard]] std::array<std::uint8_t, kMessageHeaderBytes> message_header(std::uint32_t subscription, SessionTime at);

/// The requests in a client's text message.
struct Request {
  struct Subscription {
    std::uint32_t id;
    std::uint32_t channel;
  };
  struct Channel {
    std::uint32_t id;
    std::string topic;
    std::string encoding;
  };
  std::vector<Subscription> subscribe;
  std::vector<std::uint32_t> unsubscribe;
  std::vector<Channel> advertise;  ///< channels on which the client will publish
  std::vector<std::uint32_t> unadvertise;
};

/// A client's binary message: 01 | channel u32, little-endian | payload. nullopt for anything else.
struct ClientData {
  std::uint32_t channel;
  std::string payload;
};
[[nodiscard]] std::optional<ClientData> read_client_data(std::string_view bytes);

/// Parses a client's text message. Error: not a JSON object of the protocol, or an unsupported operation. The
/// connection limits the size of `text`.
[[nodiscard]] Result<Request> read_request(const std::string& text);

}  // namespace telepalp::gateway::foxglove
