#include "tools/study/search/design_search.h"

#include <algorithm>
#include <cmath>

#include "tools/study/figures/paper_table.h"
#include "tools/study/search/front_search.h"

namespace telepalp::study {
namespace {

constexpr std::size_t kFirstHeldOut = 10'000;  // number of the first operator who takes no part in the search
constexpr int kBounds = 5;                     // on the hand's force, between the two single optima
constexpr std::uint64_t kGainSeed = 2;

Result<void> check_numbers(const SearchSettings& settings) {
  const bool good = settings.operators >= 1 && settings.operators <= 1000 && settings.held_out >= 1 &&
                    settings.held_out <= 1000 && settings.penetrations >= 1 && settings.penetrations <= 50 &&
                    settings.evaluations >= kLeastEvaluations && settings.evaluations <= 100'000;
  if (good) return {};
  return Error{.what = "a number of the search is out of bounds",
               .where = "the search",
               .fix = "give 1 to 1000 operators, 1 to 50 penetrations and 40 to 100000 evaluations"};
}

std::optional<Score> score_of(const Judgement& judgement) {
  if (!judgement.feasible()) return std::nullopt;
  return Score{judgement.overshoot_mm.mean, judgement.hand_N.mean};
}

/// One search: judges mechanisms, and tells the progress.
class Search {
 public:
  Search(const SearchBox& box, const SearchSettings& settings, const SearchProgress& progress, std::stop_token stop)
      : box_(box), settings_(settings), progress_(progress), stop_(std::move(stop)) {}

  /// S4's mechanisms that lie in the box are starts of the search; the others are judged for the comparison alone.
  [[nodiscard]] Result<SearchResult> run() {
    tell(0);
    const Result<Panel> panel = Panel::of(settings_.seed, 0, settings_.operators, settings_.threads);
    if (!panel) return panel.error();
    judge_paper(*panel);
    search(*panel);
    result_.front = front();
    name_paper_best();
    if (!stop_.stop_requested()) {
      tell_again(0);
      const Result<Panel> others = Panel::of(settings_.seed, kFirstHeldOut, settings_.held_out, settings_.threads);
      if (!others) return others.error();
      judge_again(*others);
    }
    result_.stopped = stop_.stop_requested();
    return std::move(result_);
  }

 private:
  [[nodiscard]] Judgement judge(const Panel& panel, bool held_out, const Configuration& mechanism) const {
    if (settings_.store != nullptr)
      if (std::optional<Judgement> kept = settings_.store->find(held_out, mechanism)) return std::move(*kept);
    Judgement judgement = panel.judge(mechanism, settings_.penetrations, settings_.threads);
    if (settings_.store != nullptr) settings_.store->keep(held_out, mechanism, judgement);
    return judgement;
  }

  void judge_paper(const Panel& panel) {
    for (const Configuration& mechanism : amniocentesis_design().configurations) {
      if (stop_.stop_requested()) return;
      result_.paper.push_back({mechanism, judge(panel, false, mechanism), std::nullopt});
      add(result_.paper.back(), place_in(box_, mechanism).has_value());
    }
  }

  void search(const Panel& panel) {
    FrontSettings front{.dimensions = free_ranges(box_).size(),
                        .evaluations = settings_.evaluations - static_cast<int>(result_.paper.size()),
                        .bounds = kBounds,
                        .seed = settings_.seed,
                        .starts = {}};
    std::vector<std::vector<double>> places;  // of S4's mechanisms, which are judged already
    std::vector<std::optional<Score>> scores;
    for (const SearchedDesign& one : result_.paper)
      if (std::optional<std::vector<double>> place = place_in(box_, one.mechanism)) {
        front.starts.push_back(*place);
        scores.push_back(score_of(one.searched));
      }
    front.evaluations += static_cast<int>(front.starts.size());
    std::size_t next_start = 0;
    (void)search_front(
        front,
        [&](const std::vector<double>& at) {
          if (next_start < scores.size()) return scores[next_start++];
          return judge_at(panel, at);
        },
        stop_);
  }

  std::optional<Score> judge_at(const Panel& panel, const std::vector<double>& at) {
    Configuration mechanism = mechanism_at(box_, at);
    mechanism.name = "search " + std::to_string(result_.searched.size() + 1);
    Judgement judgement = judge(panel, false, mechanism);
    result_.searched.push_back({std::move(mechanism), std::move(judgement), std::nullopt});
    add(result_.searched.back(), true);
    return score_of(result_.searched.back().searched);
  }

  /// All mechanisms in the box that were judged.
  [[nodiscard]] std::vector<const SearchedDesign*> candidates() const {
    std::vector<const SearchedDesign*> all;
    for (const SearchedDesign& one : result_.paper)
      if (place_in(box_, one.mechanism)) all.push_back(&one);
    for (const SearchedDesign& one : result_.searched) all.push_back(&one);
    return all;
  }

  [[nodiscard]] std::vector<SearchedDesign> front() const {
    const std::vector<const SearchedDesign*> all = candidates();
    std::vector<std::optional<Score>> scores;
    for (const SearchedDesign* one : all) scores.push_back(score_of(one->searched));
    std::vector<SearchedDesign> front;
    for (const std::size_t i : front_of(scores, kBounds)) front.push_back(*all[i]);
    return front;
  }

  void name_paper_best() {
    if (result_.paper.size() != paper_table().size()) return;  // stopped
    for (const SearchedDesign& one : result_.paper)
      if (one.searched.feasible() &&
          (!result_.paper_best || one.searched.overshoot_mm.mean < result_.paper_best->searched.overshoot_mm.mean))
        result_.paper_best = one;
    const std::vector<double> table = paper_overshoots_mm();
    result_.table_2_best =
        result_.paper[static_cast<std::size_t>(std::min_element(table.begin(), table.end()) - table.begin())];
  }

  [[nodiscard]] std::vector<SearchedDesign*> to_be_judged_again() {
    std::vector<SearchedDesign*> again;
    for (SearchedDesign& one : result_.front) again.push_back(&one);
    for (std::optional<SearchedDesign>* one : {&result_.paper_best, &result_.table_2_best})
      if (*one) again.push_back(&**one);
    return again;
  }

  void judge_again(const Panel& others) {
    int done = 0;
    for (SearchedDesign* one : to_be_judged_again()) {
      if (stop_.stop_requested()) return;
      one->held_out = judge(others, true, one->mechanism);
      tell_again(++done);
    }
    if (!result_.front.empty() && result_.paper_best) result_.gain_mm = gain(result_.front.back(), *result_.paper_best);
  }

  /// Paired by operator; an operator who failed with one of the two is left out.
  static std::optional<Interval> gain(const SearchedDesign& one, const SearchedDesign& other) {
    if (!one.held_out || !other.held_out || !one.held_out->refused.empty() || !other.held_out->refused.empty())
      return std::nullopt;
    std::vector<double> differences;
    for (std::size_t i = 0; i < one.held_out->overshoots_mm.size(); ++i) {
      const double difference = one.held_out->overshoots_mm[i] - other.held_out->overshoots_mm[i];
      if (std::isfinite(difference)) differences.push_back(difference);
    }
    if (differences.empty()) return std::nullopt;
    return bootstrap(differences, kGainSeed);
  }

  void add(const SearchedDesign& judged, bool in_box) {
    const bool feasible = in_box && judged.searched.feasible();
    if (feasible && (!best_ || judged.searched.overshoot_mm.mean < best_->searched.overshoot_mm.mean)) best_ = judged;
    if (feasible) front_ = front();
    tell(static_cast<int>(result_.paper.size() + result_.searched.size()));
  }

  void tell(int done) const {
    progress_({.held_out = false, .done = done, .total = settings_.evaluations, .best = best_, .front = front_});
  }

  void tell_again(int done) {
    const int total = static_cast<int>(to_be_judged_again().size());
    progress_({.held_out = true, .done = done, .total = total, .best = best_, .front = result_.front});
  }

  const SearchBox& box_;
  const SearchSettings& settings_;
  const SearchProgress& progress_;
  std::stop_token stop_;
  SearchResult result_;
  std::optional<SearchedDesign> best_;
  std::vector<SearchedDesign> front_;
};

}  // namespace

Result<SearchResult> search_designs(const SearchBox& box, const SearchSettings& settings,
                                    const SearchProgress& progress, std::stop_token stop) {
  const Result<SearchBox> good = checked(box);
  if (!good) return good.error();
  if (const Result<void> numbers = check_numbers(settings); !numbers) return numbers.error();
  return Search(
             *good, settings, progress ? progress : [](const SearchState&) {}, std::move(stop))
      .run();
}

}  // namespace telepalp::study
