#pragma once

#include <string>

#include "tools/study/protocol/hands/person_trial.h"
#include "tools/study/protocol/session.h"

namespace telepalp::study {

// The program's messages to the protocol's page: JSON objects whose `kind` says what they are. Lengths are in mm,
// forces in N; places are in the plane z = 0 of the tissue's frame, the skin at y = 0. What the condition hides is not
// sent.

/// `kind`: state. Where the person is, what comes next, and how far the needle overshot last. `participant`: the name.
[[nodiscard]] std::string state_json(const Session& session, const std::string& participant);
/// `kind`: frame. The needle outside the skin while it is seen, the force at the hand while it is felt, and the
/// direction in which the hand pushes the needle in.
[[nodiscard]] std::string trial_frame_json(const TrialView& trial, Condition condition);
/// `kind`: refused, with the sentence.
[[nodiscard]] std::string page_refused_json(const Error& error);
/// `kind`: taken. Another page has taken over.
[[nodiscard]] std::string taken_json();

}  // namespace telepalp::study
