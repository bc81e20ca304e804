#include "server/recording/recording_command.h"

#include <algorithm>
#include <cctype>

#include "support/program/message_json.h"

namespace telepalp::recording {
namespace {

constexpr std::size_t kLongestConsent = 500;  // bytes: the 120 characters of the page take at most 480

constexpr const char* kWhere = "POST /recording";
constexpr const char* kExample =
    "send {\"record\":true,\"consent\":\"signed form, study 17\"} to begin, {\"record\":false} to end";

Error wrong(std::string what) { return {.what = std::move(what), .where = kWhere, .fix = kExample}; }

/// True for control characters, which one line of text must not contain.
bool is_control(char letter) { return std::iscntrl(static_cast<unsigned char>(letter)) != 0; }

}  // namespace

Result<msg::RecordingCommand> read_command(const std::string& json) {
  msg::RecordingCommand command;
  if (const Result<void> read = program::read_json(json, command, kWhere, kExample); !read) return read.error();
  if (!command.has_record()) return wrong("the command has no field \"record\"");
  const std::string& consent = command.consent();
  if (command.record() && std::all_of(consent.begin(), consent.end(), [](char letter) { return letter == ' '; }))
    return wrong("the command states no consent of the patient, without which nothing is recorded");
  if (consent.size() > kLongestConsent || std::any_of(consent.begin(), consent.end(), is_control))
    return wrong("the consent is not one line of at most 500 bytes");
  return command;
}

}  // namespace telepalp::recording
