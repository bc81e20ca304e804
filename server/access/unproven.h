#pragma once

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <cstddef>
#include <optional>
#include <span>

namespace telepalp::access {

/// A connection that has not proved yet who uses it.
struct Unproven {
  boost::asio::ip::address from{};
  std::chrono::steady_clock::time_point since{};  ///< when it was accepted
};

/// The connection of `socket`, accepted now. Its address stays 0.0.0.0 if the other end has gone already.
[[nodiscard]] Unproven newcomer(const boost::asio::ip::tcp::socket& socket);

/// The network of an address: its first 64 bits for IPv6, its first 24 for IPv4, also for IPv4 in IPv6. One machine or
/// one subscriber of a provider can take each address of such a network.
[[nodiscard]] boost::asio::ip::address network_of(const boost::asio::ip::address& address);

/// The index of the connection that is closed when `all` are one too many; nullopt: `all` is empty. It belongs to the
/// network that holds most, and in it to the address that holds most: of those the oldest if it has waited for a
/// second, else the youngest. When no network holds two, the oldest of all. So an address that opens many connections
/// loses its own, and a person behind the same NAT gets in once the silent ones have waited. Pure.
[[nodiscard]] std::optional<std::size_t> one_to_close(std::span<const Unproven> all,
                                                      std::chrono::steady_clock::time_point now);

}  // namespace telepalp::access
