#include "haptic_station/device/protocol/udp_device.h"

#include "proto/words/little_endian.h"

namespace telepalp::device::udp {
namespace {

using Eigen::Vector3d;

constexpr std::uint32_t kMagicDown = 0x4450'5454;  // "TTPD"
constexpr std::uint32_t kMagicUp = 0x5550'5454;    // "TTPU"
constexpr std::uint16_t kInBody = 1;
constexpr std::uint16_t kSurfaceValid = 2;
constexpr std::uint16_t kLetGo = 4;
constexpr std::uint16_t kFaulted = 1;
constexpr std::uint16_t kAttitudeMeasured = 2;
constexpr std::uint16_t kPressed = 4;
constexpr double kFurthest_m = 2.0;
constexpr double kFastest_m_per_s = 50.0;
constexpr double kStrongest_N = 100.0;
constexpr double kStrongest_N_m = 10.0;
constexpr double kFastest_rad_per_s = 200.0;
constexpr std::size_t kSumBytes = 4;

std::size_t command_bytes(std::uint16_t version) noexcept { return version == kVersion2 ? 132 : 108; }
std::size_t pose_bytes(std::uint16_t version) noexcept { return version == kVersion2 ? 152 : 80; }

/// Writes little-endian numbers, one behind the other.
class Writer {
 public:
  explicit Writer(std::span<std::byte> bytes) noexcept : bytes_(bytes) {}
  template <class Number>
  void put(Number value) noexcept {
    put_little_endian<Number>(&bytes_[at_], value);
    at_ += sizeof value;
  }
  void put(const Vector3d& v) noexcept {
    for (int i = 0; i < 3; ++i) put(v[i]);
  }

 private:
  std::span<std::byte> bytes_;
  std::size_t at_ = 0;
};

class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}
  template <class Number>
  [[nodiscard]] Number get() noexcept {
    const auto value = get_little_endian<Number>(&bytes_[at_]);
    at_ += sizeof value;
    return value;
  }
  [[nodiscard]] double number() noexcept { return get<double>(); }
  [[nodiscard]] Vector3d three() noexcept {
    const double x = number();
    const double y = number();
    return {x, y, number()};
  }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

/// Check sum (Adler-32) over all bytes before it. UDP's own check sum is optional, and some embedded network stacks do
/// not send it.
std::uint32_t sum_of(std::span<const std::byte> bytes) noexcept {
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const std::byte byte : bytes) {
    a = (a + std::to_integer<std::uint32_t>(byte)) % 65521;  // Adler-32
    b = (b + a) % 65521;
  }
  return (b << 16) | a;
}

void seal(std::span<std::byte> datagram) noexcept {
  Writer(datagram.last(kSumBytes)).put(sum_of(datagram.first(datagram.size() - kSumBytes)));
}

/// The version that the datagram states; nullopt: wrong magic, an unknown version, a wrong size for it, or a wrong sum.
std::optional<std::uint16_t> version_of(std::span<const std::byte> datagram, std::uint32_t magic,
                                        std::size_t (*bytes)(std::uint16_t) noexcept) noexcept {
  if (datagram.size() < bytes(kVersion1)) return std::nullopt;
  Reader in(datagram);
  if (in.get<std::uint32_t>() != magic) return std::nullopt;
  const auto version = in.get<std::uint16_t>();
  if (version != kVersion1 && version != kVersion2) return std::nullopt;
  if (datagram.size() != bytes(version)) return std::nullopt;
  const std::uint32_t sum = sum_of(datagram.first(datagram.size() - kSumBytes));
  return Reader(datagram.last(kSumBytes)).get<std::uint32_t>() == sum ? std::optional(version) : std::nullopt;
}

bool within(const Vector3d& v, double most) noexcept { return v.allFinite() && v.cwiseAbs().maxCoeff() <= most; }
bool within(double v, double most) noexcept { return v >= -most && v <= most; }

bool is_sane(const ports::DevicePower& power) noexcept {
  return power.most_N >= 0.0 && power.most_N <= kStrongest_N && power.most_N_m >= 0.0 &&
         power.most_N_m <= kStrongest_N_m;
}

bool is_sane(const Command& c) noexcept {
  return within(c.proxy.m, kFurthest_m) && within(c.distance_m, kFurthest_m) && within(c.normal.v, 1.001) &&
         within(c.force.N, kStrongest_N) && within(c.torque.N_m, kStrongest_N_m);
}

bool is_sane(const Pose& pose) noexcept {
  return within(pose.end_effector.m, kFurthest_m) && within(pose.velocity.v, kFastest_m_per_s) &&
         within(pose.turning.v, kFastest_rad_per_s) && (pose.version == kVersion1 || is_sane(pose.power));
}

}  // namespace

Datagram encode(const Command& wanted) noexcept {
  Command c = wanted;
  if (!is_sane(c)) {
    c.proxy = {};
    c.distance_m = 0.0;
    c.normal = {};
    c.in_body = c.surface_valid = false;
    c.let_go = true;
  }
  if (c.let_go) c.force = {};
  if (c.let_go) c.torque = {};
  Datagram bytes(command_bytes(c.version));
  Writer out(bytes);
  out.put(kMagicDown);
  out.put(c.version);
  out.put(static_cast<std::uint16_t>((c.in_body ? kInBody : 0) | (c.surface_valid ? kSurfaceValid : 0) |
                                     (c.let_go ? kLetGo : 0)));
  out.put(c.session);
  out.put(c.sequence);
  out.put(c.sent_us);
  out.put(c.proxy.m);
  out.put(c.distance_m);
  out.put(c.normal.v);
  out.put(c.force.N);
  if (c.version == kVersion2) out.put(c.torque.N_m);
  seal(bytes);
  return bytes;
}

Datagram encode(const Pose& pose) noexcept {
  Datagram bytes(pose_bytes(pose.version));
  Writer out(bytes);
  out.put(kMagicUp);
  out.put(pose.version);
  out.put(static_cast<std::uint16_t>((pose.faulted ? kFaulted : 0) |
                                     (pose.attitude && pose.version == kVersion2 ? kAttitudeMeasured : 0) |
                                     (pose.pressed ? kPressed : 0)));
  out.put(pose.session);
  out.put(pose.sequence);
  out.put(pose.taken_us);
  out.put(pose.heard);
  out.put(pose.end_effector.m);
  out.put(pose.velocity.v);
  if (pose.version == kVersion2) {
    const Eigen::Quaterniond attitude = pose.attitude.value_or(Eigen::Quaterniond::Identity());
    out.put(Vector3d(attitude.vec()));
    out.put(attitude.w());
    out.put(pose.turning.v);
    out.put(pose.power.most_N);
    out.put(pose.power.most_N_m);
  }
  seal(bytes);
  return bytes;
}

std::optional<Command> decode_command(std::span<const std::byte> datagram) noexcept {
  const auto version = version_of(datagram, kMagicDown, command_bytes);
  if (!version) return std::nullopt;
  Reader in(datagram.subspan(6));
  const auto flags = in.get<std::uint16_t>();
  Command c;
  c.version = *version;
  c.session = in.get<std::uint32_t>();
  c.sequence = in.get<std::uint32_t>();
  c.sent_us = in.get<std::uint64_t>();
  c.in_body = (flags & kInBody) != 0;
  c.surface_valid = (flags & kSurfaceValid) != 0;
  c.let_go = (flags & kLetGo) != 0;
  c.proxy.m = in.three();
  c.distance_m = in.number();
  c.normal.v = in.three();
  c.force.N = in.three();
  if (c.version == kVersion2) c.torque.N_m = in.three();
  const bool known = (flags & ~(kInBody | kSurfaceValid | kLetGo)) == 0;
  return known && is_sane(c) ? std::optional(c) : std::nullopt;
}

std::optional<Pose> decode_pose(std::span<const std::byte> datagram) noexcept {
  const auto version = version_of(datagram, kMagicUp, pose_bytes);
  if (!version) return std::nullopt;
  Reader in(datagram.subspan(6));
  const auto flags = in.get<std::uint16_t>();
  Pose pose;
  pose.version = *version;
  pose.session = in.get<std::uint32_t>();
  pose.sequence = in.get<std::uint32_t>();
  pose.taken_us = in.get<std::uint64_t>();
  pose.heard = in.get<std::uint32_t>();
  pose.faulted = (flags & kFaulted) != 0;
  pose.pressed = (flags & kPressed) != 0;
  pose.end_effector.m = in.three();
  pose.velocity.v = in.three();
  if (pose.version == kVersion2) {
    const Vector3d xyz = in.three();
    const double w = in.number();
    if ((flags & kAttitudeMeasured) != 0) pose.attitude = Eigen::Quaterniond(w, xyz.x(), xyz.y(), xyz.z());
    pose.turning.v = in.three();
    pose.power.most_N = in.number();
    pose.power.most_N_m = in.number();
  }
  const int known = kFaulted | kPressed | (pose.version == kVersion2 ? kAttitudeMeasured : 0);
  return is_sane(pose) && (flags & ~known) == 0 ? std::optional(pose) : std::nullopt;
}

PoseOrder::Verdict PoseOrder::judge(const Pose& pose) noexcept {
  if (newest_ && pose.session == newest_->session) {
    const auto ahead = static_cast<std::int32_t>(pose.sequence - newest_->sequence);  // also across a wrap-around
    if (ahead <= 0) return Verdict::Repeated;
    if (pose.taken_us <= newest_->taken_us) return Verdict::ClockStands;
  } else if (newest_) {
    if (has_session_before_ && pose.session == session_before_) return Verdict::OldSession;
    session_before_ = newest_->session;
    has_session_before_ = true;
  }
  newest_ = pose;
  return Verdict::Newest;
}

}  // namespace telepalp::device::udp
