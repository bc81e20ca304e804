#include "tools/export_tool/message_table.h"

#include <google/protobuf/arena.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <cstdio>

#include "proto/wire/mcap/format/schemas.h"

namespace telepalp::export_tool {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

bool is_part(const FieldDescriptor& field) { return field.cpp_type() == FieldDescriptor::CPPTYPE_MESSAGE; }
bool is_list_of_values(const FieldDescriptor& field) { return field.is_repeated() && !is_part(field); }
bool is_count_alone(const FieldDescriptor& field) {
  return (field.is_repeated() && is_part(field)) || field.type() == FieldDescriptor::TYPE_BYTES;
}

void add_columns(const Descriptor& type, const std::string& prefix, std::vector<std::string>& columns) {
  for (int index = 0; index < type.field_count(); ++index) {
    const FieldDescriptor& field = *type.field(index);
    if (is_part(field) && !field.is_repeated())
      add_columns(*field.message_type(), prefix + field.name() + ".", columns);
    else
      columns.push_back(prefix + field.name() + (is_count_alone(field) ? ".size" : ""));
  }
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.9g", value);
  return text;
}

std::string quoted(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string safe = "\"";
  for (const char letter : text) safe += letter == '"' ? "\"\"" : std::string(1, letter);
  return safe + "\"";
}

/// The value of a field, or of entry `row` of a list; empty behind the list's end.
std::string value_of(const Message& message, const FieldDescriptor& field, int row) {
  const google::protobuf::Reflection& r = *message.GetReflection();
  const bool list = field.is_repeated();
  if (list && row >= r.FieldSize(message, &field)) return {};
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return number(list ? r.GetRepeatedDouble(message, &field, row) : r.GetDouble(message, &field));
    case FieldDescriptor::CPPTYPE_FLOAT:
      return number(static_cast<double>(list ? r.GetRepeatedFloat(message, &field, row) : r.GetFloat(message, &field)));
    case FieldDescriptor::CPPTYPE_INT32:
      return std::to_string(list ? r.GetRepeatedInt32(message, &field, row) : r.GetInt32(message, &field));
    case FieldDescriptor::CPPTYPE_INT64:
      return std::to_string(list ? r.GetRepeatedInt64(message, &field, row) : r.GetInt64(message, &field));
    case FieldDescriptor::CPPTYPE_UINT32:
      return std::to_string(list ? r.GetRepeatedUInt32(message, &field, row) : r.GetUInt32(message, &field));
    case FieldDescriptor::CPPTYPE_UINT64:
      return std::to_string(list ? r.GetRepeatedUInt64(message, &field, row) : r.GetUInt64(message, &field));
    case FieldDescriptor::CPPTYPE_BOOL:
      return (list ? r.GetRepeatedBool(message, &field, row) : r.GetBool(message, &field)) ? "1" : "0";
    case FieldDescriptor::CPPTYPE_ENUM: {
      const int value = list ? r.GetRepeatedEnumValue(message, &field, row) : r.GetEnumValue(message, &field);
      const auto* const known = field.enum_type()->FindValueByNumber(value);
      return known == nullptr ? std::to_string(value) : known->name();
    }
    case FieldDescriptor::CPPTYPE_STRING:
      return quoted(list ? r.GetRepeatedString(message, &field, row) : r.GetString(message, &field));
    case FieldDescriptor::CPPTYPE_MESSAGE:
      break;
  }
  return {};
}

void add_cells(const Message& message, int row, std::string& line) {
  const Descriptor& type = *message.GetDescriptor();
  const google::protobuf::Reflection& reflection = *message.GetReflection();
  for (int index = 0; index < type.field_count(); ++index) {
    const FieldDescriptor& field = *type.field(index);
    if (is_part(field) && !field.is_repeated()) {
      add_cells(reflection.GetMessage(message, &field), row, line);
      continue;
    }
    line += ',';
    if (!is_count_alone(field))
      line += value_of(message, field, row);
    else
      line += std::to_string(field.is_repeated() ? static_cast<std::size_t>(reflection.FieldSize(message, &field))
                                                 : reflection.GetString(message, &field).size());
  }
}

int rows_of(const Message& message) {
  int rows = 1;
  const Descriptor& type = *message.GetDescriptor();
  for (int index = 0; index < type.field_count(); ++index)
    if (is_list_of_values(*type.field(index)) && type.field(index)->type() != FieldDescriptor::TYPE_BYTES)
      rows = std::max(rows, message.GetReflection()->FieldSize(message, type.field(index)));
  return rows;
}

}  // namespace

MessageTable::MessageTable(const wire::Topic& topic) { add_columns(*wire::descriptor_of(topic), "", columns_); }

std::string MessageTable::header() const {
  std::string line = "published_ns,row";
  for (const std::string& column : columns_) line += "," + column;
  return line + "\n";
}

std::optional<std::string> MessageTable::lines_of(const wire::Message& message) const {
  google::protobuf::Arena arena;
  Message* const parsed = google::protobuf::MessageFactory::generated_factory()
                              ->GetPrototype(wire::descriptor_of(message.topic))
                              ->New(&arena);
  if (!parsed->ParseFromString(*message.payload)) return std::nullopt;
  std::string lines;
  for (int row = 0; row < rows_of(*parsed); ++row) {
    lines += std::to_string(to_nanoseconds(message.published)) + "," + std::to_string(row);
    add_cells(*parsed, row, lines);
    lines += "\n";
  }
  return lines;
}

}  // namespace telepalp::export_tool
