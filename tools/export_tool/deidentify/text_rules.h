#pragma once

#include <google/protobuf/descriptor.h>

#include <regex>
#include <string_view>

namespace telepalp::export_tool {

/// What becomes of one field of Protobuf type string or bytes in a de-identified copy of a session.
enum class TextRule {
  Remove,    ///< removed; the rule of each field that the table in text_rules.cpp does not list
  Number,    ///< a name that people gave: replaced by a number, the same for each occurrence in the session
  Word,      ///< a word that telepalp's programs write: kept if it has the form of one, such as camera_depth
  Topic,     ///< kept if it is one of telepalp's topics
  Software,  ///< kept if it is "telepalp-station 0.2.0, commit 1a2b3c4"
  Data,      ///< numbers, such as a coded depth image
  Picture,   ///< a JPEG picture of a model, not of a person: its comments are removed
};

/// The rule for a field of Protobuf type string or bytes.
[[nodiscard]] TextRule rule_of(const google::protobuf::FieldDescriptor& field);

/// True if all of `text` matches `pattern`, and it is at most 100 bytes long, as each text of telepalp's own is.
[[nodiscard]] bool has_form(std::string_view text, const std::regex& pattern);

/// True if `text` may stay in a field of this rule. Never true for Remove and Number, always for Data and Picture.
[[nodiscard]] bool may_stay(TextRule rule, std::string_view text);

}  // namespace telepalp::export_tool
