#include "tools/replay/workers/cell_order.h"

#include <google/protobuf/io/tokenizer.h>
#include <google/protobuf/text_format.h>
#include <messages/scene.pb.h>
#include <messages/sweep.pb.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace telepalp::replay {
namespace {

constexpr std::size_t kLongestText = 4096;
constexpr std::size_t kLongestScene = std::size_t{256} << 10U;
constexpr int kMostAxes = 16;
constexpr std::size_t kIdentityDigits = 16;
constexpr std::size_t kSha256Digits = 64;
constexpr int kDeepestScene = 64;  // nested messages; the deepest scene of the library has 9

Error order_refused(const std::string& what) {
  return {.what = what,
          .where = "order of a cell",
          .fix = "give the sweep's command again, with the telepalp-replay that came with this telepalp-worker"};
}

/// True if `text` can be a word of a command line.
bool is_word(std::string_view text, std::size_t longest = kLongestText) noexcept {
  return text.size() <= longest &&
         std::ranges::none_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
}

bool is_axis_name(std::string_view text) noexcept {
  return !text.empty() && text.size() <= 32 && std::ranges::all_of(text, [](char c) { return c >= 'a' && c <= 'z'; });
}

std::optional<Recording::Kind> kind_of(msg::SweepRecording::Kind kind) noexcept {
  switch (kind) {
    case msg::SweepRecording::MCAP:
      return Recording::Kind::Mcap;
    case msg::SweepRecording::ONI:
      return Recording::Kind::Oni;
    case msg::SweepRecording::PCD:
      return Recording::Kind::Pcd;
    default:
      return std::nullopt;
  }
}

Result<Recording> recording_of(const msg::SweepRecording& message) {
  const auto kind = kind_of(message.kind());
  if (!kind) return order_refused("a recording of an unknown kind");
  if (!is_digest(message.sha256(), kSha256Digits)) return order_refused("a recording without its SHA-256");
  if (message.size_b() == 0 || message.size_b() > kMostRecording_B)
    return order_refused("a recording of " + std::to_string(message.size_b()) + " B, where 1 to " +
                         std::to_string(kMostRecording_B) + " are taken");
  if (message.chunk_b() < kLeastChunk_B || message.chunk_b() > kMostChunk_B)
    return order_refused("a recording in chunks of " + std::to_string(message.chunk_b()) + " B");
  return Recording{.kind = *kind, .sha256 = message.sha256(), .size_B = message.size_b(), .chunk_B = message.chunk_b()};
}

Result<void> check_words(const msg::SweepOrder& message, const OrderRules& rules) {
  if (!is_digest(message.sweep(), kIdentityDigits) || !is_digest(message.cell(), kIdentityDigits))
    return order_refused("a digest that is not 16 hexadecimal digits");
  if (!is_word(message.source()) || message.source().empty() || !is_word(message.assertions()) ||
      !is_word(message.source_digest(), kIdentityDigits))
    return order_refused("a source, digest or assertion that is empty, too long or has control characters");
  if (message.scene_text().size() > kLongestScene) return order_refused("a scene above 256 KiB");
  for (const auto& [name, value] : message.options()) {
    if (std::ranges::find(rules.options, name) == rules.options.end())
      return order_refused("the option '" + name.substr(0, 64) + "', which does not describe a run");
    if (!is_word(value) || value.empty())
      return order_refused("a value of --" + name + " that is empty, too long or has control characters");
  }
  return {};
}

bool has_field_of_a_file(const google::protobuf::Message& message) {
  using google::protobuf::FieldDescriptor;
  const auto& reflection = *message.GetReflection();
  std::vector<const FieldDescriptor*> fields;
  reflection.ListFields(message, &fields);
  return std::ranges::any_of(fields, [&](const FieldDescriptor* field) {
    if (field->type() == FieldDescriptor::TYPE_STRING) return field->name().ends_with("file");
    if (field->type() != FieldDescriptor::TYPE_MESSAGE) return false;
    if (!field->is_repeated()) return has_field_of_a_file(reflection.GetMessage(message, field));
    for (int i = 0; i < reflection.FieldSize(message, field); ++i)
      if (has_field_of_a_file(reflection.GetRepeatedMessage(message, field, i))) return true;
    return false;
  });
}

std::string exact(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

}  // namespace

bool is_digest(std::string_view text, std::size_t digits) noexcept {
  return text.size() == digits &&
         std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

bool is_plain_synthetic(std::string_view source) noexcept {
  constexpr std::string_view kSynthetic = "synthetic";
  if (!source.starts_with(kSynthetic)) return false;
  source.remove_prefix(kSynthetic.size());
  if (source.empty()) return true;
  if (!source.starts_with(':')) return false;
  const std::string_view model = source.substr(1, source.find(',') - 1);
  return model.empty() || model == "torso" || model.find('=') != model.npos;
}

bool names_a_file(const std::string& scene_text) {
  msg::Scene scene;
  google::protobuf::TextFormat::Parser parser;
  parser.SetRecursionLimit(kDeepestScene);
  class Silent : public google::protobuf::io::ErrorCollector {
    void AddError(int, google::protobuf::io::ColumnNumber, const std::string&) override {}
  } silent;
  parser.RecordErrorsTo(&silent);
  // A scene that cannot be parsed may name a file.
  return !parser.ParseFromString(scene_text, &scene) || has_field_of_a_file(scene);
}

std::string encode(const CellOrder& order) {
  msg::SweepOrder message;
  message.set_build(order.build);
  message.set_sweep(order.sweep);
  message.set_cell(order.cell);
  message.set_source(order.source);
  message.set_source_digest(order.source_digest);
  if (order.recording) {
    msg::SweepRecording& recording = *message.mutable_recording();
    recording.set_kind(static_cast<msg::SweepRecording::Kind>(order.recording->kind));
    recording.set_sha256(order.recording->sha256);
    recording.set_size_b(order.recording->size_B);
    recording.set_chunk_b(order.recording->chunk_B);
  }
  message.set_scene_text(order.scene_text);
  message.mutable_options()->insert(order.options.begin(), order.options.end());
  message.set_assertions(order.assertions);
  for (const auto& [axis, value] : order.at) {
    msg::SweepValue& at = *message.add_at();
    at.set_axis(axis);
    at.set_value(value);
  }
  return message.SerializeAsString();
}

Result<CellOrder> parse_order(std::string_view bytes, const OrderRules& rules) {
  if (bytes.size() > kMostOrder_B) return order_refused("it has " + std::to_string(bytes.size()) + " B");
  msg::SweepOrder message;
  if (!message.ParseFromArray(bytes.data(), static_cast<int>(bytes.size())))
    return order_refused("its bytes are no order");
  if (message.build() != rules.build)
    return order_refused("it is of another build, '" + message.build().substr(0, 80) + "', than this program, '" +
                         rules.build + "'");
  if (const Result<void> checked = check_words(message, rules); !checked) return checked.error();
  CellOrder order{.build = message.build(),
                  .sweep = message.sweep(),
                  .cell = message.cell(),
                  .source = message.source(),
                  .source_digest = message.source_digest(),
                  .scene_text = message.scene_text(),
                  .options = {message.options().begin(), message.options().end()},
                  .assertions = message.assertions()};
  if (message.has_recording()) {
    Result<Recording> recording = recording_of(message.recording());
    if (!recording) return recording.error();
    order.recording = *std::move(recording);
  } else if (!is_plain_synthetic(order.source)) {
    return order_refused("its source is neither a recording with a digest nor a synthetic patient without a file");
  }
  if (message.at_size() == 0 || message.at_size() > kMostAxes) return order_refused("it has no axes, or more than 16");
  for (const msg::SweepValue& at : message.at()) {
    if (!is_axis_name(at.axis()) || !std::isfinite(at.value()))
      return order_refused("an axis is misnamed, or its value is not finite");
    order.at.emplace_back(at.axis(), at.value());
  }
  return order;
}

std::vector<std::string> command_of(const CellOrder& order, const std::string& source, const std::string& scene) {
  std::vector<std::string> words{source, "--scene=" + scene};
  for (const auto& [name, value] : order.options)
    if (name != "scene") words.push_back("--" + name + "=" + value);
  if (!order.assertions.empty()) words.push_back("--assert=" + order.assertions);
  return words;
}

std::vector<std::string> axes_of(const CellOrder& order) {
  std::vector<std::string> words;
  for (const auto& [axis, value] : order.at) words.push_back(axis + "=" + exact(value));
  return words;
}

}  // namespace telepalp::replay
