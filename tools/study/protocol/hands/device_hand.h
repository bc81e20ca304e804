#pragma once

#include <memory>

#include "tools/study/device/device_thread.h"
#include "tools/study/protocol/hands/device_penetration.h"

namespace telepalp::study {

/// A penetration that the hand at `device` moves. One at a time, which must end before the device's thread.
[[nodiscard]] std::unique_ptr<PersonTrial> begin_at_device(DeviceThread& device, Prepared prepared,
                                                           Condition condition);

}  // namespace telepalp::study
