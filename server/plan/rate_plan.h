#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "proto/words/time.h"
#include "server/plan/grade.h"
#include "server/plan/line_budget.h"
#include "server/plan/rungs.h"

namespace telepalp::plan {

/// What is coded, and what each subscriber gets of it.
struct RatePlan {
  std::array<ImageSettings, kGrades.size()> settings{};  ///< by grade
  std::map<std::uint64_t, Grade> grades{};               ///< of subscribers that do not get Grade::Full
  /// For people: what was given up, for which rate, and why; empty: nothing was.
  std::string said{};
  bool too_thin_to_touch = false;

  [[nodiscard]] Grade grade_of(std::uint64_t subscriber) const {
    const auto found = grades.find(subscriber);
    return found == grades.end() ? Grade::Full : found->second;
  }
};

/// One subscriber, what it takes, and its line.
struct Line {
  enum class Kind : std::uint8_t {
    Hand,     ///< the station whose window of exact depth the server follows
    Station,  ///< another station, or one that takes whole depth images
    Viewer,
    Keeper,  ///< a recorder, or a program at the patient's site: it gets everything as it is
  };
  std::uint64_t subscriber = 0;
  Kind kind = Kind::Viewer;
  bool takes_window = false;
  bool takes_whole = false;
  bool takes_pictures = false;
  bool takes_video = false;
  LineReport report{};
};

/// Bytes of the images of one grade that were made.
struct Made {
  struct Count {
    std::uint64_t images = 0;
    std::uint64_t bytes = 0;
  };
  Count window;    ///< depth with a window
  Count whole;     ///< whole depth images
  Count pictures;  ///< colour as JPEG
};

struct PlanInput {
  std::vector<Line> lines{};
  std::array<Made, kGrades.size()> made{};  ///< by grade, since the last step
  double images_per_s = 30.0;               ///< of the camera
  /// What link::ContentLevel chose for stations with whole depth images, which cannot do with less exact depth.
  std::size_t whole_level = 0;
};

/// Decides what is given up for lines that have no room for everything. The orders of sacrifice are touch_rungs() and
/// view_rungs(). The hand comes before viewers: while a station's line is too thin, viewers' colour is given up first.
/// Viewers with room keep what they have. All viewers on thin lines get the same images, which fit the thinnest line.
/// A plan changes to fewer bytes at once, and to more only when a line had room for a while (LineBudget). Pure; owner:
/// the server's network thread.
class RatePlanner {
 public:
  RatePlanner();

  /// The plan from `now` on. Call it about five times a second.
  [[nodiscard]] const RatePlan& step(const PlanInput& input, SessionTime now);
  [[nodiscard]] const RatePlan& plan() const noexcept { return plan_; }

 private:
  void learn(const PlanInput& input);
  void keep_budgets(const PlanInput& input, SessionTime now);
  [[nodiscard]] ImageSettings touch_settings(std::size_t rung, const Line& hand, const Taken& taken,
                                             int video_before_kbit_per_s);
  void plan_touch(const PlanInput& input, SessionTime now);
  void plan_view(const PlanInput& input, SessionTime now);
  void tell();

  std::map<std::uint64_t, LineBudget> budgets_;
  RungBytes touch_;
  RungBytes view_;
  std::size_t touch_rung_ = 0;
  std::size_t view_rung_ = 0;
  SessionTime touch_changed_{};
  SessionTime view_changed_{};
  SessionTime enough_at_{};  ///< when the hand's line was last not too thin
  SessionTime now_{};
  double images_per_s_ = 30.0;
  double hand_B_per_s_ = 0.0;                   ///< budget of the hand's line, if something is given up for it
  double viewer_B_per_s_ = 0.0;                 ///< the least of the viewers' budgets, if something is given up for it
  std::pair<std::size_t, std::size_t> said_{};  ///< the rungs that plan_.said tells
  SessionTime said_at_{};
  RatePlan plan_;
};

}  // namespace telepalp::plan
