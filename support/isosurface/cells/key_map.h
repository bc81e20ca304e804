#pragma once

#include <cstdint>
#include <vector>

namespace telepalp::isosurface {

/// A hash map from keys below 2^64 - 1 to small values, in one array with linear probing.
template <class Value>
class KeyMap {
 public:
  KeyMap() { reset(64); }

  /// The value of the key; nullptr if there is none. Valid until the next insertion.
  [[nodiscard]] const Value* find(std::uint64_t key) const noexcept {
    const Slot& slot = slots_[place_of(key)];
    return slot.key == key ? &slot.value : nullptr;
  }
  /// The key's value, and whether it is new. Valid until the next insertion.
  std::pair<Value*, bool> insert(std::uint64_t key) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    Slot& slot = slots_[place_of(key)];
    const bool added = slot.key != key;
    if (added) slot = {key, Value{}};
    count_ += added ? 1 : 0;
    return {&slot.value, added};
  }
  [[nodiscard]] std::size_t size() const noexcept { return count_; }
  void clear() { reset(slots_.size()); }

 private:
  static constexpr std::uint64_t kFree = ~std::uint64_t{0};
  struct Slot {
    std::uint64_t key = kFree;
    Value value{};
  };
  [[nodiscard]] std::size_t place_of(std::uint64_t key) const noexcept {
    std::uint64_t mixed = key * 0x9e3779b97f4a7c15ULL;
    mixed ^= mixed >> 32;
    std::size_t place = mixed & (slots_.size() - 1);
    while (slots_[place].key != kFree && slots_[place].key != key) place = (place + 1) & (slots_.size() - 1);
    return place;
  }
  void reset(std::size_t slots) {
    slots_.assign(slots, Slot{});
    count_ = 0;
  }
  void grow() {
    std::vector<Slot> old = std::move(slots_);
    reset(2 * old.size());
    for (const Slot& slot : old)
      if (slot.key != kFree) *insert(slot.key).first = slot.value;
  }
  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

}  // namespace telepalp::isosurface
