#include "tools/study/designer/command.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "proto/words/number_word.h"

namespace telepalp::study {
namespace {

constexpr double kMostLength_m = 1.0;
constexpr double kMostAngle_rad = 2.0 * std::numbers::pi;
constexpr double kMostHand_mm = 10'000.0;

Error error(std::string what, std::string fix) {
  return {.what = std::move(what), .where = "designer", .fix = std::move(fix)};
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t from = text.find_first_not_of(' '); from != std::string_view::npos;) {
    const std::size_t end = std::min(text.size(), text.find(' ', from));
    words.push_back(text.substr(from, end - from));
    from = text.find_first_not_of(' ', end);
  }
  return words;
}

std::optional<double> bounded(std::string_view text, double most) {
  const std::optional<double> value = number_of(text);
  return value && std::abs(*value) <= most ? value : std::nullopt;  // NaN compares false
}

/// A linkage of a size that a hand can hold: it bounds what the program computes for one message.
Result<Command> design_of(std::string_view text) {
  Result<Design> read = parse_design(std::string(text), "design");
  if (!read) return read.error();
  if (read->configurations.size() != 1) return error("more than one linkage is given", "give one linkage");
  const Configuration& one = read->configurations.front();
  if (one.other)
    return error("the page has four-bar linkages alone", "leave kind out; telepalp-study --design takes it");
  const mechanism::FourBar& bar = one.bar;
  for (const double length_m :
       {bar.l1_m, bar.l2_m, bar.l3_m, bar.l4_m, bar.needle_m, bar.handle_m, std::abs(bar.handle_at_m)})
    if (length_m > kMostLength_m) return error("a length is over 1000 mm", "give lengths up to 1000 mm");
  for (const double angle_rad : {bar.needle_rad, bar.handle_rad})
    if (std::abs(angle_rad) > kMostAngle_rad)
      return error("theta or phi is over a full turn", "give angles from -2 pi to 2 pi rad");
  return Command(ChooseDesign{one});
}

/// Two numbers in mm; nullopt: they are not, or are over 10 m.
std::optional<Eigen::Vector2d> place_of(std::span<const std::string_view> words) {
  const auto x = words.size() == 2 ? bounded(words[0], kMostHand_mm) : std::nullopt;
  const auto y = words.size() == 2 ? bounded(words[1], kMostHand_mm) : std::nullopt;
  return x && y ? std::optional(Eigen::Vector2d(1e-3 * *x, 1e-3 * *y)) : std::nullopt;
}

Result<Command> hand_of(const std::vector<std::string_view>& words) {
  const auto at_m = place_of(words);
  if (!at_m) return error("the place of the hand is not two numbers of at most 10 m", "send hand X Y, in mm");
  return Command(AimHand{*at_m});
}

Result<Command> take_of(const std::vector<std::string_view>& words) {
  const auto at_m = words.size() == 3 ? place_of(std::span(words).subspan(1)) : std::nullopt;
  for (std::size_t i = 0; at_m && i < mechanism::kLinkParts; ++i)
    if (const auto part = static_cast<mechanism::LinkPart>(i);
        part != mechanism::LinkPart::Base && mechanism::name(part) == words[0])
      return Command(TakePart{part, *at_m});
  return error("what the hand takes is no moving part with two numbers of at most 10 m",
               "send take PART X Y, in mm; PART is link1, link2, link3, handle or needle");
}

Result<Command> press_of(const std::vector<std::string_view>& words) {
  if (words.size() == 1 && (words[0] == "0" || words[0] == "1")) return Command(PressButton{words[0] == "1"});
  return error("the button is neither 0 nor 1", "send press 1 or press 0");
}

Result<Command> turn_of(const std::vector<std::string_view>& words) {
  const auto by_rad = words.size() == 1 ? bounded(words[0], 1.0) : std::nullopt;
  if (!by_rad) return error("the turn is not one number of at most 1 rad", "send turn ANGLE, in rad");
  return Command(TurnHandle{*by_rad});
}

Result<Command> search_of(const std::vector<std::string_view>& words) {
  const auto evaluations = words.empty() ? std::nullopt : number_of<int>(words[0]);
  if (!evaluations || *evaluations < kLeastEvaluations || *evaluations > kMostEvaluations)
    return error("the number of mechanisms to judge is not from 40 to 2000", "send search NUMBER NAME=MIN:MAX ...");
  BeginSearch search{.box = {}, .evaluations = *evaluations};
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    if (equals == std::string_view::npos)
      return error("'" + std::string(words[i]) + "' is not NAME=MIN:MAX", "give a range, such as l1=60:120");
    const std::string name(words[i].substr(0, equals));
    if (const Result<void> set = set_range(search.box, name, words[i].substr(equals + 1), name); !set)
      return set.error();
  }
  const Result<SearchBox> good = checked(search.box);
  if (!good) return good.error();
  return Command(std::move(search));
}

}  // namespace

Result<Command> parse_command(std::string_view message) {
  if (message.size() > kMostCommandBytes)
    return error("the message has more than " + std::to_string(kMostCommandBytes) + " bytes", "send a shorter one");
  const std::size_t end = std::min(message.size(), message.find(' '));
  const std::string_view verb = message.substr(0, end);
  if (verb == "design") return design_of(message.substr(end));
  const std::vector<std::string_view> words = words_of(message.substr(end));
  if (verb == "take") return take_of(words);
  if (verb == "hand") return hand_of(words);
  if (verb == "press") return press_of(words);
  if (verb == "turn") return turn_of(words);
  if (verb == "search") return search_of(words);
  if (verb == "renew" && words.empty()) return Command(RenewTissue{});
  if (verb == "predict" && words.empty()) return Command(AskPrediction{});
  if (verb == "cancel" && words.empty()) return Command(EndSearch{});
  return error("this is no message of the designer's page",
               "send design, take, hand, press, turn, renew, predict, search or cancel");
}

}  // namespace telepalp::study
