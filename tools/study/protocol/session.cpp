#include "tools/study/protocol/session.h"

#include "proto/words/demand.h"

namespace telepalp::study {

Result<Session> Session::make(const Protocol& protocol, const Participant& participant,
                              const std::vector<Attempt>& attempts, const std::string& file) {
  const Result<Plant> plant = plant_for(protocol, participant);
  if (!plant) return plant.error();
  std::vector<Planned> plan = plan_of(protocol, participant);
  const Result<std::size_t> done = done_of(plan, attempts, file);
  if (!done) return done.error();
  auto tissue = tissue::make_tissue(tissue_of(*plant));
  if (!tissue) return tissue.error();
  return Session(protocol, *plant, std::move(*tissue), std::move(plan), *done);
}

Session::Session(Protocol protocol, Plant plant, std::shared_ptr<const tissue::TissueModel> tissue,
                 std::vector<Planned> plan, std::size_t done)
    : protocol_(std::move(protocol)),
      plant_(plant),
      tissue_(std::move(tissue)),
      plan_(std::move(plan)),
      done_(done),
      stage_(done_ == plan_.size() ? Stage::Finished : Stage::Resting) {}

std::optional<Prepared> Session::begin() {
  if (stage_ != Stage::Resting) return std::nullopt;
  Result<std::unique_ptr<HeldTool>> tool =
      linkage_tool(protocol_.design.configurations[planned().configuration], plant_);
  demand(tool.ok(), "plant_for() has checked each mechanism on this plant");
  Prepared prepared{.tool = std::move(*tool), .insertion = nullptr};
  prepared.insertion = std::make_unique<Insertion>(*prepared.tool, tissue_);
  stage_ = next(stage_, StageEvent::Begun);
  return prepared;
}

Attempt Session::attempt(AttemptKind kind, const Outcome& outcome, double held_up_s) const {
  const Planned& now = planned();
  return {.kind = kind,
          .trial = {.person = 0,
                    .condition = now.condition,
                    .place = now.place,
                    .configuration = now.configuration,
                    .penetration = now.penetration,
                    .outcome = outcome},
          .held_up_s = held_up_s};
}

Attempt Session::ended(const Outcome& outcome, double held_up_s) {
  last_ = attempt(planned().training ? AttemptKind::Training : AttemptKind::Formal, outcome, held_up_s);
  ++done_;
  stage_ = next(stage_, done_ == plan_.size() ? StageEvent::LastOver : StageEvent::Over);
  return *last_;
}

std::optional<Attempt> Session::broken_off(const Outcome& outcome, double held_up_s) {
  const bool begun = stage_ == Stage::Inserting;
  if (next(stage_, StageEvent::BrokenOff) == stage_) return std::nullopt;
  stage_ = next(stage_, StageEvent::BrokenOff);
  if (!begun) return std::nullopt;  // the hand has not moved: nothing happened
  last_ = attempt(AttemptKind::BrokenOff, outcome, held_up_s);
  return last_;
}

}  // namespace telepalp::study
