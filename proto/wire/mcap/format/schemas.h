#pragma once

#include <google/protobuf/descriptor.h>

#include <string>

#include "proto/wire/topics.h"

namespace telepalp::wire {

/// The Protobuf type of `topic`'s messages. Every topic of kTopics has one; another topic is our own bug.
[[nodiscard]] const google::protobuf::Descriptor* descriptor_of(const Topic& topic);

/// A serialised FileDescriptorSet with the file of `type` and all that it imports, imports first: what MCAP and the
/// Foxglove WebSocket protocol call a "protobuf" schema's data. The same bytes in every run.
[[nodiscard]] std::string file_descriptor_set(const google::protobuf::Descriptor& type);

}  // namespace telepalp::wire
