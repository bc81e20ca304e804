#pragma once

#include <functional>
#include <optional>
#include <string>

#include "tools/study/protocol/hands/person_trial.h"
#include "tools/study/protocol/page_command.h"
#include "tools/study/protocol/session.h"
#include "tools/study/protocol/sitting_file.h"

namespace telepalp::study {

/// Gives the hand of the participant a penetration.
using HandOver = std::function<std::unique_ptr<PersonTrial>(Prepared prepared, Condition condition)>;
/// The hand of a participant at a browser.
[[nodiscard]] HandOver browser_hand();

/// Where one participant works: how the hand moves, and where the sitting is kept.
struct Place {
  HandOver hand = browser_hand();
  std::optional<SittingFile> file = std::nullopt;  ///< nullopt: the sitting is not kept
};

/// One participant at work: the session, its journal, and the penetration that is under way. Every attempt that ends is
/// written to the journal at once. Owner: the network thread.
class Desk {
 public:
  /// `over`: called once, when the last penetration is done or the journal cannot be written.
  Desk(Session session, Journal journal, std::string participant, std::function<void()> over, Place place = {})
      : session_(std::move(session)),
        journal_(std::move(journal)),
        participant_(std::move(participant)),
        over_(std::move(over)),
        place_(std::move(place)) {}

  /// Does what the page asks, `now`; true: the state of the session has changed.
  bool obey(const PageCommand& command, SessionTime now = {});
  /// `seconds` of real time have passed; true: the state of the session has changed.
  bool step(double seconds);
  /// The person has gone: before the puncture the penetration is broken off; after it, a hand at a browser stands still
  /// until the tip has stopped, which counts.
  void leave();
  /// Completes the session file. Error: it could not be written.
  [[nodiscard]] Result<void> close();

  [[nodiscard]] std::string state() const;
  /// What is shown of the penetration that is under way; nullopt: none is.
  [[nodiscard]] std::optional<std::string> frame() const;
  /// False: nothing moves.
  [[nodiscard]] bool moves() const noexcept {
    return session_.stage() == Stage::Inserting || (trial_ && trial_->moves_by_itself());
  }
  [[nodiscard]] const Session& session() const noexcept { return session_; }
  [[nodiscard]] const Journal& journal() const noexcept { return journal_; }
  /// Error: a row could not be written.
  [[nodiscard]] const std::optional<Error>& failed() const noexcept { return failed_; }
  /// Why the last penetration was broken off, other than by the person.
  [[nodiscard]] const std::optional<Error>& lost() const noexcept { return lost_; }

 private:
  bool begin(SessionTime now);
  bool let_go();
  void push(const std::function<void(PersonTrial&)>& by);
  void advance(double seconds);
  void break_off();
  void finish_trial();
  void write(const Attempt& attempt);

  Session session_;
  Journal journal_;
  std::string participant_;
  std::function<void()> over_;
  Place place_;
  std::unique_ptr<PersonTrial> trial_;
  Condition condition_ = Condition::Both;  // of trial_
  PersonTrial::Ticks ticks_;
  std::optional<Error> failed_;
  std::optional<Error> lost_;
};

}  // namespace telepalp::study
