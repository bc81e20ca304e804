#include "server/access/unproven.h"

#include <algorithm>
#include <map>
#include <vector>

namespace telepalp::access {
namespace {

namespace ip = boost::asio::ip;
using TimePoint = std::chrono::steady_clock::time_point;

/// A program sends its greeting within a second after it was accepted, also by satellite.
constexpr std::chrono::seconds kTimeToGreet{1};

ip::address_v6 network_of_v6(const ip::address_v6& address) {
  ip::address_v6::bytes_type bytes = address.to_bytes();
  std::fill(bytes.begin() + 8, bytes.end(), std::uint8_t{0});
  return ip::address_v6(bytes);
}

/// Those of `chosen` whose `key` is the most frequent one, and how often it comes.
template <class Key>
std::pair<std::vector<std::size_t>, std::size_t> most_frequent(const std::vector<std::size_t>& chosen, Key key) {
  std::map<ip::address, std::size_t> counts;
  for (const std::size_t index : chosen) ++counts[key(index)];
  std::size_t most = 0;
  for (const auto& [of, count] : counts) most = std::max(most, count);
  std::vector<std::size_t> kept;
  std::copy_if(chosen.begin(), chosen.end(), std::back_inserter(kept),
               [&](std::size_t index) { return counts[key(index)] == most; });
  return {std::move(kept), most};
}

}  // namespace

Unproven newcomer(const ip::tcp::socket& socket) {
  boost::system::error_code gone;
  return {.from = socket.remote_endpoint(gone).address(), .since = std::chrono::steady_clock::now()};
}

ip::address network_of(const ip::address& address) {
  if (address.is_v6() && !address.to_v6().is_v4_mapped()) return network_of_v6(address.to_v6());
  const ip::address_v4 v4 = address.is_v4() ? address.to_v4() : ip::make_address_v4(ip::v4_mapped, address.to_v6());
  return ip::address_v4(v4.to_uint() & 0xFFFFFF00U);
}

std::optional<std::size_t> one_to_close(std::span<const Unproven> all, TimePoint now) {
  if (all.empty()) return std::nullopt;
  std::vector<std::size_t> every(all.size());
  for (std::size_t index = 0; index < all.size(); ++index) every[index] = index;
  const auto [crowded, in_network] =
      most_frequent(every, [&](std::size_t index) { return network_of(all[index].from); });
  const auto [chosen, at_address] = most_frequent(crowded, [&](std::size_t index) { return all[index].from; });
  const auto is_older = [&](std::size_t a, std::size_t b) { return all[a].since < all[b].since; };
  const auto [oldest, youngest] = std::minmax_element(chosen.begin(), chosen.end(), is_older);
  const bool takes_oldest = in_network == 1 || now - all[*oldest].since > kTimeToGreet;
  return takes_oldest ? *oldest : *youngest;
}

}  // namespace telepalp::access
