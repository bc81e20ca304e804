#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace telepalp::mixed {

/// A board of 6 x 4 markers of OpenCV's dictionary DICT_4X4_50, numbered by rows from the upper left. Any program that
/// reads ArUco markers finds it. The pose of one marker flips between two solutions; that of a board of 24 does
/// not.
inline constexpr int kBoardColumns = 6;
inline constexpr int kBoardRows = 4;
inline constexpr double kBoardGap = 0.2;  ///< between markers, as a share of a marker's side

/// The 4 x 4 bits of each marker, row by row from the most significant bit; 1 is white.
inline constexpr std::array<std::uint16_t, kBoardColumns * kBoardRows> kMarkers{
    181U << 8U | 50U, 15U << 8U | 154U,  51U << 8U | 45U,   153U << 8U | 70U, 84U << 8U | 158U,  121U << 8U | 205U,
    158U << 8U | 46U, 196U << 8U | 242U, 254U << 8U | 218U, 207U << 8U | 86U, 249U << 8U | 145U, 17U << 8U | 167U,
    14U << 8U | 183U, 42U << 8U | 15U,   36U << 8U | 177U,  38U << 8U | 62U,  70U << 8U | 101U,  102U << 8U | 0U,
    108U << 8U | 94U, 118U << 8U | 175U, 134U << 8U | 139U, 176U << 8U | 43U, 204U << 8U | 213U, 221U << 8U | 130U};

/// The board as SVG in millimetres, with a line of 100 mm to check the printer's scale. `marker_mm`: side of a marker.
[[nodiscard]] std::string board_svg(double marker_mm);

/// The markers' corners in the world's frame [m]: the origin is the board's middle, x to its right, y up on the page, z
/// out of it. Corners clockwise from the upper left, as ArUco counts them.
[[nodiscard]] std::string board_table(double marker_mm);

}  // namespace telepalp::mixed
