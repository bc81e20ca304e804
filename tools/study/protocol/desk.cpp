#include "tools/study/protocol/desk.h"

#include <utility>

#include "tools/study/protocol/page_answers.h"

namespace telepalp::study {

void Desk::write(const Attempt& attempt) {
  if (const Result<void> written = journal_.add(attempt); !written) failed_ = written.error();
  if (failed_ || session_.stage() == Stage::Finished) over_();
}

void Desk::finish_trial() {
  const Attempt attempt = session_.ended(trial_->insertion().outcome(), trial_->held_up_s());
  trial_.reset();
  write(attempt);
}

bool Desk::begin() {
  if (failed_) return false;
  const Condition condition = session_.planned().condition;
  std::optional<Prepared> prepared = session_.begin();
  if (!prepared) return false;
  trial_.emplace(std::move(*prepared), condition);
  return true;
}

/// After the puncture, Escape changes nothing: the hand stands still, and the tip comes to rest.
bool Desk::let_go() {
  if (!trial_ || trial_->insertion().through()) return false;
  const std::optional<Attempt> attempt = session_.broken_off(trial_->insertion().outcome(), trial_->held_up_s());
  trial_.reset();
  if (attempt) write(*attempt);
  return true;
}

void Desk::push(const std::function<void(BrowserTrial&)>& by) {
  if (!trial_) return;
  by(*trial_);
  session_.hand_moved();
}

bool Desk::obey(const PageCommand& command) {
  const Stage before = session_.stage();
  if (std::holds_alternative<BeginPenetration>(command)) return begin();
  if (std::holds_alternative<LetGo>(command)) return let_go();
  if (const auto* const asked = std::get_if<PushHand>(&command))
    push([asked](BrowserTrial& trial) { trial.push(asked->by_m); });
  if (const auto* const asked = std::get_if<MoveHand>(&command))
    push([asked](BrowserTrial& trial) { trial.move(asked->by_m); });
  return session_.stage() != before;
}

bool Desk::step(double seconds) {
  if (!trial_ || !moves()) return false;
  trial_->step(seconds);
  if (!trial_->insertion().over()) return false;
  finish_trial();
  return true;
}

void Desk::leave() {
  if (!trial_ || let_go()) return;
  while (!trial_->insertion().over()) trial_->step(BrowserTrial::kLongestStep_s);
  finish_trial();
}

std::string Desk::state() const { return state_json(session_, participant_); }

std::optional<std::string> Desk::frame() const {
  return trial_ ? std::optional(trial_frame_json(*trial_)) : std::nullopt;
}

}  // namespace telepalp::study
