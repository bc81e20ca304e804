#pragma once

#include <functional>
#include <optional>
#include <string>

#include "tools/study/protocol/browser_trial.h"
#include "tools/study/protocol/page_command.h"

namespace telepalp::study {

/// The place at which one participant works: the session, its journal, and the penetration that is under way. Every
/// attempt that ends is written to the journal at once. Owner: the network thread.
class Desk {
 public:
  /// `over`: called once, when the last penetration is done or the journal cannot be written.
  Desk(Session session, Journal journal, std::string participant, std::function<void()> over)
      : session_(std::move(session)),
        journal_(std::move(journal)),
        participant_(std::move(participant)),
        over_(std::move(over)) {}

  /// Does what the page asks; true: the state of the session has changed.
  bool obey(const PageCommand& command);
  /// `seconds` of real time have passed; true: the state of the session has changed.
  bool step(double seconds);
  /// The person has gone: before the puncture the penetration is broken off; after it, the hand stands still until the
  /// tip has stopped, which counts.
  void leave();

  [[nodiscard]] std::string state() const;
  /// What is shown of the penetration that is under way; nullopt: none is.
  [[nodiscard]] std::optional<std::string> frame() const;
  /// False: nothing moves.
  [[nodiscard]] bool moves() const noexcept { return session_.stage() == Stage::Inserting; }
  [[nodiscard]] const Session& session() const noexcept { return session_; }
  [[nodiscard]] const Journal& journal() const noexcept { return journal_; }
  /// Error: a row could not be written.
  [[nodiscard]] const std::optional<Error>& failed() const noexcept { return failed_; }

 private:
  bool begin();
  bool let_go();
  void push(const std::function<void(BrowserTrial&)>& by);
  void finish_trial();
  void write(const Attempt& attempt);

  Session session_;
  Journal journal_;
  std::string participant_;
  std::function<void()> over_;
  std::optional<BrowserTrial> trial_;
  std::optional<Error> failed_;
};

}  // namespace telepalp::study
