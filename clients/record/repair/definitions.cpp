#include "clients/record/repair/definitions.h"

#include <algorithm>

#include "proto/wire/mcap/format/schemas.h"
#include "support/program/version.h"

namespace telepalp::record {
namespace {

bool is_own(const wire::mcap::StoredChannel& channel) {
  return channel.topic && channel.schema->data == wire::file_descriptor_set(*wire::descriptor_of(*channel.topic));
}

/// The topic of a damaged definition, by its name or else by its type, if only one topic has this type.
std::optional<wire::Topic> recognised(const wire::mcap::StoredChannel& channel) {
  if (const std::optional<wire::Topic> topic = wire::find_topic(channel.channel.topic)) return topic;
  if (channel.schema == nullptr) return std::nullopt;
  const auto has_type = [&](const wire::Topic& topic) { return topic.schema == channel.schema->name; };
  if (std::ranges::count_if(wire::kTopics, has_type) != 1) return std::nullopt;
  return *std::ranges::find_if(wire::kTopics, has_type);
}

Definition definition_of(const wire::Topic& topic) {
  return {
      .schema = {.id = 1,
                 .name = std::string(topic.schema),
                 .encoding = "protobuf",
                 .data = wire::file_descriptor_set(*wire::descriptor_of(topic))},
      .channel = {
          .id = 0, .schema_id = 1, .topic = std::string(topic.name), .message_encoding = "protobuf", .metadata = {}}};
}

}  // namespace

DefinitionCheck::DefinitionCheck(const wire::SessionInfo& session)
    : is_of_this_version_(session.program == "telepalp-record" && session.version == program::version() &&
                          session.commit == program::commit()) {}

std::vector<std::string> DefinitionCheck::damaged(const wire::mcap::ChannelTable& channels) const {
  std::vector<std::string> damaged;
  if (!is_of_this_version_) return damaged;
  for (const auto& [id, stored] : channels.all())
    if (!is_own(stored))
      damaged.push_back("the definition of the topic " + stored.channel.topic +
                        " is not that of this version: a byte of it has changed");
  return damaged;
}

const Definition* DefinitionCheck::mended(const wire::mcap::StoredChannel& channel) {
  if (!is_of_this_version_) return nullptr;
  const auto [place, is_new] = mended_.try_emplace(channel.channel.id);
  if (is_new && !is_own(channel))
    if (const std::optional<wire::Topic> topic = recognised(channel)) place->second = definition_of(*topic);
  return place->second ? &*place->second : nullptr;
}

}  // namespace telepalp::record
