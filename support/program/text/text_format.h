#pragma once

#include <google/protobuf/message.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::program {

/// Line and column of each number, text and nested message in a text-format file, for errors about a value. Numbers and
/// texts of repeated fields are left out.
class NumberPlaces {
 public:
  struct Place {
    std::string field;
    double value;
    int line;    ///< from 1
    int column;  ///< from 1
  };
  struct Text {
    std::string field;
    std::string value;
    std::size_t byte;  ///< offset of the field's name in the file [B]
  };
  /// A nested message and the numbers in it.
  struct Part {
    const google::protobuf::Message* message;  ///< only its address is compared
    int line;                                  ///< from 1
    int column;                                ///< from 1
    std::size_t first_number;                  ///< index of its first number among all numbers of the file
    std::size_t end_number;                    ///< index after its last number
  };
  explicit NumberPlaces(std::vector<Place> places = {}, std::vector<Text> texts = {}, std::vector<Part> parts = {},
                        std::string source = {})
      : places_(std::move(places)), texts_(std::move(texts)), parts_(std::move(parts)), source_(std::move(source)) {}

  /// `file:line:column` of the first number whose field is named `field` and whose value is `value`; `file` alone when
  /// no number matches. Of a path such as `cylinder.radius_m` only the last name is compared.
  [[nodiscard]] std::string where(const std::string& file, std::string_view field, double value) const;

  /// `file:line:column` of byte `offset`, from 0, of the first text whose field is named `field` and whose value is
  /// `value`; `file` alone when no text matches.
  [[nodiscard]] std::string where(const std::string& file, std::string_view field, std::string_view value,
                                  std::size_t offset) const;

  /// `file:line:column` of the name of `part`, a message inside the parsed message. The parsed message must not have
  /// moved in memory since it was parsed. `file` alone if `part` is not inside the parsed message.
  [[nodiscard]] std::string where(const std::string& file, const google::protobuf::Message& part) const;

  /// As where(file, field, value), for the numbers inside `part`; the position of `part` when no number inside it
  /// matches. For a `part` outside the parsed message, all numbers of the file are compared.
  [[nodiscard]] std::string where(const std::string& file, const google::protobuf::Message& part,
                                  std::string_view field, double value) const;

  /// The parsed text.
  [[nodiscard]] const std::string& source() const noexcept { return source_; }

 private:
  [[nodiscard]] const Part* find(const google::protobuf::Message& part) const noexcept;

  std::vector<Place> places_;
  std::vector<Text> texts_;
  std::vector<Part> parts_;
  std::string source_;
};

/// Reads a Protobuf text-format file (a scene, a camera) into `message`. Error: an unknown field, a wrong type or a
/// missing brace, reported with file, line and column; or a file over 1 MiB.
[[nodiscard]] Result<NumberPlaces> read_text_format(const std::filesystem::path& file,
                                                    google::protobuf::Message& message);

/// Parses text-format text. `name`: the file's name, for errors.
[[nodiscard]] Result<NumberPlaces> parse_text_format(const std::string& text, const std::string& name,
                                                     google::protobuf::Message& message);

}  // namespace telepalp::program
