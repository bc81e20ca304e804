#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <utility>

namespace telepalp {

/// Hands the newest value from one producer thread to one consumer thread; a newer value replaces an older one that was
/// not taken. Wait-free on both sides: of three slots, the producer owns one, the consumer owns one, and the third is
/// exchanged atomically. Neither side allocates. The producer destroys a value when it overwrites its slot, so the
/// consumer never frees memory that the producer allocated.
template <class T>
class LatestValue {
 public:
  /// Producer thread only.
  void put(T value) {
    slots_[back_] = std::move(value);
    back_ = shared_.exchange(static_cast<std::uint8_t>(back_ | kFresh), std::memory_order_acq_rel) & kIndex;
  }

  /// Consumer thread only. True when there is a newer value, which becomes `current()`.
  bool take() noexcept {
    if ((shared_.load(std::memory_order_relaxed) & kFresh) == 0) return false;
    front_ = shared_.exchange(front_, std::memory_order_acq_rel) & kIndex;
    return true;
  }

  /// Consumer thread only. Valid until the next take(). Before the first take() it is a default value.
  [[nodiscard]] T& current() noexcept { return slots_[front_]; }

 private:
  static constexpr std::uint8_t kFresh = 4;
  static constexpr std::uint8_t kIndex = 3;
  std::array<T, 3> slots_{};
  alignas(64) std::atomic<std::uint8_t> shared_{1};
  alignas(64) std::uint8_t back_ = 0;   // owned by the producer
  alignas(64) std::uint8_t front_ = 2;  // owned by the consumer
};

}  // namespace telepalp
