#include "haptic_station/effects/effect_bank.h"

#include "haptic_station/effects/bank/bank_steps.h"

namespace telepalp::effects {

template class BasicEffectBank<Effect>;

}  // namespace telepalp::effects
