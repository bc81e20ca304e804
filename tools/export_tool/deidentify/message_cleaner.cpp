#include "tools/export_tool/deidentify/message_cleaner.h"

#include <google/protobuf/arena.h>
#include <google/protobuf/text_format.h>

#include <vector>

#include "messages/scene.pb.h"
#include "proto/wire/mcap/format/schemas.h"
#include "support/program/text/text_format.h"
#include "tools/export_tool/deidentify/plain_jpeg.h"
#include "tools/export_tool/deidentify/text_rules.h"

namespace telepalp::export_tool {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

}  // namespace

std::string MessageCleaner::replacement(const FieldDescriptor& field, const std::string& text) {
  const TextRule rule = rule_of(field);
  if (rule == TextRule::Picture) return plain_jpeg(text);
  if (may_stay(rule, text)) return text;
  if (rule != TextRule::Number) {
    ++texts_.removed[std::string(field.full_name())];
    return {};
  }
  ++texts_.numbered[std::string(field.full_name())];
  const std::size_t number = numbers_.try_emplace(text, numbers_.size() + 1).first->second;
  return "name " + std::to_string(number);
}

void MessageCleaner::clean_text(Message& message, const FieldDescriptor& field) {
  const Reflection& reflection = *message.GetReflection();
  if (!field.is_repeated()) {
    std::string kept;
    const std::string& text = reflection.GetStringReference(message, &field, &kept);
    if (text.empty()) return;
    const std::string clean = replacement(field, text);
    return clean.empty() ? reflection.ClearField(&message, &field) : reflection.SetString(&message, &field, clean);
  }
  for (int index = 0; index < reflection.FieldSize(message, &field); ++index)
    reflection.SetRepeatedString(&message, &field, index,
                                 replacement(field, reflection.GetRepeatedString(message, &field, index)));
}

void MessageCleaner::clean(Message& message) {
  const Reflection& reflection = *message.GetReflection();
  if (!reflection.GetUnknownFields(message).empty()) {
    ++texts_.unknown_fields;
    reflection.MutableUnknownFields(&message)->Clear();
  }
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    if (field->cpp_type() == FieldDescriptor::CPPTYPE_STRING) {
      clean_text(message, *field);
    } else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE && field->is_repeated()) {
      for (int index = 0; index < reflection.FieldSize(message, field); ++index)
        clean(*reflection.MutableRepeatedMessage(&message, field, index));
    } else if (field->cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE) {
      clean(*reflection.MutableMessage(&message, field));
    }
  }
}

std::optional<std::string> MessageCleaner::cleaned(const wire::Topic& topic, std::string_view payload) {
  google::protobuf::Arena arena;
  Message* const message =
      google::protobuf::MessageFactory::generated_factory()->GetPrototype(wire::descriptor_of(topic))->New(&arena);
  if (!message->ParseFromArray(payload.data(), static_cast<int>(payload.size()))) return std::nullopt;
  clean(*message);
  return message->SerializeAsString();
}

std::string MessageCleaner::cleaned_scene(const std::string& text) {
  msg::Scene scene;
  if (text.empty() || !program::parse_text_format(text, "scene", scene)) return {};
  clean(scene);
  std::string clean_text;
  return google::protobuf::TextFormat::PrintToString(scene, &clean_text) ? clean_text : std::string{};
}

}  // namespace telepalp::export_tool
