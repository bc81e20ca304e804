#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <type_traits>

namespace telepalp {

/// Hands every value from one producer thread to one consumer thread, in order. When the ring is full, try_push()
/// returns false; the producer counts the loss and continues. Wait-free, without allocation after construction.
template <class T, std::size_t N>
class SpscRing {
  static_assert((N & (N - 1)) == 0, "capacity is a power of two, so that the index wraps by masking");
  static_assert(std::is_trivially_copyable_v<T>, "a value crosses by copy on the real-time thread");

 public:
  /// Producer thread only.
  [[nodiscard]] bool try_push(const T& value) noexcept {
    const std::size_t head = head_.load(std::memory_order_relaxed);
    if (head - tail_.load(std::memory_order_acquire) == N) return false;
    slots_[head & (N - 1)] = value;
    head_.store(head + 1, std::memory_order_release);
    return true;
  }

  /// Consumer thread only.
  [[nodiscard]] bool try_pop(T& value) noexcept {
    const std::size_t tail = tail_.load(std::memory_order_relaxed);
    if (head_.load(std::memory_order_acquire) == tail) return false;
    value = slots_[tail & (N - 1)];
    tail_.store(tail + 1, std::memory_order_release);
    return true;
  }

 private:
  std::array<T, N> slots_{};
  alignas(64) std::atomic<std::size_t> head_{0};
  alignas(64) std::atomic<std::size_t> tail_{0};
};

}  // namespace telepalp
