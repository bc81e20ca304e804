#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "messages/scene.pb.h"
#include "proto/words/error_line.h"
#include "proto/words/frames.h"
#include "proto/words/result.h"
#include "proto/words/rotation_vector.h"
#include "support/program/text/text_format.h"

namespace telepalp::scenes {

/// Allowed range of a number, limits included. `unit` only appears in error texts.
struct Range {
  double least;
  double most;
  std::string_view unit;
};

/// Checks the numbers of a protobuf message field by field and keeps the first error.
class FieldCheck {
 public:
  explicit FieldCheck(std::string file, program::NumberPlaces places = program::NumberPlaces())
      : file_(std::move(file)), places_(std::move(places)) {}

  /// Sets the message to which the next calls of number() and complain() refer; errors state its place in the file.
  FieldCheck& in(const google::protobuf::Message& part) noexcept {
    part_ = &part;
    return *this;
  }

  /// Assigns `value` to `into` when it is within `range`; otherwise records an error about `field`.
  void number(std::string_view field, double value, const Range& range, double& into) {
    if (std::isfinite(value) && value >= range.least && value <= range.most) {
      into = value;
      return;
    }
    complain(std::string(field) + " is " + number_text(value) + " " + std::string(range.unit) + ", outside " +
                 number_text(range.least) + " to " + number_text(range.most) + " " + std::string(range.unit),
             "give " + std::string(field) + " in " + std::string(range.unit) + " from " + number_text(range.least) +
                 " to " + number_text(range.most),
             part_ == nullptr ? places_.where(file_, field, value) : places_.where(file_, *part_, field, value));
  }

  /// Records an error that arose elsewhere, for example while reading a file that a field names.
  void fail(Error error) {
    if (!error_) error_ = std::move(error);
  }

  /// Records an error about a file that the message names, at the message's place; the text keeps the file's place.
  void fail_in_file(const std::string& prefix, const Error& error) {
    complain(prefix + error.where + ": " + error.what, error.fix);
  }

  /// Records an error about the message that in() named.
  void complain(std::string what, std::string fix) { complain(std::move(what), std::move(fix), place()); }

  /// Adds a warning: a valid value that is hardly meant.
  void warn(std::string what, std::string fix, std::string where) {
    warnings_.push_back({.what = std::move(what), .where = std::move(where), .fix = std::move(fix)});
  }

  /// Place of the message that in() named; the file's name alone before the first in().
  [[nodiscard]] std::string place() const { return part_ == nullptr ? file_ : places_.where(file_, *part_); }

  [[nodiscard]] const std::optional<Error>& error() const noexcept { return error_; }
  [[nodiscard]] const std::vector<Error>& warnings() const noexcept { return warnings_; }
  [[nodiscard]] const std::string& file() const noexcept { return file_; }
  [[nodiscard]] const program::NumberPlaces& places() const noexcept { return places_; }

 private:
  void complain(std::string what, std::string fix, std::string where) {
    if (!error_) error_ = Error{.what = std::move(what), .where = std::move(where), .fix = std::move(fix)};
  }
  std::string file_;
  program::NumberPlaces places_;
  const google::protobuf::Message* part_ = nullptr;  // borrowed
  std::optional<Error> error_;
  std::vector<Error> warnings_;
};

/// Reads three numbers of one range; a number out of range is read as 0. `field`: their common name, for errors.
[[nodiscard]] inline Eigen::Vector3d read_xyz(FieldCheck& check, const std::string& field, const msg::Vec3& xyz,
                                              const Range& range) {
  Eigen::Vector3d out = Eigen::Vector3d::Zero();
  check.in(xyz);
  check.number(field + ".x", xyz.x(), range, out.x());
  check.number(field + ".y", xyz.y(), range, out.y());
  check.number(field + ".z", xyz.z(), range, out.z());
  return out;
}

[[nodiscard]] inline Eigen::Isometry3d read_transform(FieldCheck& check, const std::string& field,
                                                      const msg::RigidTransform& message) {
  const Eigen::Vector3d translation_m =
      read_xyz(check, field + ".translation_m", message.translation_m(), {-10, 10, "m"});
  const Eigen::Vector3d turn =
      read_xyz(check, field + ".rotation_vector_rad", message.rotation_vector_rad(), {-6.3, 6.3, "rad"});
  return isometry_of(turn, translation_m);
}

}  // namespace telepalp::scenes

/// Reads an optional number into `into`, which keeps its value if the field is missing. `...`: the Range in braces.
#define TELEPALP_READ(check, prefix, message, field, into, ...) \
  if ((message).has_##field())                                  \
  (check).in(message).number(prefix #field, (message).field(), ::telepalp::scenes::Range __VA_ARGS__, into)
