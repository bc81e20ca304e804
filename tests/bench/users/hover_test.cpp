#include <gtest/gtest.h>

#include "tests/bench/users/hover_rows.h"

namespace telepalp::bench {
namespace {

TEST(Hover, APointerThatSweepsOverThePatientNeverPushesTheDeviceIn) {
  const Result<std::vector<Row>> rows = hover_rows();
  ASSERT_TRUE(rows) << to_string(rows.error());
  for (const Row& row : *rows) EXPECT_TRUE(row.holds()) << row.name << ": " << row.value << " " << row.unit;
}

}  // namespace
}  // namespace telepalp::bench
