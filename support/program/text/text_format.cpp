#include "support/program/text/text_format.h"

#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

#include "support/program/text/quoted_text.h"

namespace telepalp::program {
namespace {

constexpr std::uintmax_t kMaxTextBytes = 1 << 20;
constexpr int kMostNesting = 250;  // the parser recurses: without a bound, a file of braces overflows the stack

/// Keeps the first error, because later ones are mostly consequences of it.
class FirstError : public google::protobuf::io::ErrorCollector {
 public:
  void AddError(int line, google::protobuf::io::ColumnNumber column, const std::string& message) override {
    if (!message_.empty()) return;
    line_ = line + 1;
    column_ = column + 1;
    message_ = message;
    while (message_.ends_with('.')) message_.pop_back();  // the message continues with ". fix:"
  }
  [[nodiscard]] Error error(const std::string& name) const {
    return {.what = message_.empty() ? "not a file in protobuf's text format" : message_,
            .where = name + ":" + std::to_string(line_) + ":" + std::to_string(column_),
            .fix = fix()};
  }

 private:
  /// The parser reads 0,5 as a number and a new field that begins with 5.
  [[nodiscard]] std::string fix() const {
    constexpr std::string_view kFoundNumber = "Expected identifier, got: ";
    if (message_.starts_with(kFoundNumber) && message_.find_first_of("0123456789") == kFoundNumber.size())
      return "write a decimal point, as in 0.5, not a comma, and only one number after a field's name";
    if (message_.starts_with("Message is too deep"))
      return "nest fewer pairs of braces; in a scene, put more than two solids into one union instead of nesting "
             "unions";
    if (message_.starts_with("Interpreting non ascii") || message_.starts_with("Invalid control"))
      return "save the file as plain text in UTF-8";
    return "correct this line; the name of a quantity ends in its unit, as in radius_m";
  }

  int line_ = 1;
  int column_ = 1;
  std::string message_;
};

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using ParseInfoTree = google::protobuf::TextFormat::ParseInfoTree;

/// The value of a number that is set once; nullopt for every other field.
std::optional<double> number_of(const Message& message, const FieldDescriptor& field) {
  if (field.is_repeated()) return std::nullopt;
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return message.GetReflection()->GetDouble(message, &field);
    case FieldDescriptor::CPPTYPE_UINT32:
      return message.GetReflection()->GetUInt32(message, &field);
    default:
      return std::nullopt;
  }
}

std::string place_text(const std::string& file, int line, int column) {
  return file + ":" + std::to_string(line) + ":" + std::to_string(column);
}

struct Places {
  std::vector<NumberPlaces::Place> numbers;
  std::vector<NumberPlaces::Text> texts;
  std::vector<NumberPlaces::Part> parts;
};

bool is_of(const NumberPlaces::Place& place, std::string_view field, double value) {
  return place.field == field.substr(field.rfind('.') + 1) &&
         (place.value == value || (std::isnan(place.value) && std::isnan(value)));
}

void collect(const Message& message, ParseInfoTree& tree, const std::string& source, Places& places) {
  std::vector<const FieldDescriptor*> fields;
  message.GetReflection()->ListFields(message, &fields);
  for (const FieldDescriptor* field : fields) {
    if (const std::optional<double> number = number_of(message, *field)) {
      const auto at = tree.GetLocation(field, -1);
      places.numbers.push_back({field->name(), *number, at.line + 1, at.column + 1});
    }
    if (field->cpp_type() == FieldDescriptor::CPPTYPE_STRING && !field->is_repeated()) {
      const auto at = tree.GetLocation(field, -1);
      places.texts.push_back(
          {field->name(), message.GetReflection()->GetString(message, field), byte_of(source, at.line, at.column)});
    }
    if (field->cpp_type() != FieldDescriptor::CPPTYPE_MESSAGE) continue;
    const int count = field->is_repeated() ? message.GetReflection()->FieldSize(message, field) : 1;
    for (int index = 0; index < count; ++index) {
      const Message& nested = field->is_repeated() ? message.GetReflection()->GetRepeatedMessage(message, field, index)
                                                   : message.GetReflection()->GetMessage(message, field);
      const int place = field->is_repeated() ? index : -1;
      const auto at = tree.GetLocation(field, place);
      const std::size_t part = places.parts.size();
      places.parts.push_back({&nested, at.line + 1, at.column + 1, places.numbers.size(), 0});
      if (ParseInfoTree* below = tree.GetTreeForNested(field, place); below != nullptr)
        collect(nested, *below, source, places);
      places.parts[part].end_number = places.numbers.size();
    }
  }
}

}  // namespace

std::string NumberPlaces::where(const std::string& file, std::string_view field, double value) const {
  for (const Place& place : places_)
    if (is_of(place, field, value)) return place_text(file, place.line, place.column);
  return file;
}

const NumberPlaces::Part* NumberPlaces::find(const Message& part) const noexcept {
  const auto found = std::ranges::find(parts_, &part, &Part::message);
  return found == parts_.end() ? nullptr : &*found;
}

std::string NumberPlaces::where(const std::string& file, const Message& part) const {
  const Part* const found = find(part);
  return found == nullptr ? file : place_text(file, found->line, found->column);
}

std::string NumberPlaces::where(const std::string& file, const Message& part, std::string_view field,
                                double value) const {
  const Part* const found = find(part);
  if (found == nullptr) return where(file, field, value);
  for (std::size_t i = found->first_number; i < found->end_number; ++i)
    if (is_of(places_[i], field, value)) return place_text(file, places_[i].line, places_[i].column);
  return place_text(file, found->line, found->column);
}

std::string NumberPlaces::where(const std::string& file, std::string_view field, std::string_view value,
                                std::size_t offset) const {
  for (const Text& text : texts_) {
    if (text.field != field || text.value != value) continue;
    const TextPlace at = place_in_quoted(source_, text.byte, offset);
    return place_text(file, at.line, at.column);
  }
  return file;
}

Result<NumberPlaces> parse_text_format(const std::string& text, const std::string& name,
                                       google::protobuf::Message& message) {
  if (const std::size_t valid = valid_utf8_bytes(text); valid < text.size()) {
    const TextPlace at = place_of(text, valid);
    return Error{.what = "the text is not UTF-8",
                 .where = place_text(name, at.line, at.column),
                 .fix = "save the file as plain text in UTF-8"};
  }
  FirstError first_error;
  ParseInfoTree tree;
  google::protobuf::TextFormat::Parser parser;
  parser.RecordErrorsTo(&first_error);
  parser.WriteLocationsTo(&tree);
  parser.SetRecursionLimit(kMostNesting);
  if (!parser.ParseFromString(text, &message)) return first_error.error(name);
  Places places;
  collect(message, tree, text, places);
  return NumberPlaces(std::move(places.numbers), std::move(places.texts), std::move(places.parts), text);
}

Result<NumberPlaces> read_text_format(const std::filesystem::path& file, google::protobuf::Message& message) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) return Error{.what = "cannot be read: " + code.message(), .where = file.string(), .fix = "check the path"};
  if (size > kMaxTextBytes)
    return Error{.what = "is larger than 1 MiB",
                 .where = file.string(),
                 .fix = "give a protobuf text-format file, such as a scene"};
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) return Error{.what = "cannot be read", .where = file.string(), .fix = "check its permissions"};
  return parse_text_format(text.str(), file.string(), message);
}

}  // namespace telepalp::program
