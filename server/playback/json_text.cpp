#include "server/playback/json_text.h"

#include <google/protobuf/util/json_util.h>

#include <utility>

namespace telepalp::playback {

Result<void> read_json(const std::string& json, google::protobuf::Message& message, std::string fix) {
  const auto parsed = google::protobuf::util::JsonStringToMessage(json, &message);
  if (parsed.ok()) return {};
  return Error{
      .what = "the JSON cannot be read: " + std::string(parsed.message()), .where = "playback", .fix = std::move(fix)};
}

}  // namespace telepalp::playback
