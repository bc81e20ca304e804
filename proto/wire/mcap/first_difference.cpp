#include "proto/wire/mcap/first_difference.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/util/message_differencer.h>

#include <array>
#include <cstdio>
#include <memory>

#include "messages/camera.pb.h"
#include "messages/station.pb.h"
#include "proto/wire/mcap/reader.h"

namespace telepalp::wire {
namespace {

constexpr std::size_t kMostFieldsBytes = 2000;

std::string at_s(const Message& message) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.6f s of session time", to_seconds(message.published.time_since_epoch()));
  return text.data();
}

/// What differs in two messages of one type, field by field; empty if the type is not known.
std::string fields_that_differ(const Message& a, const Message& b) {
  const google::protobuf::Descriptor* type =
      google::protobuf::DescriptorPool::generated_pool()->FindMessageTypeByName(std::string(a.topic.schema));
  if (type == nullptr) return {};
  const google::protobuf::Message* prototype =
      google::protobuf::MessageFactory::generated_factory()->GetPrototype(type);
  const std::unique_ptr<google::protobuf::Message> left(prototype->New());
  const std::unique_ptr<google::protobuf::Message> right(prototype->New());
  if (!left->ParseFromString(*a.payload) || !right->ParseFromString(*b.payload))
    return "the message is damaged in one of the files, so that its fields are not compared\n";
  std::string fields;
  google::protobuf::util::MessageDifferencer differencer;
  differencer.ReportDifferencesToString(&fields);
  (void)differencer.Compare(*left, *right);
  if (fields.size() > kMostFieldsBytes) fields = fields.substr(0, kMostFieldsBytes) + "\n…\n";
  return fields;
}

std::string describe(std::uint64_t number, const Message& a, const Message& b) {
  const std::string which = "message " + std::to_string(number);
  if (a.topic.name != b.topic.name)
    return which + ": " + std::string(a.topic.name) + " at " + at_s(a) + " in the first file, " +
           std::string(b.topic.name) + " at " + at_s(b) + " in the second file\n";
  if (a.published != b.published)
    return which + ", " + std::string(a.topic.name) + ": at " + at_s(a) + " in the first file, at " + at_s(b) +
           " in the second file\n";
  return which + ", " + std::string(a.topic.name) + " at " + at_s(a) + ":\n" + fields_that_differ(a, b);
}

bool equal(const Message& a, const Message& b) {
  return a.topic.name == b.topic.name && a.published == b.published && *a.payload == *b.payload;
}

}  // namespace

Result<std::optional<std::string>> first_difference(const std::filesystem::path& a, const std::filesystem::path& b) {
  Result<McapReader> first = McapReader::open(a);
  if (!first) return first.error();
  Result<McapReader> second = McapReader::open(b);
  if (!second) return second.error();
  for (std::uint64_t number = 1;; ++number) {
    const Result<std::optional<Message>> left = first->next();
    if (!left) return left.error();
    const Result<std::optional<Message>> right = second->next();
    if (!right) return right.error();
    if (!*left && !*right) return std::optional<std::string>{};
    if (!*left || !*right)
      return std::optional("the " + std::string(*left ? "second" : "first") + " file ends after " +
                           std::to_string(number - 1) + (number == 2 ? " message; the " : " messages; the ") +
                           (*left ? "first" : "second") + " file has more\n");
    if (!equal(**left, **right)) return std::optional(describe(number, **left, **right));
  }
}

}  // namespace telepalp::wire
