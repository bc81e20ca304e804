#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "proto/words/frames.h"
#include "proto/words/result.h"
#include "support/program/text_format.h"

namespace telepalp::scenes {

/// Allowed range of a number. `unit` only appears in messages.
struct Range {
  double least;
  double most;
  std::string_view unit;
};

/// Checks the numbers of a message field by field and keeps the first error.
class FieldCheck {
 public:
  explicit FieldCheck(std::string file, program::NumberPlaces places = program::NumberPlaces())
      : file_(std::move(file)), places_(std::move(places)) {}

  /// Assigns `value` to `into` when it is within `range`; otherwise records an error about `field`.
  void number(std::string_view field, double value, const Range& range, double& into) {
    if (std::isfinite(value) && value >= range.least && value <= range.most) {
      into = value;
      return;
    }
    complain(std::string(field) + " is " + text(value) + " " + std::string(range.unit) + ", outside " +
                 text(range.least) + " to " + text(range.most) + " " + std::string(range.unit),
             "give " + std::string(field) + " in " + std::string(range.unit) + " from " + text(range.least) + " to " +
                 text(range.most),
             places_.where(file_, field, value));
  }

  /// Records an error that arose elsewhere, for example while reading a file that a field names.
  void fail(Error error) {
    if (!error_) error_ = std::move(error);
  }

  void complain(std::string what, std::string fix) { complain(std::move(what), std::move(fix), file_); }

  [[nodiscard]] const std::optional<Error>& error() const noexcept { return error_; }
  [[nodiscard]] const std::string& file() const noexcept { return file_; }
  [[nodiscard]] const program::NumberPlaces& places() const noexcept { return places_; }

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
