#include "tools/replay/cell/wire.h"

#include "proto/impaired/impaired_link.h"

namespace telepalp::replay {
namespace {

class SimulatedWire final : public Wire {
 public:
  SimulatedWire(const impaired::Impairment& impairment, std::uint64_t seed) : link_(impairment, seed) {}

  void send(Nanoseconds now, std::span<const std::byte> datagram) override {
    link_.send(now, {.bytes = {datagram.begin(), datagram.end()}});
  }
  std::optional<std::vector<std::byte>> receive(Nanoseconds now) override {
    std::optional<impaired::Packet> packet = link_.receive(now);
    if (!packet) return std::nullopt;
    return std::move(packet->bytes);
  }
  std::uint64_t lost() const noexcept override { return link_.statistics().lost + link_.statistics().dropped; }

 private:
  impaired::ImpairedLink link_;
};

}  // namespace

Wires simulated_wires(const Scenario& scenario) {
  return {.down = std::make_unique<SimulatedWire>(scenario.down, scenario.seed + 1),
          .up = std::make_unique<SimulatedWire>(scenario.up, scenario.seed)};
}

}  // namespace telepalp::replay
