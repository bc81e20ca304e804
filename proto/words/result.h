#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "proto/words/demand.h"

namespace telepalp {

/// A failure caused by the outside world, described for the person who must fix it.
struct Error {
  std::string what;   ///< what happened
  std::string where;  ///< file, line, address or function where it happened
  std::string fix;    ///< how to fix it
};

/// An error that has no place, such as a refused key.
[[nodiscard]] inline Error error_without_place(std::string what, std::string fix) {
  return {.what = std::move(what), .where = {}, .fix = std::move(fix)};
}

/// One line for stderr: `where: what. fix: fix`.
[[nodiscard]] inline std::string to_string(const Error& error) {
  std::string line = error.where.empty() ? error.what : error.where + ": " + error.what;
  if (!error.fix.empty()) line += ". fix: " + error.fix;
  return line;
}

/// A value or an error. Calling value() on an error or error() on a value aborts: it is a bug of the caller.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : outcome_(std::in_place_index<0>, std::move(value)) {}      // NOLINT: implicit by design
  Result(Error error) : outcome_(std::in_place_index<1>, std::move(error)) {}  // NOLINT: implicit by design

  [[nodiscard]] bool ok() const noexcept { return outcome_.index() == 0; }
  explicit operator bool() const noexcept { return ok(); }

  [[nodiscard]] const T& value() const& {
    demand(ok(), "Result::value() is called on a value, not on an error");
    return *std::get_if<0>(&outcome_);
  }
  [[nodiscard]] T& value() & {
    demand(ok(), "Result::value() is called on a value, not on an error");
    return *std::get_if<0>(&outcome_);
  }
  [[nodiscard]] T&& value() && {
    demand(ok(), "Result::value() is called on a value, not on an error");
    return std::move(*std::get_if<0>(&outcome_));
  }
  [[nodiscard]] const Error& error() const {
    demand(!ok(), "Result::error() is called on an error, not on a value");
    return *std::get_if<1>(&outcome_);
  }

  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

 private:
  std::variant<T, Error> outcome_;
};

/// Success without a value, or an error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}  // NOLINT: implicit by design

  [[nodiscard]] bool ok() const noexcept { return !error_.has_value(); }
  explicit operator bool() const noexcept { return ok(); }
  [[nodiscard]] const Error& error() const {
    demand(!ok(), "Result::error() is called on an error, not on a value");
    return *error_;
  }

 private:
  std::optional<Error> error_;
};

}  // namespace telepalp
