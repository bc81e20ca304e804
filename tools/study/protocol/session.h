#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "tools/study/protocol/journal.h"

namespace telepalp::study {

/// Where a person is in the protocol.
enum class Stage {
  Resting,    ///< between two penetrations: a pause may be as long as one likes
  Ready,      ///< the needle waits above the skin for the first motion of the hand
  Inserting,  ///< time runs
  Finished,   ///< all penetrations are done
};
enum class StageEvent { Begun, HandMoved, BrokenOff, Over, LastOver };
struct StageRow {
  Stage from;
  StageEvent on;
  Stage to;
};
inline constexpr StageRow kStages[] = {
    {Stage::Resting, StageEvent::Begun, Stage::Ready},     {Stage::Ready, StageEvent::HandMoved, Stage::Inserting},
    {Stage::Ready, StageEvent::BrokenOff, Stage::Resting}, {Stage::Inserting, StageEvent::BrokenOff, Stage::Resting},
    {Stage::Inserting, StageEvent::Over, Stage::Resting},  {Stage::Inserting, StageEvent::LastOver, Stage::Finished},
};
/// A pair that is not listed changes nothing.
[[nodiscard]] constexpr Stage next(Stage stage, StageEvent event) noexcept {
  for (const StageRow& row : kStages)
    if (row.from == stage && row.on == event) return row.to;
  return stage;
}

/// The way of one participant through the plan. Pure. Owner: the network thread.
class Session {
 public:
  /// `attempts`: of the journal; the session goes on after them. Error: they are not those of the plan (`file`), a
  /// mechanism cannot be used, or the tissue cannot be made.
  [[nodiscard]] static Result<Session> make(const Protocol& protocol, const Participant& participant,
                                            const std::vector<Attempt>& attempts, const std::string& file);

  [[nodiscard]] Stage stage() const noexcept { return stage_; }
  [[nodiscard]] std::size_t done() const noexcept { return done_; }
  [[nodiscard]] std::size_t all() const noexcept { return plan_.size(); }
  /// The penetration that comes next, or is under way. The last one, if all are done.
  [[nodiscard]] const Planned& planned() const noexcept { return plan_[std::min(done_, plan_.size() - 1)]; }
  /// The newest attempt of this session, which is what the person is told; nullopt: none yet.
  [[nodiscard]] const std::optional<Attempt>& last() const noexcept { return last_; }
  [[nodiscard]] std::size_t mechanisms() const noexcept { return protocol_.design.configurations.size(); }
  [[nodiscard]] PersonHand hand() const noexcept { return protocol_.hand; }
  [[nodiscard]] const Plant& plant() const noexcept { return plant_; }

  /// The person wants to begin. nullopt: not at this stage.
  [[nodiscard]] std::optional<Prepared> begin();
  void hand_moved() noexcept { stage_ = next(stage_, StageEvent::HandMoved); }
  /// The insertion is over. Returns the row for the journal.
  [[nodiscard]] Attempt ended(const Outcome& outcome, double held_up_s);
  /// The person let go before the puncture: the penetration comes again. nullopt: nothing was under way.
  [[nodiscard]] std::optional<Attempt> broken_off(const Outcome& outcome, double held_up_s);

 private:
  Session(Protocol protocol, Plant plant, std::shared_ptr<const tissue::TissueModel> tissue, std::vector<Planned> plan,
          std::size_t done);
  [[nodiscard]] Attempt attempt(AttemptKind kind, const Outcome& outcome, double held_up_s) const;

  Protocol protocol_;
  Plant plant_;
  std::shared_ptr<const tissue::TissueModel> tissue_;
  std::vector<Planned> plan_;
  std::size_t done_ = 0;
  Stage stage_ = Stage::Resting;
  std::optional<Attempt> last_;
};

}  // namespace telepalp::study
