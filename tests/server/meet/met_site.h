#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/asio/ip/tcp.hpp>
#include <memory>
#include <string>
#include <vector>

#include "server/meet/meet.h"
#include "server/meet/site/meet_dialer.h"
#include "tests/server/keyed_site.h"

namespace telepalp::server {

namespace asio = boost::asio;
using asio::ip::tcp;

/// A meeting point, and a site that is reached through it alone.
struct MetSite : KeyedSite {
  std::vector<std::string> log;  // of the meeting point
  std::vector<std::string> site_log;
  meet::RelayDoor relay;
  std::unique_ptr<meet::Meet> meeting = meet_at(0);
  std::unique_ptr<meet::MeetDialer> dialer;
  bool takes = true;
  bool has_address = true;  // the computer of the site still has the address from which the site dialled
  std::size_t browsers = 0;

  std::unique_ptr<meet::Meet> meet_at(
      std::uint16_t port, meet::Meet::Limits limits = {},
      keys::IsRevoked is_revoked = [](const keys::Identity&) { return false; }) {
    auto made = meet::Meet::listen(io, {.address = "127.0.0.1",
                                        .port = port,
                                        .key = *host_key("meet", {"127.0.0.1", "meet.example"}),
                                        .is_revoked = std::move(is_revoked),
                                        .relay = relay,
                                        .log = [this](const std::string& text) { log.push_back(text); },
                                        .limits = limits});
    EXPECT_TRUE(made.ok()) << (made ? "" : to_string(made.error()));
    return std::move(made).value();
  }
  std::shared_ptr<const keys::KeyFile> host_key(const std::string& name, const std::vector<std::string>& hosts) const {
    return KeyRing::read(
        ring.authority.server_key({.name = name, .now = ring.now, .valid = std::chrono::days(1)}, hosts));
  }
  std::unique_ptr<meet::MeetDialer> dial(const std::vector<std::string>& names) {
    return dial_with(host_key(names.front(), names));
  }
  std::unique_ptr<meet::MeetDialer> dial_with(std::shared_ptr<const keys::KeyFile> key) {
    auto started = meet::MeetDialer::start(io, {.host = "127.0.0.1",
                                                .port = meeting->port(),
                                                .key = std::move(key),
                                                .on_caller =
                                                    [this](tcp::socket socket, const meet::MeetDialer::Caller& caller) {
                                                      browsers += caller.is_browser ? 1 : 0;
                                                      listener->admit(std::move(socket));
                                                    },
                                                .takes = [this](const meet::MeetDialer::Caller&) { return takes; },
                                                .log = [this](const std::string& text) { site_log.push_back(text); },
                                                .has_address = [this](const auto&) { return has_address; }});
    EXPECT_TRUE(started.ok());
    return std::move(started).value();
  }
  std::ptrdiff_t times_said(const std::string& words) const {
    return std::ranges::count_if(site_log,
                                 [&](const std::string& line) { return line.find(words) != std::string::npos; });
  }
  bool site_says(const std::string& words) const { return times_said(words) > 0; }
};

/// A doctor's program that knows the site's name, and the meeting point's address.
struct Caller {
  std::vector<wire::Message> messages;
  std::vector<std::string> details;
  wire::ClientLink link;

  Caller(MetSite& met, std::string site, std::shared_ptr<const keys::KeyFile> key, std::string role = "doctor")
      : link(met.io,
             {.host = "127.0.0.1",
              .port = met.meeting->port(),
              .site = std::move(site),
              .name = "test",
              .role = std::move(role),
              .key = std::move(key),
              .subscribes = {"*"}},
             {.on_message = [this](const wire::Message& message) { messages.push_back(message); },
              .on_state = [this](wire::LinkState, const std::string& detail) { details.push_back(detail); }}) {
    link.start();
  }
  [[nodiscard]] bool connected() const { return link.state() == wire::LinkState::Connected; }
};

/// The site's server has the key of the name `ward3`.
struct Meeting : testing::Test {
  MetSite met;
  void SetUp() override {
    met.listener.reset();  // the audit log is locked while the one before it lives
    met.access.reset();
    auto opened = access::Access::with_key(
        {.key = met.ring.server_key(met.ring.now, {"ward3", "ward3.example"}), .revoked = {}, .audit = {}, .say = {}});
    ASSERT_TRUE(opened.ok());
    met.access = std::move(opened).value();
    auto made = hub::PeerListener::listen(met.io, met.hub, met.clock, {.port = 0, .access = met.access});
    ASSERT_TRUE(made.ok());
    met.listener = std::move(made).value();
  }
  void join(const std::vector<std::string>& names = {"ward3", "ward3.example"}) {
    met.dialer = met.dial(names);
    ASSERT_TRUE(met.run_until([this] { return met.dialer->has_joined(); }));
  }
};

}  // namespace telepalp::server
