#include "support/program/message_json.h"

#include <google/protobuf/util/json_util.h>

#include <utility>

#include "proto/words/error_line.h"

namespace telepalp::program {

std::string to_json(const google::protobuf::Message& message) {
  google::protobuf::util::JsonPrintOptions options;
  options.always_print_primitive_fields = true;
  options.preserve_proto_field_names = true;
  std::string json;
  return google::protobuf::util::MessageToJsonString(message, &json, options).ok() ? json : "{}";
}

Result<void> read_json(const std::string& json, google::protobuf::Message& message, std::string where,
                       std::string fix) {
  const auto parsed = google::protobuf::util::JsonStringToMessage(json, &message);
  if (parsed.ok()) return {};
  return Error{.what = "the JSON cannot be read: " + first_line(std::string(parsed.message())),
               .where = std::move(where),
               .fix = std::move(fix)};
}

}  // namespace telepalp::program
