#include "tests/bench/link/tcp_run.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/if_tun.h>
#include <net/if.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <fstream>
#include <map>
#include <thread>
#include <utility>

#include "proto/impaired/impaired_link.h"
#include "tests/bench/link/camera_feed.h"
#include "tests/bench/link/plain_address.h"
#include "tests/bench/link/real_time_priority.h"

namespace telepalp::bench::link {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr std::uint16_t kPort = 7400;
constexpr int kPacket_B = 1228;         ///< a datagram of telepalp with its headers
constexpr int kUnsent_B = 128 * 1024;   ///< as proto/wire sets it
constexpr Nanoseconds kPatience = 10s;  ///< to connect
constexpr char kInterface[] = "path";
constexpr const char* kServer = "10.77.0.1";
constexpr const char* kClient = "10.77.0.2";

class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(Descriptor&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  [[nodiscard]] int get() const noexcept { return fd_; }
  [[nodiscard]] bool is_open() const noexcept { return fd_ >= 0; }

 private:
  int fd_ = -1;
};

sockaddr_in address_of(const char* text, std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  inet_pton(AF_INET, text, &address.sin_addr);
  return address;
}

/// A network namespace with one interface, whose packets are read from and written to `tun`, and one TCP socket.
struct End {
  Descriptor tun;
  Descriptor tcp;
};

ifreq request_about_interface() {
  ifreq request{};
  std::memcpy(request.ifr_name, kInterface, sizeof kInterface);
  return request;
}

bool bring_up(const Descriptor& socket, const char* address) {
  ifreq request = request_about_interface();
  const auto set = [&](unsigned long what) { return ::ioctl(socket.get(), what, &request) == 0; };
  const auto set_address = [&](unsigned long what, const char* text) {
    const sockaddr_in value = address_of(text, 0);
    std::memcpy(&request.ifr_addr, &value, sizeof value);
    return set(what);
  };
  if (!set_address(SIOCSIFADDR, address) || !set_address(SIOCSIFNETMASK, "255.255.255.0")) return false;
  request.ifr_mtu = kPacket_B;
  if (!set(SIOCSIFMTU)) return false;
  request.ifr_flags = IFF_UP | IFF_RUNNING;
  return set(SIOCSIFFLAGS);
}

/// On a thread of its own, which alone enters the namespace; the descriptors keep the namespace.
std::optional<End> make_end(const char* address) {
  std::optional<End> made;
  std::thread([&] {
    if (::unshare(CLONE_NEWNET) != 0) return;
    End end{Descriptor(::open("/dev/net/tun", O_RDWR | O_NONBLOCK)),
            Descriptor(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0))};
    ifreq request = request_about_interface();
    request.ifr_flags = IFF_TUN | IFF_NO_PI;
    if (!end.tun.is_open() || ::ioctl(end.tun.get(), TUNSETIFF, &request) != 0) return;
    if (bring_up(end.tcp, address)) made = std::move(end);
  }).join();
  return made;
}

struct Label {
  std::uint32_t number;
  std::uint32_t image;
  std::uint64_t image_B;
};

class TcpRun {
 public:
  TcpRun(const Scenario& scenario, End server, End client)
      : down_(scenario.down, scenario.seed),
        up_(scenario.up, scenario.seed + 1),
        frames_hz_(scenario.frames_hz),
        feed_(scenario),
        server_(std::move(server)),
        client_(std::move(client)) {}

  std::optional<Outcome> outcome() {
    if (!connect()) return std::nullopt;
    const double before_B = static_cast<double>(down_.statistics().sent_bytes);
    camera_from_ = since_start();
    Nanoseconds sampled{0};
    for (Nanoseconds now{0}; !feed_.finished(now); now = since_start() - camera_from_) {
      for (CameraImage& image : feed_.due(now)) waiting_.insert_or_assign(image.image, std::move(image));
      send();
      receive(now);
      for (; sampled <= now; sampled += 1ms) feed_.sample_age(now);
      carry();
    }
    feed_.outcome().sent_B = static_cast<double>(down_.statistics().sent_bytes) - before_B;
    return feed_.outcome();
  }

 private:
  [[nodiscard]] Nanoseconds since_start() const { return Clock::now() - start_; }

  bool connect() {
    const int yes = 1;
    const sockaddr_in at = address_of(kServer, kPort);
    if (::bind(server_.tcp.get(), plain(at), sizeof at) != 0 || ::listen(server_.tcp.get(), 1) != 0) return false;
    (void)::connect(client_.tcp.get(), plain(at), sizeof at);
    while (!sender_.is_open() && since_start() < kPatience) {
      carry();
      sender_ = Descriptor(::accept4(server_.tcp.get(), nullptr, nullptr, SOCK_NONBLOCK));
    }
    ::setsockopt(sender_.get(), IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    ::setsockopt(sender_.get(), IPPROTO_TCP, TCP_NOTSENT_LOWAT, &kUnsent_B, sizeof kUnsent_B);
    return sender_.is_open();
  }
  /// Waits for packets for at most a quarter of a millisecond, and carries those that are due.
  void carry() {
    std::array<pollfd, 2> ready{pollfd{server_.tun.get(), POLLIN, 0}, pollfd{client_.tun.get(), POLLIN, 0}};
    const timespec patience{0, 250'000};
    (void)::ppoll(ready.data(), ready.size(), &patience, nullptr);
    carry(server_.tun, down_, client_.tun);
    carry(client_.tun, up_, server_.tun);
  }
  void carry(const Descriptor& from, impaired::ImpairedLink& over, const Descriptor& to) {
    std::array<std::byte, 2048> packet{};
    for (ssize_t size = 0; (size = ::read(from.get(), packet.data(), packet.size())) > 0;)
      over.send(since_start(), {.bytes = {packet.begin(), packet.begin() + size}});
    while (const auto arrived = over.receive(since_start()))
      (void)!::write(to.get(), arrived->bytes.data(), arrived->bytes.size());
  }
  void send() {
    for (;;) {
      pollfd room{sender_.get(), POLLOUT, 0};
      if (sending_.empty() && !waiting_.empty() && ::poll(&room, 1, 0) == 1) begin_next();
      if (sending_.empty()) return;
      const ssize_t sent = ::send(sender_.get(), sending_.data(), sending_.size(), MSG_NOSIGNAL);
      if (sent <= 0) return;
      sending_.erase(sending_.begin(), sending_.begin() + sent);
    }
  }
  void begin_next() {
    const CameraImage image = std::move(waiting_.extract(waiting_.begin()).mapped());
    const Label label{image.number, image.image, image.bytes.size()};
    sending_.resize(sizeof label);
    std::memcpy(sending_.data(), &label, sizeof label);
    sending_.insert(sending_.end(), image.bytes.begin(), image.bytes.end());
  }
  void receive(Nanoseconds now) {
    std::array<std::byte, 65'536> part{};
    for (ssize_t got = 0; (got = ::recv(client_.tcp.get(), part.data(), part.size(), 0)) > 0;)
      received_.insert(received_.end(), part.begin(), part.begin() + got);
    for (Label label{}; received_.size() >= sizeof label;) {
      std::memcpy(&label, received_.data(), sizeof label);
      if (received_.size() < sizeof label + label.image_B) return;
      received_.erase(received_.begin(), received_.begin() + static_cast<std::ptrdiff_t>(sizeof label + label.image_B));
      feed_.complete(static_cast<Image>(label.image), label.number, from_seconds(label.number / frames_hz_),
                     label.image_B, now);
    }
  }

  const Clock::time_point start_ = Clock::now();
  impaired::ImpairedLink down_;
  impaired::ImpairedLink up_;
  double frames_hz_;
  CameraFeed feed_;
  End server_;
  End client_;
  Descriptor sender_;
  Nanoseconds camera_from_{0};
  std::map<Image, CameraImage> waiting_;
  std::vector<std::byte> sending_;
  std::vector<std::byte> received_;
};

}  // namespace

std::optional<Outcome> run_kernel_tcp(const Scenario& scenario) {
  const RealTimePriority priority;
  std::optional<End> server = make_end(kServer);
  std::optional<End> client = make_end(kClient);
  if (!server || !client) return std::nullopt;
  return TcpRun(scenario, std::move(*server), std::move(*client)).outcome();
}

std::string kernel_congestion_control() {
  std::ifstream file("/proc/sys/net/ipv4/tcp_congestion_control");
  std::string name = "unknown";
  file >> name;
  return name;
}

}  // namespace telepalp::bench::link
