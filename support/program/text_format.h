#pragma once

#include <google/protobuf/message.h>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::program {

/// Where the numbers of a text-format file stand, so that a value out of its bounds is named as precisely as a
/// misspelt field.
class NumberPlaces {
 public:
  struct Place {
    std::string field;
    double value;
    int line;    ///< from 1
    int column;  ///< from 1
  };
  explicit NumberPlaces(std::vector<Place> places = {}) : places_(std::move(places)) {}

  /// `file:line:column` of the first field of that name with that value; `file` alone when there is none. Of a path
  /// as `cylinder.radius_m` the last name counts.
  [[nodiscard]] std::string where(const std::string& file, std::string_view field, double value) const;

 private:
  std::vector<Place> places_;
};

/// Reads a Protobuf text-format file (a scene, a camera) into `message`. An unknown field, a wrong type or a
/// missing brace is an error with the file, line and column. Files over 1 MiB are refused.
[[nodiscard]] Result<NumberPlaces> read_text_format(const std::filesystem::path& file,
                                                    google::protobuf::Message& message);

/// The same from text; `name` stands for the file in errors.
[[nodiscard]] Result<NumberPlaces> parse_text_format(const std::string& text, const std::string& name,
                                                     google::protobuf::Message& message);

}  // namespace telepalp::program
