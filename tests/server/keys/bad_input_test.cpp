// What hostile or broken peers, a full disk and a lack of descriptors do to a server with keys.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <random>
#include <sstream>

#include "tests/server/delay_relay.h"
#include "tests/server/keyed_site.h"

namespace telepalp::server {
namespace {

using boost::asio::ip::tcp;
using keys::Role;

/// Sends `bytes` and reads until the server closes; the time that took.
std::chrono::milliseconds time_to_close(Site& site, const std::string& bytes) {
  const auto begun = std::chrono::steady_clock::now();
  tcp::socket socket(site.io);
  socket.connect({boost::asio::ip::make_address("127.0.0.1"), site.listener->port()});
  boost::asio::write(socket, boost::asio::buffer(bytes));
  std::array<char, 4096> heard{};
  bool closed = false;
  std::function<void()> read = [&] {
    socket.async_read_some(boost::asio::buffer(heard), [&](const boost::system::error_code& code, std::size_t) {
      closed = static_cast<bool>(code);
      if (!closed) read();
    });
  };
  read();
  EXPECT_TRUE(site.run_until([&] { return closed; }, 9s));
  return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - begun);
}

/// Whether a listener between a server and its subscriber hears the word "PATIENT" of a camera message.
bool is_overheard(Site& site, std::shared_ptr<const keys::KeyFile> key) {
  DelayRelay relay(site.io, site.listener->port(), 0ms);
  KeyedClient client(site, std::move(key), "viewer", {}, "127.0.0.1", relay.port());
  EXPECT_TRUE(site.run_until([&] { return client.connected(); }));
  site.run_until([] { return false; }, 100ms);  // the subscription arrives
  site.hub.publish(message(wire::kCameraColor, "PATIENT"));
  EXPECT_TRUE(site.run_until([&] { return !client.messages.empty(); }));
  EXPECT_GT(relay.overheard().size(), 500u);
  return relay.overheard().find("PATIENT") != std::string::npos;
}

TEST(KeyedLink, WhoListensOnTheNetworkHearsNothingOfThePatient) {
  Site plain;
  EXPECT_TRUE(is_overheard(plain, nullptr)) << "so that the test can fail";
  KeyedSite sealed;
  EXPECT_FALSE(is_overheard(sealed, sealed.ring.key("vera", Role::Viewer)));
}

/// This process may open `more` further files while it lives.
struct FewDescriptors {
  rlimit before{};
  explicit FewDescriptors(rlim_t more) {
    ::getrlimit(RLIMIT_NOFILE, &before);
    const int next = ::dup(0);
    ::close(next);
    rlimit few = before;
    few.rlim_cur = static_cast<rlim_t>(next) + more;
    ::setrlimit(RLIMIT_NOFILE, &few);
  }
  ~FewDescriptors() { ::setrlimit(RLIMIT_NOFILE, &before); }
};

TEST(BadInput33, WithoutDescriptorsTheServerWaitsAndThenAcceptsAgain) {
  KeyedSite site;
  KeyedClient anna(site, site.ring.key("anna", Role::Doctor), "doctor", {wire::kStationState});
  ASSERT_TRUE(site.run_until([&] { return anna.connected(); }));
  std::vector<tcp::socket> greedy;
  {
    const FewDescriptors few(6);
    boost::system::error_code full;
    while (!full && greedy.size() < 100) {
      greedy.emplace_back(site.io);
      greedy.back().connect({boost::asio::ip::make_address("127.0.0.1"), site.listener->port()}, full);
    }
    EXPECT_TRUE(full);
    std::size_t handlers = 0;
    const auto end = std::chrono::steady_clock::now() + 500ms;
    while (std::chrono::steady_clock::now() < end) handlers += site.io.run_one_for(5ms);
    EXPECT_LT(handlers, 300u) << "it does not spin";
    EXPECT_TRUE(anna.connected());
    EXPECT_GE(site.listener->counts().refused, 1u);
    EXPECT_LE(site.listener->counts().refused, 3u) << "a pause is counted once, however often accepting is tried";
    greedy.clear();
  }
  EXPECT_NE(site.ring.audit().find("accepting pauses"), std::string::npos) << site.ring.audit();
  KeyedClient vera(site, site.ring.key("vera", Role::Viewer));
  EXPECT_TRUE(site.run_until([&] { return vera.connected(); }));
}

TEST(BadInput11, ASlowHandshakeEndsAfterFiveSecondsAndADoctorIsNotDisturbed) {
  KeyedSite site;
  KeyedClient anna(site, site.ring.key("anna", Role::Doctor), "doctor", {wire::kStationState});
  ASSERT_TRUE(site.run_until([&] { return anna.connected(); }));
  const auto took = time_to_close(site, std::string("\x16\x03\x01", 3));
  EXPECT_GT(took, 4s);
  EXPECT_LT(took, 8s);
  EXPECT_TRUE(anna.connected());
}

TEST(BadInput12, AFloodOfHandshakesHoldsNoMorePlacesThanThereAreForStrangers) {
  KeyedSite site;
  std::vector<tcp::socket> flood;
  for (int i = 0; i < 200; ++i) {
    flood.emplace_back(site.io);
    flood.back().connect({boost::asio::ip::make_address("127.0.0.1"), site.listener->port()});
    boost::asio::write(flood.back(), boost::asio::buffer("\x16", 1));
    site.io.poll();
  }
  EXPECT_LE(site.listener->peers(), hub::PlaceLimits{}.strangers + 8);
  EXPECT_GE(site.listener->counts().refused, 200 - hub::PlaceLimits{}.strangers - 8);
  EXPECT_NE(site.ring.audit().find("have not sent their Hello message yet"), std::string::npos) << site.ring.audit();
  KeyedClient anna(site, site.ring.key("anna", Role::Doctor), "doctor");
  EXPECT_TRUE(site.run_until([&] { return anna.connected(); }));
}

TEST(BadInput, DamagedTlsRecordsEndTheirConnectionAndAreAudited) {
  KeyedSite site;
  std::mt19937 random(7);
  for (int i = 0; i < 50; ++i) {
    std::string bytes("\x16\x03\x01\x01\x00", 5);
    for (int n = 0; n < 256; ++n) bytes += static_cast<char>(random());
    EXPECT_LT(time_to_close(site, bytes), 3s) << "seed 7, attempt " << i;
  }
  KeyedClient anna(site, site.ring.key("anna", Role::Doctor), "doctor");
  EXPECT_TRUE(site.run_until([&] { return anna.connected(); }));
  EXPECT_NE(site.ring.audit().find("event=refused who=stranger"), std::string::npos);
}

TEST(BadInput34, ANameWithNewlinesIsEscapedInTheAuditLog) {
  const KeyRing ring;
  const auto log = access::AuditLog::open(ring.folder.path() / "audit.log", [](const std::string&) {});
  ASSERT_TRUE(log.ok());
  (*log)->note(access::AuditEvent::Joined, "07", "program=x\nevent=took-touch\x1b[2J", ring.now);
  EXPECT_NE(ring.audit().find("program=x\\x0aevent=took-touch\\x1b[2J"), std::string::npos) << ring.audit();
}

/// No file may grow beyond `bytes` while it lives, as on a full disk.
struct FullDisk {
  rlimit before{};
  void (*handler)(int) = std::signal(SIGXFSZ, SIG_IGN);
  explicit FullDisk(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before);
    rlimit full = before;
    full.rlim_cur = bytes;
    ::setrlimit(RLIMIT_FSIZE, &full);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
  }
};

TEST(BadInput30, AFullDiskIsAnAlarmAndNeverAnEnd) {
  std::vector<std::string> said;
  const KeyRing ring;
  const auto log =
      access::AuditLog::open(ring.folder.path() / "audit.log", [&](const std::string& text) { said.push_back(text); });
  ASSERT_TRUE(log.ok());
  EXPECT_FALSE(access::AuditLog::open("/dev/full", [](const std::string&) {}).ok()) << "a device is no log";
  (*log)->note(access::AuditEvent::Started, std::nullopt, "", ring.now);
  for (const rlim_t bytes_left : {0, 10}) {  // 10: the beginning of a line still fits
    const FullDisk full(ring.audit().size() + bytes_left);
    for (int i = 0; i < 10; ++i) (*log)->note(access::AuditEvent::Joined, "07", "program=x", ring.now);
  }
  EXPECT_EQ((*log)->not_written(), 20u);
  ASSERT_EQ(said.size(), 1u);
  EXPECT_NE(said.front().find("ALARM"), std::string::npos);
  (*log)->note(access::AuditEvent::Joined, "07", "program=y", ring.now);
  EXPECT_EQ((*log)->lines(), 2u);
  EXPECT_NE(ring.audit().find("program=y not-written=20"), std::string::npos) << ring.audit();
  std::istringstream written(ring.audit());
  keys::AuditVerifier verifier;
  for (std::string line; std::getline(written, line);)
    EXPECT_TRUE(verifier.add(line).ok()) << "the chain has no break: " << line;
}

TEST(AuditLog, ADamagedOneThatCannotBeRenamedIsRefusedAndLeftAsItIs) {
  const KeyRing ring;
  const std::filesystem::path file = ring.folder.path() / std::string(250, 'a');  // FILE.damaged-1 is too long a name
  const std::string damaged = "a line without a hash\n";
  std::ofstream(file, std::ios::binary) << damaged;
  std::vector<std::string> said;
  const auto log = access::AuditLog::open(file, [&](const std::string& text) { said.push_back(text); });
  ASSERT_FALSE(log.ok());
  EXPECT_NE(log.error().what.find("cannot be renamed"), std::string::npos) << to_string(log.error());
  EXPECT_TRUE(said.empty()) << said.front();
  std::ifstream kept(file, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(kept), {}), damaged);
}

TEST(AuditLog, StrangersCannotFillTheDisk) {
  const KeyRing ring;
  const auto log = access::AuditLog::open(ring.folder.path() / "audit.log", [](const std::string&) {});
  for (int i = 0; i < 10'000; ++i) (*log)->note(access::AuditEvent::Refused, "", "who=stranger", ring.now);
  (*log)->note(access::AuditEvent::Joined, "07", "who=anna", ring.now);
  EXPECT_EQ((*log)->lines(), 21u);
  EXPECT_NE(ring.audit().find("left-out=9980"), std::string::npos) << ring.audit();
}

}  // namespace
}  // namespace telepalp::server
