#include "server/gateway/foxglove_protocol.h"

#include <google/protobuf/util/json_util.h>

#include "messages/foxglove_websocket.pb.h"
#include "proto/wire/mcap/format/schemas.h"
#include "proto/words/demand.h"
#include "proto/words/little_endian.h"
#include "server/gateway/foxglove/playback_control.h"
#include "server/origin/resources.h"
#include "server/views/view_topics.h"
#include "support/program/message_json.h"

namespace telepalp::gateway::foxglove {
namespace {

namespace json = google::protobuf::util;
namespace texts = telepalp::foxglove_websocket;

std::string our_json(const google::protobuf::Message& message) {
  std::string json = program::to_json(message);
  demand(json != "{}", "a message of this server can be written as JSON");
  return json;
}

Error operation_refused(std::string what) {
  return {.what = std::move(what),
          .where = "text message from the client",
          .fix = "send subscribe, unsubscribe, advertise or unadvertise, as JSON"};
}

/// Calls `use` with the number, the topic and the message type of each channel.
template <class Use>
void for_each_channel(Use use) {
  std::uint32_t channel = 0;
  for (const wire::Topic& topic : wire::kTopics) use(++channel, topic, *wire::descriptor_of(topic));
  for (const wire::Topic& topic : views::kViewTopics) use(++channel, topic, *views::descriptor_of_view(topic));
  for (const auto& [topic, every] : origin::kStateTopics) use(++channel, topic, *origin::descriptor_of_state(topic));
}

void add_channel(texts::Advertise& advertise, std::uint32_t id, const wire::Topic& topic,
                 const google::protobuf::Descriptor& type) {
  texts::Advertise::Channel& channel = *advertise.add_channels();
  channel.set_id(id);
  channel.set_topic(std::string(topic.name));
  channel.set_encoding("protobuf");
  channel.set_schemaname(std::string(topic.schema));
  channel.set_schema(wire::file_descriptor_set(type));
  channel.set_schemaencoding("protobuf");
}

texts::Time time_of(std::uint64_t ns) {
  constexpr std::uint64_t kSecond_ns = 1'000'000'000;
  texts::Time time;
  time.set_sec(static_cast<std::uint32_t>(ns / kSecond_ns));
  time.set_nsec(static_cast<std::uint32_t>(ns % kSecond_ns));
  return time;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

}  // namespace

std::optional<std::string_view> choose_subprotocol(std::string_view offered) {
  while (!offered.empty()) {
    const std::size_t comma = offered.find(',');
    const std::string_view offer = trimmed(offered.substr(0, comma));
    for (const std::string_view spoken : kSubprotocols)
      if (offer == spoken) return spoken;
    offered = comma == std::string_view::npos ? std::string_view{} : offered.substr(comma + 1);
  }
  return std::nullopt;
}

std::optional<wire::Topic> topic_of_channel(std::uint32_t channel) {
  std::optional<wire::Topic> found;
  for_each_channel([&](std::uint32_t id, const wire::Topic& topic, const google::protobuf::Descriptor&) {
    if (id == channel) found = topic;
  });
  return found;
}

std::string server_info(std::string_view name, std::string_view session_id, std::uint64_t viewer, std::string_view role,
                        const std::optional<msg::PlaybackState>& played, std::string_view may) {
  texts::ServerInfo info;
  info.set_op("serverInfo");
  info.set_name(std::string(name));
  info.add_capabilities("clientPublish");
  info.add_supportedencodings("protobuf");
  info.set_sessionid(std::string(session_id));
  (*info.mutable_metadata())["viewer"] = std::to_string(viewer);
  (*info.mutable_metadata())["role"] = std::string(role);
  (*info.mutable_metadata())["may"] = std::string(may);
  if (played) {
    info.add_capabilities("playbackControl");
    *info.mutable_datastarttime() = time_of(played->begin_ns());
    *info.mutable_dataendtime() = time_of(end_ns(*played));
  }
  return our_json(info);
}

std::string advertise(const Chosen& chosen) {
  texts::Advertise advertise;
  advertise.set_op("advertise");
  for_each_channel([&](std::uint32_t id, const wire::Topic& topic, const google::protobuf::Descriptor& type) {
    if (chosen(topic)) add_channel(advertise, id, topic, type);
  });
  return our_json(advertise);
}

std::string unadvertise(const Chosen& chosen) {
  texts::Unadvertise unadvertise;
  unadvertise.set_op("unadvertise");
  for_each_channel([&](std::uint32_t id, const wire::Topic& topic, const google::protobuf::Descriptor&) {
    if (chosen(topic)) unadvertise.add_channelids(id);
  });
  return our_json(unadvertise);
}

std::string status(Level level, std::string_view text) {
  texts::Status status;
  status.set_op("status");
  status.set_level(static_cast<std::uint32_t>(level));
  status.set_message(std::string(text));
  return our_json(status);
}

std::array<std::uint8_t, kMessageHeaderBytes> message_header(std::uint32_t subscription, SessionTime at) {
  std::array<std::uint8_t, kMessageHeaderBytes> header{0x01};
  put_little_endian<std::uint32_t>(header.data() + 1, subscription);
  put_little_endian<std::int64_t>(header.data() + 5, to_nanoseconds(at));
  return header;
}

std::optional<ClientData> read_client_data(std::string_view bytes) {
  constexpr std::size_t kHeaderBytes = 5;
  if (bytes.size() < kHeaderBytes || bytes[0] != 0x01) return std::nullopt;
  return ClientData{get_little_endian<std::uint32_t>(bytes.data() + 1), std::string(bytes.substr(kHeaderBytes))};
}

Result<Request> read_request(const std::string& text) {
  json::JsonParseOptions options;
  options.ignore_unknown_fields = true;
  texts::ClientText client;
  if (const auto read = json::JsonStringToMessage(text, &client, options); !read.ok())
    return operation_refused("the text is not JSON of the Foxglove protocol: " + read.ToString());
  Request request;
  if (client.op() == "subscribe") {
    for (const auto& wanted : client.subscriptions()) request.subscribe.push_back({wanted.id(), wanted.channelid()});
  } else if (client.op() == "unsubscribe") {
    request.unsubscribe.assign(client.subscriptionids().begin(), client.subscriptionids().end());
  } else if (client.op() == "advertise") {
    for (const auto& channel : client.channels())
      request.advertise.push_back({channel.id(), channel.topic(), channel.encoding()});
  } else if (client.op() == "unadvertise") {
    request.unadvertise.assign(client.channelids().begin(), client.channelids().end());
  } else {
    return operation_refused("operation '" + client.op().substr(0, 64) + "' is not supported");
  }
  return request;
}

}  // namespace telepalp::gateway::foxglove
