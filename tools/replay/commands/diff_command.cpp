#include "tools/replay/commands/diff_command.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/util/message_differencer.h>

#include <array>
#include <cstdio>
#include <memory>

#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/mcap/reader.h"
#include "support/program/options.h"

namespace telepalp::replay {
namespace {

constexpr std::size_t kMostFieldsBytes = 2000;

std::string at_s(const wire::Message& message) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.6f s", to_seconds(message.published.time_since_epoch()));
  return text.data();
}

/// What differs in two messages of one type, field by field; empty if the type is not known.
std::string fields_that_differ(const wire::Message& a, const wire::Message& b) {
  const google::protobuf::Descriptor* type =
      google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(std::string(a.topic.schema));
  if (type == nullptr) return {};
  const google::protobuf::Message* prototype =
      google::protobuf::MessageFactory::generated_factory()->GetPrototype(type);
  const std::unique_ptr<google::protobuf::Message> left(prototype->New());
  const std::unique_ptr<google::protobuf::Message> right(prototype->New());
  if (!left->ParseFromString(*a.payload) || !right->ParseFromString(*b.payload))
    return "one of the two messages is damaged\n";
  std::string fields;
  google::protobuf::util::MessageDifferencer differencer;
  differencer.ReportDifferencesToString(&fields);
  (void)differencer.Compare(*left, *right);
  if (fields.size() > kMostFieldsBytes) fields = fields.substr(0, kMostFieldsBytes) + "\n…\n";
  return fields;
}

std::string describe(std::uint64_t number, const wire::Message& a, const wire::Message& b) {
  const std::string which = "message " + std::to_string(number);
  if (a.topic.name != b.topic.name)
    return which + ": " + std::string(a.topic.name) + " at " + at_s(a) + " in the first, " + std::string(b.topic.name) +
           " at " + at_s(b) + " in the second\n";
  if (a.published != b.published)
    return which + ", " + std::string(a.topic.name) + ": at " + at_s(a) + " in the first, at " + at_s(b) +
           " in the second\n";
  return which + ", " + std::string(a.topic.name) + " at " + at_s(a) + ":\n" + fields_that_differ(a, b);
}

bool equal(const wire::Message& a, const wire::Message& b) {
  return a.topic.name == b.topic.name && a.published == b.published && *a.payload == *b.payload;
}

program::Usage usage() {
  return {.program = "telepalp-replay diff",
          .purpose = "prints the first message in which two sessions differ",
          .positional = "A.mcap B.mcap",
          .options = {},
          .example = "telepalp-replay diff session.mcap out/session.mcap"};
}

}  // namespace

Result<std::optional<std::string>> first_difference(const std::filesystem::path& a, const std::filesystem::path& b) {
  Result<wire::McapReader> first = wire::McapReader::open(a);
  if (!first) return first.error();
  Result<wire::McapReader> second = wire::McapReader::open(b);
  if (!second) return second.error();
  for (std::uint64_t number = 1;; ++number) {
    const Result<std::optional<wire::Message>> left = first->next();
    if (!left) return left.error();
    const Result<std::optional<wire::Message>> right = second->next();
    if (!right) return right.error();
    if (!*left && !*right) return std::optional<std::string>{};
    if (!*left || !*right)
      return std::optional("the " + std::string(*left ? "second" : "first") + " ends after " +
                           std::to_string(number - 1) + " messages, and the other goes on\n");
    if (!equal(**left, **right)) return std::optional(describe(number, **left, **right));
  }
}

int diff_command(int argc, const char* const* argv) {
  const Result<std::optional<program::Arguments>> read = program::read_arguments(usage(), argc, argv);
  if (!read) return program::fail(read.error(), program::kAskedWrongly);
  if (!*read) return program::kDone;
  if ((*read)->positional().size() != 2)
    return program::fail({.what = "two sessions are compared",
                          .where = "telepalp-replay diff",
                          .fix = "give two files: telepalp-replay diff A.mcap B.mcap"},
                         program::kAskedWrongly);
  const auto difference = first_difference((*read)->positional()[0], (*read)->positional()[1]);
  if (!difference) return program::fail(difference.error());
  if (!*difference) {
    std::puts("equal: every message has the same topic, time and bytes");
    return program::kDone;
  }
  std::fputs((*difference)->c_str(), stdout);
  return program::kFailed;
}

}  // namespace telepalp::replay
