#include "proto/ice/words/relay.h"

#include <cstddef>
#include <utility>

namespace telepalp::ice {
namespace {

constexpr std::size_t kMostText = 256;  // of user and password

/// What is wrong with the relay; empty: nothing.
std::string wrong_with(const msg::IceRelay& message, Reach reach) {
  boost::system::error_code no_address;
  const auto address = boost::asio::ip::make_address(message.address(), no_address);
  if (no_address) return "the relay's address is not an IP address";
  if (!may_check(address, reach))
    return "the relay's address is " + address.to_string() +
           ", a loopback, link-local, multicast or reserved one, to which nothing is sent";
  if (message.port() > 65535 || message.tcp_port() > 65535) return "the relay has a port above 65535";
  if (message.user().size() > kMostText || message.password().size() > kMostText)
    return "the relay's credentials are longer than 256 B";
  return {};
}

}  // namespace

Result<Relay> read_relay(const msg::IceRelay& message, Reach reach) {
  if (std::string wrong = wrong_with(message, reach); !wrong.empty())
    return Error{.what = std::move(wrong) + "; this relay is not used",
                 .where = "relay",
                 .fix =
                     "on the meeting point's computer, name the relay by its public address: "
                     "telepalp-meet --relay 203.0.113.1:3478"};
  return Relay{.address = message.address(),
               .port = static_cast<std::uint16_t>(message.port()),
               .tcp_port = static_cast<std::uint16_t>(message.tcp_port()),
               .user = message.user(),
               .password = message.password()};
}

}  // namespace telepalp::ice
