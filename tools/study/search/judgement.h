#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/study/figures/statistics.h"
#include "tools/study/run/study.h"

namespace telepalp::study {

/// What the operators of a search made of one mechanism, in the condition Both.
struct Judgement {
  std::string refused;                ///< why the linkage cannot be used on some operator's plant; empty: it can
  int failed = 0;                     ///< penetrations in which the sac stayed whole; they are in no mean
  int never = 0;                      ///< operators who never punctured the sac; they are in no mean
  double noticed_share = 0.0;         ///< share of the punctures that the operator noticed
  std::vector<double> overshoots_mm;  ///< mean of each operator, NaN for one who never punctured the sac
  std::vector<double> hands_N;        ///< as above: mean of the largest force of the needle on the hand
  Interval overshoot_mm;              ///< mean over the operators, with a bootstrap over them
  Interval hand_N;                    ///< as above

  /// Only such a mechanism can be on a front: each penetration punctured the sac.
  [[nodiscard]] bool feasible() const noexcept { return refused.empty() && failed == 0; }
};
/// Computes the means and intervals from the values of the operators.
void summarise(Judgement& judgement);

/// Simulated operators, each with an own body and plant, who try every mechanism with the same random numbers. So two
/// mechanisms differ by the mechanism alone (common random numbers).
class Panel {
 public:
  /// Operators `first` to `first` + `count` - 1 of the study with this seed. Each tissue takes about a second to make.
  /// Error: a tissue cannot be made.
  [[nodiscard]] static Result<Panel> of(std::uint64_t seed, std::size_t first, int count, int threads);

  /// Each operator begins as after training: knows the mean depth of the puncture on the own plant from five
  /// penetrations, and learns from each of `penetrations` more. The result does not depend on `threads`.
  [[nodiscard]] Judgement judge(const Configuration& mechanism, int penetrations, int threads) const;

 private:
  struct Member {
    std::size_t number = 0;
    Person person;
    std::shared_ptr<const tissue::TissueModel> tissue;
  };
  struct Tried;  ///< what one operator made of a mechanism
  [[nodiscard]] Tried try_out(const Member& member, const Configuration& mechanism, int penetrations) const;

  std::uint64_t seed_ = 1;
  std::vector<Member> members_;
};

}  // namespace telepalp::study
