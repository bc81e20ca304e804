#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <initializer_list>
#include <string>

namespace telepalp::hard_cases {

/// A statement about the result, and whether it holds.
struct Claim {
  bool holds = false;
  std::string got;
};

/// "on the surface (4.2 um)": a figure in SI units, shown times `shown` in `unit`.
inline Claim figure(const char* what, bool holds, double value, double shown, const char* unit) {
  char text[160];
  std::snprintf(text, sizeof text, "%s (%.2g%s%s)", what, shown * value, *unit == '\0' ? "" : " ", unit);
  return {holds, text};
}
inline Claim below(const char* what, double value, double limit, double shown, const char* unit) {
  return figure(what, value < limit, value, shown, unit);
}
inline Claim above(const char* what, double value, double limit, double shown, const char* unit) {
  return figure(what, value > limit, value, shown, unit);
}
inline Claim below_N(const char* what, double value_N, double limit_N) {
  return below(what, value_N, limit_N, 1.0, "N");
}
inline Claim below_m(const char* what, double value_m, double limit_m) {
  return below(what, value_m, limit_m, 1e6, "um");
}
inline Claim below_mJ(const char* what, double value_J, double limit_mJ) {
  return below(what, value_J, 1e-3 * limit_mJ, 1e3, "mJ");
}

/// The message of a success lists all claims; that of a failure lists the claims that do not hold.
inline ::testing::AssertionResult all_of(std::initializer_list<Claim> claims) {
  std::string got;
  for (const Claim& claim : claims) {
    if (!claim.holds) return ::testing::AssertionFailure() << "NOT " << claim.got;
    got += (got.empty() ? "" : "; ") + claim.got;
  }
  return ::testing::AssertionSuccess() << got;
}

}  // namespace telepalp::hard_cases
