#pragma once

#include <google/protobuf/message.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "proto/wire/message.h"

namespace telepalp::export_tool {

/// Numbers of the texts that were removed, and that were replaced, by the full name of their field.
struct CleanedTexts {
  std::map<std::string, std::uint64_t, std::less<>> removed;
  std::map<std::string, std::uint64_t, std::less<>> numbered;
  std::uint64_t unknown_fields = 0;  ///< messages with fields of another version, which were removed
};

/// Removes the texts from which a person, a place or a computer could be identified from a session's messages, by
/// rule_of(). All numbers stay. All messages that one cleaner cleans have the same number in place of the same name.
class MessageCleaner {
 public:
  /// Cleans `message` and all messages in it.
  void clean(google::protobuf::Message& message);

  /// The cleaned payload of a message of `topic`; nullopt: `payload` is not of the topic's type.
  [[nodiscard]] std::optional<std::string> cleaned(const wire::Topic& topic, std::string_view payload);

  /// The cleaned text of a scene file, without comments. Empty: `text` is not a scene, so all of it must be removed.
  [[nodiscard]] std::string cleaned_scene(const std::string& text);

  [[nodiscard]] const CleanedTexts& texts() const noexcept { return texts_; }

 private:
  void clean_text(google::protobuf::Message& message, const google::protobuf::FieldDescriptor& field);
  [[nodiscard]] std::string replacement(const google::protobuf::FieldDescriptor& field, const std::string& text);

  CleanedTexts texts_;
  std::map<std::string, std::size_t> numbers_;  // of the replaced names
};

}  // namespace telepalp::export_tool
