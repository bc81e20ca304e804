#include "haptic_station/tracking/protocol/leap_v6.h"

#include <google/protobuf/util/json_util.h>

#include "haptic_station/tracking/hand_axes.h"
#include "messages/leap_v6.pb.h"

namespace telepalp::tracking::leap {
namespace {

namespace json = google::protobuf::util;

constexpr double kFurthest_mm = 10'000.0;
constexpr double kFastest_mm_per_s = 100'000.0;
constexpr double kMetres = 1e-3;
constexpr std::int64_t kLatest_us = std::int64_t{1} << 53;

Error refused(std::string what) {
  return {.what = std::move(what),
          .where = "message of the Leap service",
          .fix =
              "check that the URL of --tracker leap:URL ends in /v6.json, and that the service writes numbers with "
              "decimal points"};
}

using Numbers = google::protobuf::RepeatedField<double>;

std::optional<Eigen::Vector3d> three(const Numbers& numbers, double most) {
  if (numbers.size() != 3) return std::nullopt;
  const Eigen::Vector3d v(numbers[0], numbers[1], numbers[2]);
  if (!v.allFinite() || v.cwiseAbs().maxCoeff() > most) return std::nullopt;
  return v * kMetres;
}

std::optional<Eigen::Vector3d> direction(const Numbers& numbers) {
  const auto unit = three(numbers, 1.001);
  return unit ? std::optional<Eigen::Vector3d>(*unit / kMetres) : std::nullopt;
}

std::optional<Hand> hand_of(const leap_v6::Text::Hand& hand_text) {
  const auto palm = three(hand_text.palmposition(), kFurthest_mm);
  if (!palm) return std::nullopt;
  Hand hand{.id = hand_text.id(), .palm = {*palm}, .velocity = {}, .attitude = {}};
  if (const auto velocity = three(hand_text.palmvelocity(), kFastest_mm_per_s)) hand.velocity.v = *velocity;
  const auto fingers = direction(hand_text.direction());
  const auto out_of_palm = direction(hand_text.palmnormal());
  if (fingers && out_of_palm) hand.attitude = hand_axes(*fingers, *out_of_palm);
  return hand;
}

}  // namespace

Result<Text> parse_text(std::string_view text) {
  if (text.size() > kMostTextBytes) return refused("the message is longer than 256 KiB");
  json::JsonParseOptions options;
  options.ignore_unknown_fields = true;
  leap_v6::Text message;
  if (const auto read = json::JsonStringToMessage({text.data(), text.size()}, &message, options); !read.ok())
    return refused("the text is not a message of version 6 of the Leap protocol: " + read.ToString().substr(0, 200));
  if (message.has_version()) return Text{Hello{message.version(), message.serviceversion()}};
  if (!message.has_timestamp()) return Text{Other{}};
  if (message.timestamp() < 0 || message.timestamp() > kLatest_us)
    return refused("the timestamp of the message is below 0 or above 2^53 us");
  if (static_cast<std::size_t>(message.hands_size()) > kMostHands)
    return refused("the message lists more than 16 hands");
  Frame frame{.timestamp_us = message.timestamp(), .hands = {}, .refused = 0};
  for (const leap_v6::Text::Hand& one : message.hands()) {
    if (const auto hand = hand_of(one))
      frame.hands.push_back(*hand);
    else
      ++frame.refused;
  }
  return Text{std::move(frame)};
}

}  // namespace telepalp::tracking::leap
