// The surface's hard cases, with requirement and result. The printed table is the product:
//   surface_hard_cases_test | grep '^|'

#include "tests/hard_cases/surface/rows.h"

namespace telepalp::hard_cases {
namespace {

std::vector<HardCase> all_rows() {
  std::vector<HardCase> all;
  for (const auto& rows : {point_rows(), image_rows(), shape_rows(), slope_rows(), time_rows(), prediction_rows(),
                           return_rows(), follow_rows(), model_rows(), object_rows(), sensor_rows()})
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

class SurfaceHardCases : public HardCaseTable {};

TEST_P(SurfaceHardCases, MeetsItsRequirement) { judge(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Table, SurfaceHardCases, ::testing::ValuesIn(all_rows()), name_of);

}  // namespace
}  // namespace telepalp::hard_cases
