#include "haptic_station/scenes/layer_warnings.h"

#include <numbers>

#include "haptic_station/solids/solid_tree.h"

namespace telepalp::scenes {
namespace {

using solids::Node;
using solids::Op;
using solids::Solid;

constexpr std::size_t kMostOperators = 2000;  // of which the operands are compared: each is built once more

/// Bytes before the `count`-th word `word` of a text in Polish notation, from 0; npos: there are fewer.
std::size_t offset_of_word(std::string_view text, std::string_view word, std::size_t count) {
  bool comment = false;
  for (std::size_t at = 0; at < text.size();) {
    if (comment || text[at] == '#') {
      comment = text[at] != '\n';
      ++at;
      continue;
    }
    const std::size_t end = std::min(text.find_first_of(" \t\r\n#", at), text.size());
    if (text.substr(at, end - at) == word && count-- == 0) return at;
    at = std::max(end, at + 1);
  }
  return std::string_view::npos;
}

class SolidWarnings {
 public:
  SolidWarnings(FieldCheck& check, const msg::SolidEffect& message, const Solid& solid)
      : check_(check), message_(message), solid_(solid) {}

  void warn() {
    for (std::size_t i = 0; i < solid_.size(); ++i) {
      const Op op = solid_[i].kind().op;
      if (op == Op::Torus) torus(i);
      if (op == Op::Arc) arc(i);
      if (solid_.size() > kMostOperators) continue;
      if (op == Op::Difference) difference(i);
      if (op == Op::Clip) clip(i);
    }
  }

 private:
  void torus(std::size_t i) {
    const auto& n = solid_[i].numbers;
    if (n[1] <= n[0]) return;
    complain(i,
             "the tube's radius, " + number_text(n[1]) + " m, is above the ring's, " + number_text(n[0]) +
                 " m, so the ring has no hole",
             "give the ring's radius first, then the tube's");
  }

  void arc(std::size_t i) {
    const auto& n = solid_[i].numbers;
    constexpr double kTurn_rad = 2.0 * std::numbers::pi + 0.01;
    if (std::abs(n[2]) > kTurn_rad || std::abs(n[3]) > kTurn_rad) return;
    complain(i, "the arc goes from " + number_text(n[2]) + " to " + number_text(n[3]) + " degrees",
             "give degrees, not radians: 180 is half a turn");
  }

  void difference(std::size_t i) {
    const std::size_t second = solids::end_of(solid_, i + 1);
    const auto kept = box_of(i + 1), taken = box_of(second);
    if (kept && taken && (kept->low.array() > taken->high.array() || taken->low.array() > kept->high.array()).any())
      complain(i, "the second solid of - does not reach the first, so nothing is taken away",
               "move the second solid to where it shall be taken away");
  }

  void clip(std::size_t i) {
    const auto box = box_of(i + 1);
    if (!box || !box->bounded()) return;
    const Eigen::Vector3d normal(solid_[i].numbers[0], solid_[i].numbers[1], solid_[i].numbers[2]);
    const Eigen::Vector3d farthest = (normal.array() > 0.0).select(box->high, box->low);
    if (normal.dot(farthest) < solid_[i].numbers[3])
      complain(i, "the plane of clip does not reach the solid, so nothing is cut off",
               "give the offset along the normal up to which the solid is kept; clip cuts in the solid's own frame");
  }

  [[nodiscard]] std::optional<solids::Box> box_of(std::size_t operand) const {
    const auto begin = solid_.begin() + static_cast<std::ptrdiff_t>(operand);
    const auto end = solid_.begin() + static_cast<std::ptrdiff_t>(solids::end_of(solid_, operand));
    const auto tree = solids::build_tree(Solid(begin, end));
    if (!tree) return std::nullopt;
    return (*tree)->box();
  }

  void complain(std::size_t i, const std::string& what, std::string fix) {
    check_.warn("layer " + message_.name() + ": " + what, std::move(fix), place_of(i));
  }

  [[nodiscard]] std::string place_of(std::size_t node) const {
    const std::string_view word = solid_[node].kind().word;
    std::size_t before = 0;
    for (std::size_t i = 0; i < node; ++i) before += solid_[i].kind().word == word ? 1 : 0;
    const std::size_t offset =
        message_.has_polish() ? offset_of_word(message_.polish(), word, before) : std::string_view::npos;
    if (offset == std::string_view::npos) return check_.place();
    const std::string place = check_.places().where(check_.file(), "polish", message_.polish(), offset);
    return place == check_.file() ? check_.place() : place;
  }

  FieldCheck& check_;
  const msg::SolidEffect& message_;
  const Solid& solid_;
};

}  // namespace

void warn_about_solid(FieldCheck& check, const msg::SolidEffect& message, const Solid& solid) {
  SolidWarnings(check.in(message), message, solid).warn();
}

}  // namespace telepalp::scenes
