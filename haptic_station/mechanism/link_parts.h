#pragma once

#include <cstdint>
#include <string_view>

#include "haptic_station/mechanism/four_bar.h"
#include "haptic_station/mechanism/planar_mechanism.h"

namespace telepalp::mechanism {

/// A part of a four-bar linkage that is felt. `Base` is link 4, which is fixed: it is felt, but cannot be moved.
enum class LinkPart : std::uint8_t { Link1, Link2, Link3, Handle, Needle, Base };
inline constexpr std::size_t kLinkParts = 6;
/// `link1`, `link2`, `link3`, `handle`, `needle` or `base`.
[[nodiscard]] std::string_view name(LinkPart part) noexcept;

/// The body of a part in four_bar_design(): 1 (link 1), 2 (link 2 with the needle), 3 (link 3 with the handle), or 0,
/// the frame.
[[nodiscard]] int body_of(LinkPart part) noexcept;

/// A point on a part's axis, as a share of its length from its first end: A of link 1 and of the base, B of link 2, O
/// of link 3, D of the handle, P of the needle. `across_m`: to the left of the axis.
[[nodiscard]] BodyPoint on_part(const FourBar& bar, LinkPart part, double share, double across_m = 0.0) noexcept;

/// Sets the lengths of the mechanism of four_bar_design() to those of `bar`; all but the held point.
void set_lengths(PlanarMechanism& mechanism, const FourBar& bar) noexcept;

}  // namespace telepalp::mechanism
