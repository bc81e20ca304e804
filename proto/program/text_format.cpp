#include "proto/program/text_format.h"

#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>

#include <fstream>
#include <sstream>

namespace telepalp::program {
namespace {

constexpr std::uintmax_t kMaxTextBytes = 1 << 20;

/// Keeps the first complaint: the later ones are mostly its echoes.
class FirstError : public google::protobuf::io::ErrorCollector {
 public:
  void AddError(int line, google::protobuf::io::ColumnNumber column, const std::string& message) override {
    if (!message_.empty()) return;
    line_ = line + 1;
    column_ = column + 1;
    message_ = message;
  }
  [[nodiscard]] Error error(const std::string& name) const {
    return {.what = message_.empty() ? "not a text-format file" : message_,
            .where = name + ":" + std::to_string(line_) + ":" + std::to_string(column_),
            .fix = "correct that line; names carry their unit, as in radius_m"};
  }

 private:
  int line_ = 1;
  int column_ = 1;
  std::string message_;
};

}  // namespace

Result<void> parse_text_format(const std::string& text, const std::string& name, google::protobuf::Message& message) {
  FirstError first_error;
  google::protobuf::TextFormat::Parser parser;
  parser.RecordErrorsTo(&first_error);
  if (!parser.ParseFromString(text, &message)) return first_error.error(name);
  return {};
}

Result<void> read_text_format(const std::filesystem::path& file, google::protobuf::Message& message) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) return Error{.what = "cannot be read: " + code.message(), .where = file.string(), .fix = "check the path"};
  if (size > kMaxTextBytes)
    return Error{.what = "larger than 1 MiB", .where = file.string(), .fix = "give a text-format file"};
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) return Error{.what = "cannot be read", .where = file.string(), .fix = "check its permissions"};
  return parse_text_format(text.str(), file.string(), message);
}

}  // namespace telepalp::program
