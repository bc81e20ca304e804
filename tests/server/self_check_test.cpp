// telepalp-server --check: what stands in the way of a server is found before it starts, and nothing is changed.

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/udp.hpp>
#include <fstream>
#include <map>

#include "proto/keys/audit_chain.h"
#include "proto/keys/authority.h"
#include "tests/support/child_process.h"
#include "where.h"

namespace telepalp::server {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using boost::asio::ip::tcp;
using boost::asio::ip::udp;
using std::chrono::days;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

class SelfCheck : public testing::Test {
 protected:
  fs::path in(const std::string& name) const { return folder_.path() / name; }

  /// Runs `telepalp-server --check` and returns its exit code; said_ is what it printed.
  int check(std::vector<std::string> words) {
    words.insert(words.begin(), "--check");
    support::ChildProcess program(TELEPALP_BINARY_DIR "/bin/telepalp-server", words, in("said"));
    const int code = program.wait(30s).value_or(-1);
    said_ = text_of(in("said"));
    return code;
  }
  bool said(const std::string& words) const { return said_.find(words) != std::string::npos; }

  fs::path write(const std::string& name, const std::string& text) const {
    fs::create_directories(in(name).parent_path());
    std::ofstream(in(name), std::ios::binary) << text;
    fs::permissions(in(name), fs::perms::owner_read | fs::perms::owner_write);
    return in(name);
  }
  /// A folder with a server's key that was made `age` ago for `valid` days, and a list of revoked keys.
  std::string keys_of(const std::string& name, days age, days valid, bool revoked = false) const {
    const keys::WallTime made = keys::WallTime(std::chrono::system_clock::now()) - age;
    const keys::Authority authority = std::move(keys::Authority::create("site", made, days(4000)).value());
    const std::string key = authority.server_key({.name = "ward", .now = made, .valid = valid}, {"127.0.0.1"}).value();
    std::map<std::string, keys::WallTime> list;
    if (revoked) list[keys::read_key(key, "key")->identity.serial] = made;
    write(name + "/revoked.crl", authority.revocation_list(list, made, 1).value());
    return write(name + "/server.key", key);
  }
  std::map<std::string, std::string> all_files() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
      if (entry.is_regular_file() && entry.path().filename() != "said") all[entry.path()] = text_of(entry.path());
    return all;
  }

  support::TemporaryFolder folder_;
  std::string said_;
};

TEST_F(SelfCheck, AServerThatCanStartHasNoProblemAndNothingIsChanged) {
  const std::string key = keys_of("good", days(1), days(300));
  write("page/index.html", "page");
  fs::create_directory(in("recordings"));
  const auto before = all_files();
  EXPECT_EQ(check({"--port", "0", "--key", key, "--http-port", "0", "--viewer", in("page"), "--record-dir",
                   in("recordings"), "--record-key", key}),
            1)
      << "a server's key records nothing";
  EXPECT_TRUE(said("PROBLEM  recorder's key")) << said_;
  EXPECT_EQ(check({"--port", "0", "--key", key, "--http-port", "0", "--viewer", in("page")}), 0) << said_;
  EXPECT_TRUE(said("ok       key: of ward for 127.0.0.1, localhost, ::1, valid until ")) << said_;
  EXPECT_TRUE(said("ok       source: synthetic can be opened")) << said_;
  EXPECT_TRUE(said("ok       web page: ")) << said_;
  EXPECT_TRUE(said("no problem: the server can start")) << said_;
  EXPECT_EQ(all_files(), before);
}

TEST_F(SelfCheck, APortThatAnotherProgramHasIsAProblem) {
  boost::asio::io_context io;
  tcp::acceptor holder(io, {boost::asio::ip::make_address("127.0.0.1"), 0});
  const std::string port = std::to_string(holder.local_endpoint().port());
  EXPECT_EQ(check({"--port", port}), 1);
  EXPECT_TRUE(said("PROBLEM  port for stations and recorders: 127.0.0.1:" + port + ": cannot listen over TCP"))
      << said_;
  EXPECT_TRUE(said("1 problem: the server would not start")) << said_;
  holder.close();
  EXPECT_EQ(check({"--port", port}), 0) << said_;
  udp::socket images(io, {boost::asio::ip::make_address("127.0.0.1"), static_cast<std::uint16_t>(std::stoi(port))});
  EXPECT_EQ(check({"--port", port}), 1);
  EXPECT_TRUE(said("cannot listen over UDP")) << said_;
  images.close();
  EXPECT_EQ(check({"--port", port, "--health-port", port}), 1) << "two options name one port";
  EXPECT_TRUE(said("PROBLEM  port for monitoring")) << said_;
  EXPECT_EQ(check({"--port", "0", "--health-port", "0", "--health-bind", "203.0.113.9"}), 1);
  EXPECT_TRUE(said("give an address of this computer")) << said_;
}

TEST_F(SelfCheck, TheDatesOfKeysAreToldBeforeTheyEnd) {
  EXPECT_EQ(check({"--port", "0", "--key", keys_of("near", days(90), days(100))}), 0);
  EXPECT_TRUE(said("note     key: ")) << said_;
  EXPECT_TRUE(said("renew it within 9 days") || said("renew it within 10 days")) << said_;
  EXPECT_EQ(check({"--port", "0", "--key", keys_of("over", days(101), days(100))}), 1);
  EXPECT_TRUE(said("PROBLEM  key: ")) << said_;
}

TEST_F(SelfCheck, WhatIsWrongWithAKeysFilesIsAProblem) {
  EXPECT_EQ(check({"--port", "0", "--key", in("none.key")}), 1);
  EXPECT_TRUE(said("PROBLEM  key: ")) << said_;
  const std::string open = keys_of("open", days(1), days(300));
  fs::permissions(open, fs::perms::others_read, fs::perm_options::add);
  EXPECT_EQ(check({"--port", "0", "--key", open}), 1) << "everybody may read it";
  EXPECT_EQ(check({"--port", "0", "--key", keys_of("revoked", days(1), days(300), true)}), 1);
  EXPECT_TRUE(said("PROBLEM  revoked keys: ") && said("own key is revoked")) << said_;
  const std::string listless = keys_of("listless", days(1), days(300));
  fs::remove(in("listless/revoked.crl"));
  EXPECT_EQ(check({"--port", "0", "--key", listless}), 1);
  EXPECT_TRUE(said("PROBLEM  revoked keys: ")) << said_;
  const std::string old_list = keys_of("old", days(1), days(300));
  write("old/telepalp.state", "revocation-list=2\n");
  EXPECT_EQ(check({"--port", "0", "--key", old_list}), 1) << "the server has read a newer list";
  EXPECT_TRUE(said("PROBLEM  revoked keys: ") && said("is older (number 1)")) << said_;
}

TEST_F(SelfCheck, AnAuditLogThatCannotBeTrustedOrWrittenIsAProblem) {
  const std::string key = keys_of("site", days(1), days(300));
  keys::AuditPosition end;
  std::string log = keys::audit_line(end, "event=started");
  log += keys::audit_line(end, "event=stopped");
  write("site/audit.log", log);
  EXPECT_EQ(check({"--port", "0", "--key", key}), 0) << said_;
  EXPECT_TRUE(said("audit.log is whole, 2 lines in all")) << said_;
  std::string altered = log;
  altered[log.find("stopped")] = 'S';
  write("site/audit.log", altered);
  EXPECT_EQ(check({"--port", "0", "--key", key}), 1);
  EXPECT_TRUE(said("PROBLEM  audit log: ")) << said_;
  EXPECT_EQ(text_of(in("site/audit.log")), altered);
  EXPECT_EQ(check({"--port", "0", "--key", key, "--audit", in("none") / "audit.log"}), 1);
  EXPECT_TRUE(said("PROBLEM  audit log: ") && said("cannot be written")) << said_;
}

TEST_F(SelfCheck, ASourceOrAFolderThatIsNotThereIsAProblem) {
  write("page/index.html", "page");
  EXPECT_EQ(check({"--port", "0", "--source", "session:" + in("none.mcap").string()}), 1);
  EXPECT_TRUE(said("PROBLEM  source: ")) << said_;
  EXPECT_EQ(check({"--port", "0", "--http-port", "0", "--viewer", in("empty"), "--record-dir", in("none")}), 1);
  EXPECT_TRUE(said("PROBLEM  web page: ") && said("PROBLEM  recordings: ")) << said_;
  EXPECT_TRUE(said("2 problems")) << said_;
}

TEST_F(SelfCheck, AnotherServerThatCannotBeReachedIsAProblem) {
  boost::asio::io_context io;
  tcp::acceptor holder(io, {boost::asio::ip::make_address("127.0.0.1"), 0});
  const std::string open = "127.0.0.1:" + std::to_string(holder.local_endpoint().port());
  const std::string key = keys_of("site", days(1), days(300));
  EXPECT_EQ(check({"--port", "0", "--key", key, "--meet", open}), 0) << said_;
  EXPECT_TRUE(said("ok       meeting point: " + open + " takes connections")) << said_;
  holder.close();
  EXPECT_EQ(check({"--port", "0", "--key", key, "--meet", open}), 1);
  EXPECT_TRUE(said("PROBLEM  meeting point: " + open)) << said_;
  EXPECT_EQ(check({"--port", "0", "--publish", "nats://" + open + "/ward"}), 1);
  EXPECT_TRUE(said("PROBLEM  cluster: ")) << said_;
  EXPECT_EQ(check({"--port", "0", "--source", "nats://" + open + "/ward"}), 1);
  EXPECT_TRUE(said("PROBLEM  source: ")) << said_;
}

TEST_F(SelfCheck, AWrongCommandLineIsNoProblemButAnError) {
  EXPECT_EQ(check({"--port", "seven"}), 2);
  EXPECT_EQ(check({"--web-cert", "a"}), 2);
}

}  // namespace
}  // namespace telepalp::server
