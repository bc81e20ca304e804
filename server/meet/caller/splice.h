#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <functional>
#include <string>

namespace telepalp::meet {

/// Joins a caller and a site: what one sends goes to the other as it is, in both directions, until both have ended or
/// one has failed. `first`: what was already read from the caller. `on_end` is called once, and not within this call.
/// The pair keeps itself alive. Returns a function that ends it early; afterwards the function does nothing.
std::function<void()> splice(boost::asio::ip::tcp::socket caller, std::string first, boost::asio::ip::tcp::socket site,
                             std::function<void()> on_end);

}  // namespace telepalp::meet
