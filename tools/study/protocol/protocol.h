#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tools/study/run/block_order.h"
#include "tools/study/run/study.h"

namespace telepalp::study {

/// How participants move the hand, and how they perceive the force. A mouse gives no force, so people at a browser and
/// people at a device are different protocols, and journal, table and report say which one it is.
enum class PersonHand : std::uint8_t { Browser, Device };
inline constexpr std::array<std::string_view, 2> kHandWords{"browser, force shown as a bar",
                                                            "haptic device, force felt"};
[[nodiscard]] constexpr std::string_view words(PersonHand hand) noexcept {
  return kHandWords[static_cast<std::size_t>(hand)];
}

/// The protocol of the simulated operators, followed by a person.
struct Protocol {
  Design design;
  std::vector<Condition> conditions{Condition::Both};  ///< each at most once: Force, Vision or Both
  std::uint64_t seed = 1;
  int training = kTrainingPenetrations * kTrainingMechanisms;  ///< penetrations before each condition
  int penetrations = 5;                                        ///< of each mechanism in each condition
  PersonHand hand = PersonHand::Browser;
};

/// A person who takes part, known by a short name.
struct Participant {
  std::string name;
  std::size_t number = 0;  ///< for random numbers; simulated operators have lower numbers
};
/// Error: the name is not 1 to 40 letters, digits, - or _.
[[nodiscard]] Result<Participant> participant_of(const std::string& name);

/// Reads "both" or "force,vision,both". Error: another word, or a word given twice.
[[nodiscard]] Result<std::vector<Condition>> read_conditions(const std::string& text);

/// One penetration that is asked of the person.
struct Planned {
  Condition condition = Condition::Both;
  bool training = false;
  std::size_t place = 0;          ///< as Trial::place; of a training run the number of its mechanism
  std::size_t configuration = 0;  ///< index of the mechanism in the design
  int penetration = 0;
};
/// All penetrations in their order: the conditions in random order, and in each of them training, then all mechanisms
/// in random order. The order depends on the seed and the participant, as that of a simulated operator.
[[nodiscard]] std::vector<Planned> plan_of(const Protocol& protocol, const Participant& participant);

/// The plant of this participant, drawn as that of a simulated operator of this number. Error: a mechanism of the
/// design cannot be used on it.
[[nodiscard]] Result<Plant> plant_for(const Protocol& protocol, const Participant& participant);

/// All on which the protocol depends besides the participant, in one line.
[[nodiscard]] std::string identity_of(const Protocol& protocol);

}  // namespace telepalp::study
