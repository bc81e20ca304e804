#include "tools/study/protocol/desk.h"

#include <utility>

#include "proto/words/numbers/fixed_text.h"
#include "tools/study/protocol/hands/browser_trial.h"
#include "tools/study/protocol/page_answers.h"

namespace telepalp::study {
namespace {

constexpr double kLeaveStep_s = 0.05;

std::string beginning(const Session& session) {
  const Planned& planned = session.planned();
  return "penetration " + std::to_string(session.done() + 1) + " of " + std::to_string(session.all()) +
         (planned.training ? ", training" : "") + ", condition " + std::string(name(planned.condition)) +
         ", mechanism " + std::to_string(planned.configuration + 1) + " of the design";
}

std::string ending(const Attempt& attempt) {
  const Outcome& out = attempt.trial.outcome;
  if (attempt.kind == AttemptKind::BrokenOff) return "broken off";
  if (!out.through) return "the sac was not punctured";
  return "overshoot " + fixed_text(1e3 * out.overshoot_m) + " mm" + (out.stopped ? "" : ", the tip has not stopped");
}

}  // namespace

HandOver browser_hand() {
  return [](Prepared prepared, Condition condition) {
    return std::make_unique<BrowserTrial>(std::move(prepared), condition);
  };
}

void Desk::write(const Attempt& attempt) {
  if (place_.file) place_.file->end(ending(attempt), participant_);
  if (const Result<void> written = journal_.add(attempt); !written) failed_ = written.error();
  if (failed_ || session_.stage() == Stage::Finished) over_();
}

void Desk::finish_trial() {
  const TrialView view = trial_->view();
  trial_.reset();
  write(session_.ended(view.outcome, view.held_up_s));
}

bool Desk::begin(SessionTime now) {
  if (failed_) return false;
  const std::string what = beginning(session_);
  const Condition condition = session_.planned().condition;
  std::optional<Prepared> prepared = session_.begin();
  if (!prepared) return false;
  if (place_.file) place_.file->begin(what, now);
  lost_.reset();
  condition_ = condition;
  trial_ = place_.hand(std::move(*prepared), condition);
  return true;
}

void Desk::break_off() {
  const TrialView view = trial_->view();
  trial_.reset();
  if (const std::optional<Attempt> attempt = session_.broken_off(view.outcome, view.held_up_s)) write(*attempt);
}

/// After the puncture, Escape changes nothing: the tip comes to rest.
bool Desk::let_go() {
  if (!trial_ || trial_->view().outcome.through) return false;
  break_off();
  return true;
}

void Desk::push(const std::function<void(PersonTrial&)>& by) {
  if (!trial_) return;
  by(*trial_);
  if (trial_->view().moved) session_.hand_moved();
}

bool Desk::obey(const PageCommand& command, SessionTime now) {
  const Stage before = session_.stage();
  if (std::holds_alternative<BeginPenetration>(command)) return begin(now);
  if (std::holds_alternative<LetGo>(command)) return let_go();
  if (const auto* const asked = std::get_if<PushHand>(&command))
    push([asked](PersonTrial& trial) { trial.push(asked->by_m); });
  if (const auto* const asked = std::get_if<MoveHand>(&command))
    push([asked](PersonTrial& trial) { trial.move(asked->by_m); });
  return session_.stage() != before;
}

void Desk::advance(double seconds) {
  trial_->step(seconds, ticks_);
  if (place_.file) place_.file->add(ticks_);
  ticks_.clear();
}

bool Desk::step(double seconds) {
  if (!trial_ || !moves()) return false;
  const Stage before = session_.stage();
  advance(seconds);
  if (trial_->view().moved) session_.hand_moved();
  if (trial_->view().over) {
    finish_trial();
  } else if (const std::optional<Error> lost = trial_->lost()) {
    lost_ = lost;
    break_off();
  }
  return session_.stage() != before;
}

void Desk::leave() {
  if (!trial_ || let_go()) return;
  if (trial_->moves_by_itself()) return break_off();
  while (!trial_->view().over) advance(kLeaveStep_s);
  finish_trial();
}

Result<void> Desk::close() {
  if (!place_.file) return {};
  return place_.file->close();
}

std::string Desk::state() const { return state_json(session_, participant_); }

std::optional<std::string> Desk::frame() const {
  return trial_ ? std::optional(trial_frame_json(trial_->view(), condition_)) : std::nullopt;
}

}  // namespace telepalp::study
