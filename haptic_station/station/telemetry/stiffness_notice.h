#pragma once

#include <optional>
#include <string>

#include "haptic_station/loop/compensation.h"

namespace telepalp::station {

/// Says once that the device's loop delay limits the stiffness that the hand feels. Pure.
class StiffnessNotice {
 public:
  /// The sentence, at the first compensation at which the limit is in force; nullopt: nothing new.
  [[nodiscard]] std::optional<std::string> look(const loop::Compensation& compensation);

 private:
  bool said_ = false;
};

}  // namespace telepalp::station
