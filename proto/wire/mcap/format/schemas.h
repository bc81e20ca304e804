#pragma once

#include <google/protobuf/descriptor.h>

#include <string>

#include "proto/wire/mcap/format/records.h"
#include "proto/wire/topics.h"

namespace telepalp::wire {

/// The Protobuf type of a topic's messages. `topic` must be in kTopics; otherwise the process aborts.
[[nodiscard]] const google::protobuf::Descriptor* descriptor_of(const Topic& topic);

/// A serialised FileDescriptorSet with the file of `type` and all its imports, imports first. MCAP and the Foxglove
/// WebSocket protocol use it as the data of a "protobuf" schema. Deterministic.
[[nodiscard]] std::string file_descriptor_set(const google::protobuf::Descriptor& type);

namespace mcap {
/// The schema record of a topic's messages, with the id 0. `topic` must be in kTopics.
[[nodiscard]] Schema schema_of(const Topic& topic);
}  // namespace mcap

}  // namespace telepalp::wire
