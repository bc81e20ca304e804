#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "proto/words/time.h"
#include "server/plan/grade.h"
#include "server/plan/line_budget.h"
#include "server/plan/rungs.h"
#include "server/plan/sacrifice.h"

namespace telepalp::plan {

/// What is coded, and which subscriber gets which grade of it.
struct RatePlan {
  std::array<ImageSettings, kGrades.size()> settings{};  ///< by grade
  std::map<std::uint64_t, Grade> grades{};               ///< of subscribers that do not get Grade::Full
  Sacrifice sacrifice{};

  [[nodiscard]] Grade grade_of(std::uint64_t subscriber) const {
    const auto found = grades.find(subscriber);
    return found == grades.end() ? Grade::Full : found->second;
  }
  /// All stations get the same grade.
  [[nodiscard]] Grade grade_of_stations() const noexcept {
    return settings[index_of(Grade::Touch)] == ImageSettings{} ? Grade::Full : Grade::Touch;
  }
};

/// One subscriber, what it takes, and its line.
struct Line {
  enum class Kind : std::uint8_t {
    Hand,     ///< the station whose window of exact depth the server follows
    Station,  ///< another station, or one that takes whole depth images
    Viewer,
    Keeper,  ///< a recorder, or a program at the patient's site: it always gets Grade::Full
  };
  std::uint64_t subscriber = 0;
  Kind kind = Kind::Viewer;
  bool takes_window = false;
  bool takes_whole = false;
  bool takes_pictures = false;
  bool takes_video = false;
  LineReport report{};
};

/// Numbers and bytes of the images of one grade that were made.
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
  /// link::ContentLevel::level(), chosen from the lines of stations that take whole depth images.
  std::size_t whole_level = 0;
};

/// Decides what is given up for lines that have no room for everything, in the orders of touch_rungs() and
/// view_rungs(). The hand comes before viewers: while its line is too thin, viewers lose colour even if their own lines
/// have room. Otherwise, viewers whose lines have room keep everything. All viewers on thin lines get the same images,
/// which fit the thinnest of these lines. The plan changes to fewer bytes at once, and to more only after a line has
/// had room for a while (LineBudget). Whole depth images for stations are not its decision: it passes
/// PlanInput::whole_level on. Pure. Owner: the server's network thread.
class RatePlanner {
 public:
  RatePlanner();

  /// The plan from `now` on. Call it about five times a second.
  [[nodiscard]] const RatePlan& step(const PlanInput& input, SessionTime now);
  [[nodiscard]] const RatePlan& plan() const noexcept { return plan_; }

 private:
  void learn(const PlanInput& input, SessionTime now);
  void keep_budgets(const PlanInput& input, SessionTime now);
  [[nodiscard]] std::optional<double> least_budget_B_per_s(const PlanInput& input, Line::Kind kind) const;
  [[nodiscard]] ImageSettings touch_settings(std::size_t rung, const Line& hand, const Taken& taken,
                                             int video_before_kbit_per_s) const;
  void plan_touch(const PlanInput& input, SessionTime now);
  void plan_view(const PlanInput& input, SessionTime now);

  std::map<std::uint64_t, LineBudget> budgets_;  // of the hand and of viewers, by subscriber
  RungBytes touch_;
  RungBytes view_;
  SessionTime touch_changed_{};  // when the rung of touch_rungs() last changed
  SessionTime view_changed_{};
  SessionTime enough_at_{};  // when the hand's line was last not too thin
  RatePlan plan_;
};

}  // namespace telepalp::plan
