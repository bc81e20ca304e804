#include "clients/record/repair/definitions.h"

#include <algorithm>
#include <utility>

#include "proto/wire/mcap/format/schemas.h"
#include "support/program/version.h"

namespace telepalp::record {
namespace {

bool is_own(const wire::mcap::StoredChannel& channel) {
  return channel.topic && channel.key_frames &&
         channel.schema->data == wire::file_descriptor_set(*wire::descriptor_of(*channel.topic));
}

/// The only topic for which `fits` is true; nullopt: there is none, or there are several.
template <class Fits>
std::optional<wire::Topic> only_topic(Fits fits) {
  if (std::ranges::count_if(wire::kTopics, fits) != 1) return std::nullopt;
  return *std::ranges::find_if(wire::kTopics, fits);
}

/// The topic of a damaged definition: the one with its name, or else the only one with its type. If several topics have
/// this type, those that repeat the content of another one (Topic::only_by_name) are left out, because a
/// recorder takes them only if they are asked for by name.
std::optional<wire::Topic> recognised(const wire::mcap::StoredChannel& channel) {
  if (const std::optional<wire::Topic> topic = wire::find_topic(channel.channel.topic)) return topic;
  if (channel.schema == nullptr) return std::nullopt;
  const auto has_type = [&](const wire::Topic& topic) { return topic.schema == channel.schema->name; };
  const auto is_first = [&](const wire::Topic& topic) { return has_type(topic) && !topic.only_by_name; };
  const std::optional<wire::Topic> first = only_topic(is_first);
  return first ? first : only_topic(has_type);
}

/// The channel of `topic` with the mark of key frames that the damaged definition still has.
wire::mcap::StoredChannel channel_of(const wire::Topic& topic, const wire::mcap::StoredChannel& damaged) {
  const std::optional<bool> marked = topic.predicted ? damaged.key_frames : std::optional(true);
  wire::mcap::Channel channel = wire::mcap::channel_for(topic, marked.value_or(true));
  if (!marked) channel.metadata.clear();
  channel.schema_id = 1;
  return {.channel = std::move(channel), .schema = nullptr, .topic = topic, .key_frames = marked};
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

const wire::mcap::StoredChannel* DefinitionCheck::mended(const wire::mcap::StoredChannel& channel) {
  if (!is_of_this_version_) return nullptr;
  const auto [place, is_new] = mended_.try_emplace(channel.channel.id);
  std::optional<Definition>& own = place->second;
  const std::optional<wire::Topic> topic = is_new && !is_own(channel) ? recognised(channel) : std::nullopt;
  if (topic) {
    own = Definition{.schema = wire::mcap::schema_of(*topic), .channel = channel_of(*topic, channel)};
    own->channel.schema = &own->schema;
  }
  return own ? &own->channel : nullptr;
}

}  // namespace telepalp::record
