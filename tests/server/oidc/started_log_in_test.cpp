#include "server/oidc/browser/started_log_in.h"

#include <gtest/gtest.h>

namespace telepalp::oidc {
namespace {

const StartedLogIns::TimePoint kBegun{std::chrono::seconds(1'900'000'000)};

TEST(StartedLogIns, ABrowserEndsTheLogInThatItBeganOnce) {
  StartedLogIns started;
  const std::string cookie = started.begin("/?view=doctor&at_s=1.5", kBegun);
  const LogIn begun = *started.read(cookie, kBegun);
  EXPECT_EQ(begun.page, "/?view=doctor&at_s=1.5");
  const std::string other = started.begin("/", kBegun);
  EXPECT_FALSE(started.end(other, begun.state, kBegun)) << "the state of another browser";
  EXPECT_FALSE(started.end(cookie, begun.nonce, kBegun));
  EXPECT_FALSE(started.end("", begun.state, kBegun));
  const std::optional<LogIn> ended = started.end(cookie, begun.state, kBegun + std::chrono::seconds(600));
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->nonce, begun.nonce);
  EXPECT_EQ(ended->verifier, begun.verifier);
  EXPECT_FALSE(started.end(cookie, begun.state, kBegun)) << "it comes a second time";
}

TEST(StartedLogIns, EachLogInHasSecretsOfItsOwn) {
  const StartedLogIns started;
  std::set<std::string> all;
  for (int i = 0; i < 100; ++i) {
    const LogIn one = *started.read(started.begin("/", kBegun), kBegun);
    for (const std::string& secret : {one.state, one.nonce, one.verifier, one.challenge}) all.insert(secret);
    EXPECT_GE(one.verifier.size(), 43U);  // RFC 7636, 4.1
    EXPECT_EQ(one.challenge.size(), 43U);
    EXPECT_EQ(one.challenge.find_first_of("+/="), std::string::npos);
  }
  EXPECT_EQ(all.size(), 400U);
}

TEST(StartedLogIns, AnOldOrAlteredOrForeignCookieIsNone) {
  StartedLogIns started;
  const std::string cookie = started.begin("/", kBegun);
  EXPECT_FALSE(started.read(cookie, kBegun + std::chrono::seconds(601)));
  EXPECT_FALSE(started.read(cookie, kBegun - std::chrono::seconds(1)));
  EXPECT_FALSE(StartedLogIns().read(cookie, kBegun)) << "of the server before it was started again";
  for (std::size_t at = 0; at < cookie.size(); ++at) {
    std::string altered = cookie;
    altered[at] = altered[at] == '0' ? '1' : '0';
    EXPECT_FALSE(started.read(altered, kBegun)) << at;
    EXPECT_FALSE(started.read(cookie.substr(0, at), kBegun)) << at;
  }
}

TEST(StartedLogIns, WhateverEndsTheMemoryStaysBounded) {
  StartedLogIns started;
  const std::string first = started.begin("/", kBegun);
  const std::string state = started.read(first, kBegun)->state;
  ASSERT_TRUE(started.end(first, state, kBegun));
  for (std::size_t i = 1; i < StartedLogIns::kMost; ++i) {
    const std::string cookie = started.begin("/", kBegun);
    ASSERT_TRUE(started.end(cookie, started.read(cookie, kBegun)->state, kBegun));
  }
  EXPECT_FALSE(started.end(first, state, kBegun)) << "as many as are remembered";
}

}  // namespace
}  // namespace telepalp::oidc
