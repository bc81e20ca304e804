#pragma once

#include <gtest/gtest.h>

#include <cctype>
#include <cstdio>
#include <ostream>
#include <string>

namespace telepalp::hard_cases {

/// A row of a table of hard cases.
struct HardCase {
  const char* row;
  const char* hard_because;
  const char* must;
  ::testing::AssertionResult (*check)();
};

inline std::ostream& operator<<(std::ostream& out, const HardCase& one) { return out << one.row; }

/// The row as a test's name.
inline std::string name_of(const ::testing::TestParamInfo<HardCase>& one) {
  std::string name = one.param.row;
  for (char& letter : name)
    if (std::isalnum(static_cast<unsigned char>(letter)) == 0) letter = '_';
  return name;
}

/// Checks rows and prints them as a table; grep '^|' separates it from the test runner's output.
class HardCaseTable : public ::testing::TestWithParam<HardCase> {
 protected:
  static void SetUpTestSuite() { std::puts("| row | why | must | got |\n| --- | --- | --- | --- |"); }
  static void judge(const HardCase& hard) {
    const ::testing::AssertionResult result = hard.check();
    EXPECT_TRUE(result) << hard.row << " must: " << hard.must;
    std::printf("| %-35s | %-44s | %-46s | %s |\n", hard.row, hard.hard_because, hard.must, result.message());
  }
};

}  // namespace telepalp::hard_cases
