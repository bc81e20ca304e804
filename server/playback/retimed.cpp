#include "server/playback/retimed.h"

#include <google/protobuf/arena.h>
#include <google/protobuf/message.h>
#include <google/protobuf/timestamp.pb.h>

#include <string_view>
#include <vector>

#include "proto/wire/mcap/format/schemas.h"

namespace telepalp::playback {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

constexpr int kSenderField = 100;  // see msg::Sender

void map_timestamp(google::protobuf::Timestamp& stamp, const TimeMap& map) {
  constexpr std::int64_t kSecond_ns = 1'000'000'000;
  constexpr std::int64_t kLast_s = INT64_MAX / kSecond_ns - 1;
  if (stamp.seconds() <= 0 || stamp.seconds() > kLast_s) return;
  const std::int64_t at = to_nanoseconds(map(session_time(stamp.seconds() * kSecond_ns + stamp.nanos())));
  stamp.set_seconds(at / kSecond_ns);
  stamp.set_nanos(static_cast<std::int32_t>(at % kSecond_ns));
}

bool is_instant(const FieldDescriptor& field) {
  return field.type() == FieldDescriptor::TYPE_FIXED64 && !field.is_repeated() &&
         std::string_view(field.name()).ends_with("_ns");
}

void map_instants(Message& message, const TimeMap& map) {
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  if (auto* const stamp = dynamic_cast<google::protobuf::Timestamp*>(&message)) return map_timestamp(*stamp, map);
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    if (is_instant(*field)) {
      const std::uint64_t at = reflection.GetUInt64(message, field);
      if (at == 0 || at > static_cast<std::uint64_t>(INT64_MAX)) continue;
      const SessionTime mapped = map(session_time(static_cast<std::int64_t>(at)));
      reflection.SetUInt64(&message, field, static_cast<std::uint64_t>(to_nanoseconds(mapped)));
    } else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE && field->is_repeated()) {
      for (int index = 0; index < reflection.FieldSize(message, field); ++index)
        map_instants(*reflection.MutableRepeatedMessage(&message, field, index), map);
    } else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      map_instants(*reflection.MutableMessage(&message, field), map);
    }
  }
}

void tell_sender_apart(Message& message) {
  const FieldDescriptor* const field = message.GetDescriptor()->FindFieldByNumber(kSenderField);
  if (field == nullptr || field->type() != FieldDescriptor::TYPE_UINT32) return;
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  reflection.SetUInt32(&message, field, reflection.GetUInt32(message, field) + kRecordedSenders);
}

}  // namespace

std::optional<wire::Message> retimed(const wire::Message& recorded, const TimeMap& map) {
  google::protobuf::Arena arena;
  Message* const message = google::protobuf::MessageFactory::generated_factory()
                               ->GetPrototype(wire::descriptor_of(recorded.topic))
                               ->New(&arena);
  if (!message->ParseFromString(*recorded.payload)) return std::nullopt;
  map_instants(*message, map);
  tell_sender_apart(*message);
  return wire::make_message(recorded.topic, map(recorded.published), *message, recorded.key_frame);
}

}  // namespace telepalp::playback
