#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "proto/words/frames.h"
#include "proto/words/result.h"
#include "support/program/text_format.h"

namespace telepalp::scenes {

/// What a number may be. `unit` is for the message alone.
struct Range {
  double least;
  double most;
  std::string_view unit;
};

/// Collects the first value out of its range while a message is read field by field.
class FieldCheck {
 public:
  explicit FieldCheck(std::string file, program::NumberPlaces places = program::NumberPlaces())
      : file_(std::move(file)), places_(std::move(places)) {}

  /// `value` into `into` when it is within `range`; otherwise remembers the complaint about `field`.
  void number(std::string_view field, double value, const Range& range, double& into) {
    if (std::isfinite(value) && value >= range.least && value <= range.most) {
      into = value;
      return;
    }
    complain(std::string(field) + " is " + text(value) + " " + std::string(range.unit) + ", outside " +
                 text(range.least) + " to " + text(range.most) + " " + std::string(range.unit),
             "give " + std::string(field) + " in " + std::string(range.unit) + " within that range",
             places_.where(file_, field, value));
  }

  /// Of something that a field names, such as a file.
  void fail(Error error) {
    if (!error_) error_ = std::move(error);
  }

  void complain(std::string what, std::string fix) { complain(std::move(what), std::move(fix), file_); }

  [[nodiscard]] const std::optional<Error>& error() const noexcept { return error_; }

 private:
  void complain(std::string what, std::string fix, std::string where) {
    if (!error_) error_ = Error{.what = std::move(what), .where = std::move(where), .fix = std::move(fix)};
  }
  static std::string text(double value) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%g", value);
    return buffer;
  }

  std::string file_;
  program::NumberPlaces places_;
  std::optional<Error> error_;
};

}  // namespace telepalp::scenes
