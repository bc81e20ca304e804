// Whose connection is closed when too many have not proved yet who uses them.

#include "server/access/unproven.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace telepalp::access {
namespace {

using namespace std::chrono_literals;

const std::chrono::steady_clock::time_point kNow = std::chrono::steady_clock::time_point{} + 1h;

Unproven from(const std::string& address, std::chrono::milliseconds ago) {
  return {.from = boost::asio::ip::make_address(address), .since = kNow - ago};
}

std::string network(const std::string& address) {
  return network_of(boost::asio::ip::make_address(address)).to_string();
}

TEST(Unproven, ANetworkIsTheFirst24BitsOfIPv4AndTheFirst64OfIPv6) {
  EXPECT_EQ(network("10.1.2.3"), "10.1.2.0");
  EXPECT_EQ(network("::ffff:10.1.2.3"), "10.1.2.0");
  EXPECT_EQ(network("2001:db8:1:2:3:4:5:6"), "2001:db8:1:2::");
}

TEST(Unproven, TheYoungestOfTheNetworkThatHoldsMostIsClosed) {
  const std::vector<Unproven> all{from("10.0.0.1", 900ms), from("10.9.9.1", 300ms), from("10.9.9.2", 200ms),
                                  from("10.9.9.3", 100ms), from("10.0.1.1", 0ms)};
  EXPECT_EQ(one_to_close(all, kNow), 3u);
}

TEST(Unproven, APersonBehindTheSameNetworkKeepsHerPlaceBesideAnAddressThatHoldsMore) {
  const std::vector<Unproven> all{from("10.9.9.1", 300ms), from("10.9.9.1", 200ms), from("10.9.9.2", 0ms)};
  EXPECT_EQ(one_to_close(all, kNow), 1u);
}

TEST(Unproven, AConnectionThatWaitedForASecondGoesBeforeANewOneOfTheSameAddress) {
  const std::vector<Unproven> all{from("10.9.9.1", 1200ms), from("10.9.9.1", 1100ms), from("10.9.9.1", 0ms)};
  EXPECT_EQ(one_to_close(all, kNow), 0u);
}

TEST(Unproven, AmongNetworksThatHoldOneEachTheOldestIsClosed) {
  const std::vector<Unproven> all{from("10.0.1.1", 10ms), from("10.0.2.1", 20ms), from("10.0.3.1", 0ms)};
  EXPECT_EQ(one_to_close(all, kNow), 1u);
}

TEST(Unproven, AddressesOfOneIPv6NetworkCountTogether) {
  const std::vector<Unproven> all{from("2001:db8::1", 30ms), from("2001:db8::2", 20ms), from("2001:db8:0:1::1", 0ms)};
  EXPECT_EQ(one_to_close(all, kNow), 1u);
}

TEST(Unproven, NothingIsClosedWhenNobodyWaits) { EXPECT_EQ(one_to_close({}, kNow), std::nullopt); }

}  // namespace
}  // namespace telepalp::access
