#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "tools/study/search/judgement.h"
#include "tools/study/search/search_box.h"

namespace telepalp::study {

/// Keeps judgements longer than a search lasts. A search that was stopped resumes, because it asks for the same
/// mechanisms in the same order and finds their judgements here.
class JudgementStore {
 public:
  virtual ~JudgementStore() = default;
  /// The judgement of `mechanism` that was kept; nullopt: there is none. `held_out`: true for the judgement by the
  /// operators who take no part in the search.
  [[nodiscard]] virtual std::optional<Judgement> find(bool held_out, const Configuration& mechanism) = 0;
  virtual void keep(bool held_out, const Configuration& mechanism, const Judgement& judgement) = 0;
};

struct SearchSettings {
  int operators = 12;    ///< who judge each mechanism during the search
  int penetrations = 3;  ///< of each mechanism by each operator
  int held_out = 36;     ///< other operators, who judge the front after the search
  std::uint64_t seed = 1;
  int evaluations = 300;            ///< mechanisms that are judged in the search, S4's 36 included
  int threads = 1;                  ///< does not change the result
  JudgementStore* store = nullptr;  ///< borrowed; may be null
};

struct SearchedDesign {
  Configuration mechanism;            ///< its name tells where it is from: "linkage 2, ..." of S4, or "search 217"
  Judgement searched;                 ///< by the search's own operators: optimistic, because it is the best of many
  std::optional<Judgement> held_out;  ///< by operators who took no part in the search
};

/// How far a search is. The references hold during the call alone.
struct SearchState {
  bool held_out = false;  ///< false: mechanisms are searched; true: the front is judged again by other operators
  int done = 0;           ///< mechanisms judged in this stage; 0: its operators are being made, which takes seconds
  int total = 0;          ///< mechanisms of this stage; known when it begins
  const std::optional<SearchedDesign>& best;  ///< feasible, with the least overshoot so far
  const std::vector<SearchedDesign>& front;   ///< as SearchResult::front, so far
};
/// Called before the first mechanism of each stage, and after each mechanism, from the thread that called
/// search_designs().
using SearchProgress = std::function<void(const SearchState&)>;

struct SearchResult {
  std::vector<SearchedDesign> paper;     ///< S4's 36, in the order of Table 1
  std::vector<SearchedDesign> searched;  ///< all others, in the order in which they were judged
  /// For each bound on the hand's force, the mechanism with the least overshoot within it; no other judged mechanism is
  /// better in both. From the least force to the least overshoot. Empty: no mechanism was feasible.
  std::vector<SearchedDesign> front;
  std::optional<SearchedDesign> paper_best;    ///< of the 36, the least overshoot here
  std::optional<SearchedDesign> table_2_best;  ///< of the 36, the least overshoot in S4's Table 2
  /// Overshoot of the front's last mechanism minus that of `paper_best`, paired by held-out operator [mm].
  std::optional<Interval> gain_mm;
  bool stopped = false;  ///< the stop token ended the search early
};

/// Searches `box` for the least mean overshoot and the least mean of the largest hand force, then for the least
/// overshoot within each of several bounds on that force (epsilon-constraint). Blocks. The same box, settings and
/// program give the same result. A stop ends it after the mechanism that is being judged. Error: the box or a number
/// cannot be used.
[[nodiscard]] Result<SearchResult> search_designs(const SearchBox& box, const SearchSettings& settings,
                                                  const SearchProgress& progress, std::stop_token stop = {});

}  // namespace telepalp::study
