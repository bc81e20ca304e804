#pragma once

#include <google/protobuf/descriptor.h>

#include <string_view>

namespace telepalp::export_tool {

/// What a de-identified copy of a session does with one field of type string or bytes.
enum class TextRule {
  Remove,    ///< any text: also of each field that the table does not name
  Number,    ///< a name that people gave: replaced by a number, the same for each occurrence in the session
  Word,      ///< a word of telepalp's own, such as camera_depth: kept if it looks like one
  Topic,     ///< kept if it is one of telepalp's topics
  Software,  ///< kept if it is "telepalp-station 0.2.0, commit 1a2b3c4"
  Data,      ///< numbers, such as a coded depth image
  Picture,   ///< a JPEG picture of a model, not of a person: its comments are removed
};

/// The rule for a field of Protobuf type string or bytes.
[[nodiscard]] TextRule rule_of(const google::protobuf::FieldDescriptor& field);

/// True if `text` may stay in a field of this rule. Never true for Remove and Number, always for Data and Picture.
[[nodiscard]] bool may_stay(TextRule rule, std::string_view text);

}  // namespace telepalp::export_tool
