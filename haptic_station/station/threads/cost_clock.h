#pragma once

#include <cstdint>

namespace telepalp::station {

/// The processor's time-stamp counter: a clock without a system call, for the effects' bill.
[[nodiscard]] std::uint64_t cycles_now() noexcept;

/// How many cycles of cycles_now() make a microsecond; measured once, against the steady clock, in 10 ms.
[[nodiscard]] double cycles_per_us();

}  // namespace telepalp::station
