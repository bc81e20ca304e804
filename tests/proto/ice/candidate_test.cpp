#include "proto/ice/words/candidate.h"

#include <gtest/gtest.h>

#include <ostream>

namespace telepalp::ice {
namespace {

struct RefusedText {
  const char* why;
  std::string text;
};
void PrintTo(const RefusedText& one, std::ostream* out) { *out << one.why; }

std::string at(const std::string& address) { return "candidate:1 1 udp 2015363327 " + address + " 40000 typ host"; }

const std::string kGood = at("10.0.0.5");

const RefusedText kRefusedTexts[] = {
    {"nothing", ""},
    {"no prefix", kGood.substr(10)},
    {"a word is missing", "candidate:1 1 udp 2015363327 10.0.0.5 40000 host"},
    {"a word too much", kGood + " raddr 10.0.0.1 rport 1"},
    {"a space at the end", kGood + " "},
    {"two spaces", "candidate:1  1 udp 2015363327 10.0.0.5 40000 typ host"},
    {"no foundation", "candidate: 1 udp 2015363327 10.0.0.5 40000 typ host"},
    {"a foundation of 33 characters", "candidate:" + std::string(33, 'a') + " 1 udp 1 10.0.0.5 40000 typ host"},
    {"a foundation with a quote", "candidate:\" 1 udp 2015363327 10.0.0.5 40000 typ host"},
    {"the second component", "candidate:1 2 udp 2015363327 10.0.0.5 40000 typ host"},
    {"TCP", "candidate:1 1 tcp 2015363327 10.0.0.5 40000 typ host"},
    {"a priority of 33 bits", "candidate:1 1 udp 4294967296 10.0.0.5 40000 typ host"},
    {"a negative priority", "candidate:1 1 udp -1 10.0.0.5 40000 typ host"},
    {"port 0", "candidate:1 1 udp 1 10.0.0.5 0 typ host"},
    {"port 65536", "candidate:1 1 udp 1 10.0.0.5 65536 typ host"},
    {"a port with letters", "candidate:1 1 udp 1 10.0.0.5 40x typ host"},
    {"a kind that no peer may name", "candidate:1 1 udp 1 10.0.0.5 40000 typ prflx"},
    {"a name", at("patient.example")},
    {"a multicast DNS name", at("9b36eaac-bb2e-49bb-bb78-21c41c499900.local")},
    {"an address in hexadecimal", at("0x0a000005")},
    {"longer than 160 B", at(std::string(160, '1'))},
    {"unspecified", at("0.0.0.0")},
    {"this network", at("0.1.2.3")},
    {"loopback", at("127.0.0.1")},
    {"loopback of IPv6", at("::1")},
    {"link-local, where clouds keep secrets", at("169.254.169.254")},
    {"link-local of IPv6", at("fe80::1")},
    {"link-local with a scope", at("fe80::1%lo")},
    {"a card of the other computer", at("2001:db8::1%7")},
    {"multicast", at("224.0.0.251")},
    {"multicast of IPv6", at("ff02::fb")},
    {"broadcast", at("255.255.255.255")},
    {"loopback in the clothes of IPv6", at("::ffff:127.0.0.1")},
    {"loopback, compatible with IPv4", at("::127.0.0.1")},
    {"loopback by NAT64", at("64:ff9b::7f00:1")},
    {"loopback by 6to4", at("2002:7f00:1::1")},
    {"unspecified of IPv6", at("::")},
};

class RefusedCandidate : public testing::TestWithParam<RefusedText> {};
TEST_P(RefusedCandidate, IsNotRead) { EXPECT_FALSE(read_candidate(GetParam().text, Reach::Network)); }
INSTANTIATE_TEST_SUITE_P(HardCases, RefusedCandidate, testing::ValuesIn(kRefusedTexts));

TEST(Candidate, IsReadAndWrittenAsRfc8839WritesIt) {
  for (const std::string& text :
       {kGood, at("2001:db8::5"), std::string("candidate:a/+9 1 udp 4294967295 203.0.113.9 65535 typ srflx"),
        std::string("candidate:7 1 udp 0 192.0.2.1 1 typ relay")}) {
    const auto candidate = read_candidate(text, Reach::Network);
    ASSERT_TRUE(candidate) << text;
    EXPECT_EQ(to_text(*candidate), text);
  }
}

TEST(Candidate, OfThisComputerIsReadWhenATestAsksForIt) {
  EXPECT_TRUE(read_candidate(at("127.0.0.1"), Reach::Loopback));
  EXPECT_TRUE(read_candidate(at("::1"), Reach::Loopback));
  EXPECT_FALSE(read_candidate(at("224.0.0.251"), Reach::Loopback));
}

TEST(Credential, HasEnoughIceCharsAndNoOthers) {
  EXPECT_TRUE(is_credential("aZ0+", 4));
  EXPECT_FALSE(is_credential("aZ0", 4));
  EXPECT_FALSE(is_credential("aZ0:", 4));
  EXPECT_FALSE(is_credential(std::string(257, 'a'), 4));
}

}  // namespace
}  // namespace telepalp::ice
