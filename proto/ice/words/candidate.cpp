#include "proto/ice/words/candidate.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace telepalp::ice {
namespace {

constexpr std::string_view kPrefix = "candidate:";
constexpr std::size_t kMostFoundation = 32;
constexpr std::size_t kMostCredential = 256;
constexpr std::array<std::pair<Candidate::Kind, std::string_view>, 3> kKinds{
    {{Candidate::Kind::Host, "host"}, {Candidate::Kind::Reflexive, "srflx"}, {Candidate::Kind::Relayed, "relay"}}};

bool is_ice_char(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '+' || c == '/';
}

bool is_ice_text(std::string_view text, std::size_t least, std::size_t most) {
  return text.size() >= least && text.size() <= most && std::ranges::all_of(text, is_ice_char);
}

/// The words of `text` between single spaces; nullopt: not exactly N.
template <std::size_t N>
std::optional<std::array<std::string_view, N>> words_of(std::string_view text) {
  std::array<std::string_view, N> words{};
  for (std::size_t i = 0; i < N; ++i) {
    const std::size_t space = text.find(' ');
    if ((space == std::string_view::npos) != (i + 1 == N)) return std::nullopt;
    words[i] = text.substr(0, space);
    if (words[i].empty()) return std::nullopt;
    text.remove_prefix(std::min(text.size(), words[i].size() + 1));
  }
  return words;
}

template <class Number>
bool read(std::string_view text, Number& into) {
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), into);
  return failed == std::errc{} && end == text.data() + text.size();
}

std::optional<Candidate::Kind> kind_named(std::string_view name) {
  for (const auto& [kind, word] : kKinds)
    if (word == name) return kind;
  return std::nullopt;
}

bool may_check(const boost::asio::ip::address_v4& address, Reach reach) {
  if (address.is_loopback()) return reach == Reach::Loopback;
  const std::uint32_t number = address.to_uint();
  const bool this_network = number >> 24U == 0;
  const bool link_local = number >> 16U == 0xA9FE;  // 169.254.0.0/16, also where clouds tell their computers secrets
  const bool reserved = number >> 28U >= 0xE;       // multicast, reserved, broadcast
  return !this_network && !link_local && !reserved;
}

bool may_check(const boost::asio::ip::address_v6& address, Reach reach) {
  if (address.scope_id() != 0) return false;  // names a network card of the computer that wrote it
  if (address.is_loopback()) return reach == Reach::Loopback;
  const auto bytes = address.to_bytes();
  const bool holds_v4 = std::all_of(bytes.begin(), bytes.begin() + 8, [](unsigned char byte) { return byte == 0; });
  const bool nat64 = bytes[0] == 0x00 && bytes[1] == 0x64 && bytes[2] == 0xFF && bytes[3] == 0x9B;
  const bool six_to_four = bytes[0] == 0x20 && bytes[1] == 0x02;
  return !address.is_unspecified() && !address.is_link_local() && !address.is_multicast() && !holds_v4 && !nat64 &&
         !six_to_four;
}

}  // namespace

bool may_check(const boost::asio::ip::address& address, Reach reach) {
  return address.is_v4() ? may_check(address.to_v4(), reach) : may_check(address.to_v6(), reach);
}

std::optional<Candidate> read_candidate(std::string_view text, Reach reach) {
  if (text.size() > kMostCandidateBytes || !text.starts_with(kPrefix)) return std::nullopt;
  const auto words = words_of<8>(text.substr(kPrefix.size()));
  if (!words) return std::nullopt;
  const auto& [foundation, component, transport, priority, address, port, typ, type] = *words;
  if (!is_ice_text(foundation, 1, kMostFoundation) || component != "1" || transport != "udp" || typ != "typ")
    return std::nullopt;
  Candidate read_one{.foundation = std::string(foundation), .address = {}};
  boost::system::error_code no_address;
  read_one.address = boost::asio::ip::make_address(std::string(address), no_address);
  const std::optional<Candidate::Kind> kind = kind_named(type);
  if (!read(priority, read_one.priority) || !read(port, read_one.port) || read_one.port == 0 || no_address || !kind ||
      !may_check(read_one.address, reach))
    return std::nullopt;
  read_one.kind = *kind;
  return read_one;
}

std::string to_text(const Candidate& candidate) {
  const auto* const kind = std::ranges::find(kKinds, candidate.kind, [](const auto& entry) { return entry.first; });
  return std::string(kPrefix) + candidate.foundation + " 1 udp " + std::to_string(candidate.priority) + " " +
         candidate.address.to_string() + " " + std::to_string(candidate.port) + " typ " + std::string(kind->second);
}

bool is_credential(std::string_view text, std::size_t least) { return is_ice_text(text, least, kMostCredential); }

}  // namespace telepalp::ice
