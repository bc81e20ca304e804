#include "haptic_station/solids/polish.h"

#include <fstream>
#include <sstream>

#include "haptic_station/solids/text/rigid_matrix.h"
#include "haptic_station/solids/text/tokens.h"
#include "proto/words/number_word.h"

namespace telepalp::solids {
namespace {

std::string quoted(std::string_view text) {
  constexpr std::size_t kShown = 40;
  if (text.empty()) return "the end of the text";
  return "'" + std::string(text.substr(0, kShown)) + (text.size() > kShown ? "...'" : "'");
}

std::string all_words() {
  std::string list;
  for (const Word& word : words()) list += std::string(list.empty() ? "" : " ") + std::string(word.word);
  return list + " tm";
}

/// Reads nodes in prefix order. A list of the operands that are missing takes the place of recursion.
class PolishReader {
 public:
  PolishReader(std::string_view text, const std::string& name, const MeshReader& meshes)
      : tokens_(text), name_(name), meshes_(meshes) {}

  Result<Solid> read() {
    while (!missing_.empty())
      if (const Result<void> done = read_node(); !done) return done.error();
    const Token more = tokens_.next();
    if (!more.text.empty())
      return error(more, "found " + quoted(more.text) + " after the end of the solid",
                   "join two solids by +, as in + A B");
    return std::move(solid_);
  }

 private:
  struct Missing {
    std::string_view of;  ///< the operator
    int operand;
    int level;
  };

  [[nodiscard]] std::string where(const Token& token) const {
    return name_ + ":" + std::to_string(token.line) + ":" + std::to_string(token.column);
  }
  [[nodiscard]] Error error(const Token& token, std::string what, std::string fix) const {
    return {.what = std::move(what), .where = where(token), .fix = std::move(fix)};
  }

  [[nodiscard]] Error not_a_word(const Token& token, const Missing& missing) const {
    const std::string wanted = missing.of.empty() ? std::string("a solid")
                                                  : "the solid that is operand " + std::to_string(missing.operand) +
                                                        " of " + std::string(missing.of);
    const std::string found = "expected " + wanted + ", found " + quoted(token.text);
    if (token.text.starts_with("...")) return error(token, found, "write out the solids that the dots stand for");
    if (missing.of == "sc" && signed_number_of(token.text))
      return error(token, found, "give sc one number, which scales all three axes alike");
    if (signed_number_of(token.text))
      return error(token, found, "remove the number, or put a word such as sphere before it");
    return error(token, found, "use one of: " + all_words());
  }

  Result<void> read_node() {
    const Token token = tokens_.next();
    const Missing missing = missing_.back();
    missing_.pop_back();
    if (missing.level > kMostNesting)
      return error(token, "operators nest deeper than " + std::to_string(kMostNesting) + " levels",
                   "join solids by a chain of unions, + A + B C, which does not nest");
    if (solid_.size() >= kMostNodes)
      return error(token, "the solid has more than " + std::to_string(kMostNodes) + " shapes and operators",
                   "give fewer solids");
    if (token.text == "tm") return read_matrix(token, missing.level);
    const auto word = find_word(token.text);
    if (!word) return not_a_word(token, missing);
    Node node{.word = *word};
    if (node.kind().op == Op::Mesh) {
      node.file = tokens_.next().text;
      if (node.file.empty())
        return error(token, "no file name follows the word mesh",
                     "write mesh FILE unit_m cell_m, with the file of a closed mesh");
    }
    std::array<Token, 7> places;
    if (const Result<void> done = read_numbers(node.kind(), node.numbers, places); !done) return done.error();
    if (const auto complaint = complaint_about(node))
      return error(places[complaint->number], complaint->what, complaint->fix);
    if (node.kind().op == Op::Mesh) {
      auto lattice = meshes_(node.file, node.numbers[0], node.numbers[1]);
      if (!lattice) return error(token, lattice.error().where + ": " + lattice.error().what, lattice.error().fix);
      node.lattice = std::move(lattice).value();
    }
    expect_operands(node.kind(), missing.level);
    solid_.push_back(std::move(node));
    return {};
  }

  void expect_operands(const Word& word, int level) {
    for (int i = word.operands; i > 0; --i) {
      const bool chain = word.op == Op::Union && i == word.operands;
      missing_.push_back({word.word, i, chain ? level : level + 1});
    }
  }

  Result<double> read_number(std::string_view of, std::string_view kind, Token& place) {
    place = tokens_.next();
    if (const auto value = signed_number_of(place.text)) return *value;
    const std::string wanted = "expected " + std::string(kind) + " of " + std::string(of);
    const bool comma = place.text.find(',') != std::string_view::npos;
    return error(place, wanted + ", found " + quoted(place.text),
                 comma ? "write a decimal point, and spaces between numbers" : "give a number such as 0.02");
  }

  Result<void> read_numbers(const Word& word, std::array<double, 7>& numbers, std::array<Token, 7>& places) {
    for (std::size_t i = 0; i < word.numbers.size(); ++i) {
      const Result<double> value = read_number(word.word, word.numbers[i].name, places[i]);
      if (!value) return value.error();
      numbers[i] = *value;
    }
    return {};
  }

  Result<void> read_matrix(const Token& at, int level) {
    std::array<double, 12> matrix{};
    for (double& one : matrix) {
      Token place;
      const Result<double> value = read_number("tm", "a number of the matrix", place);
      if (!value) return value.error();
      one = *value;
    }
    const Result<Solid> placement = placement_of(matrix, where(at));
    if (!placement) return placement.error();
    for (const Node& node : *placement) {
      if (const auto complaint = complaint_about(node)) return error(at, complaint->what, complaint->fix);
      solid_.push_back(node);
    }
    missing_.push_back({"tm", 1, level + 2});
    return {};
  }

  Tokens tokens_;
  const std::string& name_;
  const MeshReader& meshes_;
  std::vector<Missing> missing_{{"", 1, 0}};  ///< the next one is last
  Solid solid_;
};

std::string shortest(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), end.ptr};
}

}  // namespace

Result<std::shared_ptr<const DistanceLattice>> no_meshes(const std::string& file, double, double) {
  return Error{.what = "the solid's Polish notation names this mesh file, but only shapes are accepted here",
               .where = file,
               .fix = "describe the solid by shapes such as sphere and capsule"};
}

Result<Solid> parse_polish(std::string_view text, const std::string& name, const MeshReader& meshes) {
  if (text.size() > kMostPolishBytes)
    return Error{.what = "the text in Polish notation is larger than 4 MiB",
                 .where = name,
                 .fix = "give fewer shapes and operators"};
  return PolishReader(text, name, meshes).read();
}

Result<Solid> read_polish(const std::filesystem::path& file, const MeshReader& meshes) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) return Error{.what = "cannot be read: " + code.message(), .where = file.string(), .fix = "check the path"};
  if (size > kMostPolishBytes)
    return Error{.what = "is larger than 4 MiB",
                 .where = file.string(),
                 .fix = "give a solid in Polish notation, with fewer shapes"};
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) return Error{.what = "cannot be read", .where = file.string(), .fix = "check its permissions"};
  return parse_polish(text.str(), file.string(), meshes);
}

std::string to_polish(const Solid& solid) {
  std::string text;
  for (const Node& node : solid) {
    text += std::string(text.empty() ? "" : " ") + std::string(node.kind().word);
    if (!node.file.empty()) text += " " + node.file;
    for (std::size_t i = 0; i < node.kind().numbers.size(); ++i) text += " " + shortest(node.numbers[i]);
  }
  return text;
}

}  // namespace telepalp::solids
