#include "proto/wire/datagrams/images_way.h"

namespace telepalp::wire {
namespace {

constexpr std::string_view kOverTcp = "no UDP datagram arrives: the images come over TCP";
constexpr std::string_view kByDatagram = "the images come by sealed datagrams";
constexpr std::string_view kToThePort = " (UDP)", kAlongAWay = ", ";

}  // namespace

std::string images_come_over_tcp() { return std::string(kOverTcp); }

std::string images_come_by_datagram(std::string_view way) {
  return std::string(kByDatagram) + std::string(way.empty() ? kToThePort : kAlongAWay) + std::string(way);
}

std::optional<std::string> way_of_images(std::string_view text) {
  if (text == kOverTcp) return "over TCP";
  if (!text.starts_with(kByDatagram)) return std::nullopt;
  text.remove_prefix(kByDatagram.size());
  if (text == kToThePort) return "by datagrams to the server's UDP port";
  if (!text.starts_with(kAlongAWay)) return std::nullopt;
  return "by datagrams " + std::string(text.substr(kAlongAWay.size()));
}

}  // namespace telepalp::wire
