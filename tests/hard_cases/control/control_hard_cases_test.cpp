// The encountered controller's hard cases, with requirement and result. The printed table is the product:
//   control_hard_cases_test | grep '^|'

#include "tests/hard_cases/control/rows.h"

namespace telepalp::hard_cases {
namespace {

std::vector<HardCase> all_rows() {
  std::vector<HardCase> all;
  for (const auto& rows : {contact_rows(), surface_rows(), hand_rows(), clock_rows(), device_rows(), moving_skin_rows(),
                           inner_rows(), needle_rows(), body_rows(), indexing_rows()})
    all.insert(all.end(), rows.begin(), rows.end());
  return all;
}

class ControlHardCases : public HardCaseTable {};

TEST_P(ControlHardCases, MeetsItsRequirement) { judge(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Table, ControlHardCases, ::testing::ValuesIn(all_rows()), name_of);

}  // namespace
}  // namespace telepalp::hard_cases
