#include "server/meet/relay/relay_credentials.h"

#include <openssl/evp.h>
#include <openssl/hmac.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <fstream>

#include "proto/ice/words/candidate.h"
#include "proto/words/demand.h"

namespace telepalp::meet {
namespace {

constexpr std::size_t kLeastSecret = 16, kMostSecret = 256;

/// HMAC-SHA1, which the relay expects. SHA-1's weakness, collisions, does not concern HMAC.
std::string hmac_in_base64(std::string_view secret, std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> code{};
  unsigned int size = 0;
  const auto* const bytes = reinterpret_cast<const unsigned char*>(text.data());
  demand(HMAC(EVP_sha1(), secret.data(), static_cast<int>(secret.size()), bytes, text.size(), code.data(), &size) !=
             nullptr,
         "OpenSSL computes an HMAC-SHA1");
  std::array<unsigned char, 2 * EVP_MAX_MD_SIZE> base64{};
  const int length = EVP_EncodeBlock(base64.data(), code.data(), static_cast<int>(size));
  return {base64.begin(), base64.begin() + length};
}

}  // namespace

Result<RelayDoor> relay_door(const std::string& host, std::uint16_t port, const std::filesystem::path& secret_file) {
  std::ifstream file(secret_file);
  std::string secret;
  if (!std::getline(file, secret) || secret.size() < kLeastSecret || secret.size() > kMostSecret)
    return Error{.what = "its first line is no secret of 16 to 256 characters",
                 .where = secret_file.string(),
                 .fix = "openssl rand -hex 32 > FILE, and the same line as static-auth-secret in turnserver.conf"};
  boost::asio::io_context io;
  boost::system::error_code failed;
  const auto found = boost::asio::ip::tcp::resolver(io).resolve(host, std::to_string(port), failed);
  if (failed || found.empty())
    return Error{.what = "the relay's name is unknown: " + failed.message(),
                 .where = "--relay " + host,
                 .fix = "give the relay's public address: --relay 203.0.113.1:3478"};
  const boost::asio::ip::address address = found.begin()->endpoint().address();
  if (!ice::may_check(address, ice::Reach::Network))
    return Error{.what = "the relay's address is " + address.to_string() + ", at which no site reaches it",
                 .where = "--relay " + host,
                 .fix = "give the relay's public address: --relay 203.0.113.1:3478"};
  return RelayDoor{.address = address.to_string(), .port = port, .secret = std::move(secret)};
}

msg::MeetRelay credentials(const RelayDoor& door, std::string_view who, std::uint16_t tcp_port,
                           std::chrono::system_clock::time_point now) {
  const auto ends = std::chrono::floor<std::chrono::seconds>(now + kCredentialsHold).time_since_epoch().count();
  msg::MeetRelay relay;
  relay.set_address(door.address);
  relay.set_port(door.port);
  relay.set_tcp_port(tcp_port);
  relay.set_user(std::to_string(ends) + ":" + std::string(who));
  relay.set_password(hmac_in_base64(door.secret, relay.user()));
  return relay;
}

}  // namespace telepalp::meet
