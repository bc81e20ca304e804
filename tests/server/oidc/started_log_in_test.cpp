#include "server/oidc/browser/started_log_in.h"

#include <gtest/gtest.h>

namespace telepalp::oidc {
namespace {

const StartedLogIns::TimePoint kNow{std::chrono::seconds(1'900'000'000)};

TEST(StartedLogIns, ABrowserEndsTheLogInThatItBeganOnce) {
  StartedLogIns started;
  const std::string cookie = started.begin("/?view=doctor&at_s=1.5", kNow);
  const LogIn begun = *started.read(cookie, kNow);
  EXPECT_EQ(begun.page, "/?view=doctor&at_s=1.5");
  const std::string other = started.begin("/", kNow);
  EXPECT_FALSE(started.end(other, begun.state, kNow)) << "the state of another browser";
  EXPECT_FALSE(started.end(cookie, begun.nonce, kNow));
  EXPECT_FALSE(started.end("", begun.state, kNow));
  const std::optional<LogIn> ended = started.end(cookie, begun.state, kNow + std::chrono::seconds(600));
  ASSERT_TRUE(ended);
  EXPECT_EQ(ended->nonce, begun.nonce);
  EXPECT_EQ(ended->verifier, begun.verifier);
  EXPECT_FALSE(started.end(cookie, begun.state, kNow)) << "it comes a second time";
}

TEST(StartedLogIns, EachLogInHasSecretsOfItsOwn) {
  const StartedLogIns started;
  std::set<std::string> all;
  for (int i = 0; i < 100; ++i) {
    const LogIn one = *started.read(started.begin("/", kNow), kNow);
    for (const std::string& secret : {one.state, one.nonce, one.verifier, one.challenge}) all.insert(secret);
    EXPECT_GE(one.verifier.size(), 43U);  // RFC 7636, 4.1
    EXPECT_EQ(one.challenge.size(), 43U);
    EXPECT_EQ(one.challenge.find_first_of("+/="), std::string::npos);
  }
  EXPECT_EQ(all.size(), 400U);
}

TEST(StartedLogIns, AnOldOrAlteredOrForeignCookieIsNone) {
  StartedLogIns started;
  const std::string cookie = started.begin("/", kNow);
  EXPECT_FALSE(started.read(cookie, kNow + std::chrono::seconds(601)));
  EXPECT_FALSE(started.read(cookie, kNow - std::chrono::seconds(1)));
  EXPECT_FALSE(StartedLogIns().read(cookie, kNow)) << "of the server before it was started again";
  for (std::size_t at = 0; at < cookie.size(); ++at) {
    std::string altered = cookie;
    altered[at] = altered[at] == '0' ? '1' : '0';
    EXPECT_FALSE(started.read(altered, kNow)) << at;
    EXPECT_FALSE(started.read(cookie.substr(0, at), kNow)) << at;
  }
}

TEST(StartedLogIns, WhateverEndsTheMemoryStaysBounded) {
  StartedLogIns started;
  const std::string first = started.begin("/", kNow);
  const std::string state = started.read(first, kNow)->state;
  ASSERT_TRUE(started.end(first, state, kNow));
  for (std::size_t i = 1; i < StartedLogIns::kMost; ++i) {
    const std::string cookie = started.begin("/", kNow);
    ASSERT_TRUE(started.end(cookie, started.read(cookie, kNow)->state, kNow));
  }
  EXPECT_FALSE(started.end(first, state, kNow)) << "as many as are remembered";
}

}  // namespace
}  // namespace telepalp::oidc
