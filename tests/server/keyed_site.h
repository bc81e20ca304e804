#pragma once

#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "proto/keys/authority.h"
#include "server/access/access.h"
#include "tests/server/loopback_site.h"
#include "tests/support/child_process.h"

namespace telepalp::server {

/// Keys as telepalp-keys makes them, in a folder that ends with the test.
struct KeyRing {
  support::TemporaryFolder folder;
  keys::WallTime now = std::chrono::system_clock::now();
  keys::Authority authority = std::move(keys::Authority::create("site", now, std::chrono::days(30)).value());
  mutable std::uint64_t lists = 0;  // number of the newest revocation list

  KeyRing() { write_list({}); }

  std::filesystem::path write(const std::string& name, const Result<std::string>& text) const {
    EXPECT_TRUE(text.ok());
    const std::filesystem::path file = folder.path() / name;
    std::ofstream(file) << *text;
    std::filesystem::permissions(file, std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    return file;
  }
  std::filesystem::path server_key(keys::WallTime made, std::vector<std::string> hosts = {"127.0.0.1"}) const {
    return write("server.key",
                 authority.server_key({.name = "server", .now = made, .valid = std::chrono::days(1)}, hosts));
  }
  std::shared_ptr<const keys::KeyFile> key(const std::string& name, keys::Role role, keys::WallTime made) const {
    return read(authority.client_key({.name = name, .role = role, .now = made, .valid = std::chrono::days(1)}));
  }
  std::shared_ptr<const keys::KeyFile> key(const std::string& name, keys::Role role) const {
    return key(name, role, now);
  }
  std::shared_ptr<const keys::KeyFile> token(const std::string& name, keys::Role role) const {
    return read(authority.token({.name = name, .role = role, .now = now, .valid = std::chrono::days(1)}));
  }
  void revoke(const std::string& serial) const { write_list({{serial, now}}); }
  void write_list(const std::map<std::string, keys::WallTime>& revoked) const {
    write("revoked.crl", authority.revocation_list(revoked, now, ++lists));
  }
  static std::shared_ptr<const keys::KeyFile> read(const Result<std::string>& text) {
    return std::make_shared<const keys::KeyFile>(*keys::read_key(*text, "key"));
  }
  std::string audit() const {
    std::ifstream file(folder.path() / "audit.log");
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

/// A server with keys and its clients, on one io_context.
struct KeyedSite : Site {
  KeyRing ring;
  std::shared_ptr<access::Access> access = open();

  KeyedSite() {
    auto made = hub::PeerListener::listen(
        io, hub, clock,
        {.port = 0, .access = access, .on_note = [this](const std::string& note) { notes.push_back(note); }});
    EXPECT_TRUE(made.ok());
    listener = std::move(made).value();
  }
  std::shared_ptr<access::Access> open() {
    auto opened = access::Access::with_key({.key = ring.server_key(ring.now), .revoked = {}, .audit = {}, .say = {}});
    EXPECT_TRUE(opened.ok()) << (opened ? "" : to_string(opened.error()));
    return std::move(opened).value();
  }
};

/// A client with a key, and what became of it.
struct KeyedClient {
  std::vector<wire::Message> messages;
  std::vector<std::string> details;
  std::vector<std::string> hand_over_answers;  ///< "done: ..." or "refused: ..."
  wire::ClientLink link;

  KeyedClient(Site& site, std::shared_ptr<const keys::KeyFile> key, std::string role = "viewer",
              std::vector<wire::Topic> publishes = {}, std::string host = "127.0.0.1", std::uint16_t port = 0,
              std::string consent = {})
      : link(site.io,
             {.host = std::move(host),
              .port = port != 0 ? port : site.listener->port(),
              .name = "test",
              .role = std::move(role),
              .key = std::move(key),
              .consent = std::move(consent),
              .subscribes = {"*"},
              .publishes = std::move(publishes)},
             {.on_message = [this](const wire::Message& message) { messages.push_back(message); },
              .on_state = [this](wire::LinkState, const std::string& detail) { details.push_back(detail); },
              .on_hand_over =
                  [this](bool done, const std::string& outcome) {
                    hand_over_answers.push_back((done ? "done: " : "refused: ") + outcome);
                  }}) {
    link.start();
  }
  [[nodiscard]] bool connected() const { return link.state() == wire::LinkState::Connected; }
  [[nodiscard]] bool refused() const { return link.state() == wire::LinkState::Refused; }
};

}  // namespace telepalp::server
