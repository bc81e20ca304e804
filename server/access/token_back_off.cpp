#include "server/access/token_back_off.h"

#include <algorithm>

namespace telepalp::access {
namespace {

constexpr unsigned kFree = 5;
constexpr std::size_t kMost = 1024;
constexpr std::chrono::seconds kLongest{60};

/// Makes room for one entry in `map`, unless it has `key` already.
template <class Map>
void make_room(Map& map, const typename Map::key_type& key) {
  if (map.size() < kMost || map.contains(key)) return;
  map.erase(std::min_element(map.begin(), map.end(),
                             [](const auto& a, const auto& b) { return a.second.last < b.second.last; }));
}

}  // namespace

bool TokenBackOff::may_try(const std::string& address, const std::string& token, TimePoint now) {
  const auto found = tokens_.find({address, token});
  if (found != tokens_.end()) return now >= found->second.until;
  const auto from = addresses_.find(address);
  return from == addresses_.end() || from->second.wrong.has(1.0, now.time_since_epoch());
}

TokenBackOff::Tried& TokenBackOff::tried(const std::string& address, const std::string& token, TimePoint now) {
  make_room(tokens_, {address, token});
  Tried& tried = tokens_[{address, token}];
  tried.last = now;
  return tried;
}

void TokenBackOff::failed(const std::string& address, const std::string& token, TimePoint now) {
  Tried& one = tried(address, token, now);
  if (one.failures == 0) {
    make_room(addresses_, address);
    Address& from = addresses_[address];
    from.last = now;
    from.wrong.spend(1.0);
  }
  if (++one.failures < kFree) return;
  const auto wait = std::chrono::seconds(1LL << std::min(one.failures - kFree, 6U));
  one.until = now + std::min<std::chrono::seconds>(wait, kLongest);
}

void TokenBackOff::succeeded(const std::string& address, const std::string& token, TimePoint now) {
  tried(address, token, now) = {.failures = 0, .until = {}, .last = now};
}

}  // namespace telepalp::access
