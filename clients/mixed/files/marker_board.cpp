#include "clients/mixed/files/marker_board.h"

#include <cstdio>

namespace telepalp::mixed {
namespace {

constexpr int kCells = 6;          // 4 bits and a black border
constexpr double kEdge_mm = 12.0;  // white around the board

std::string rectangle(double x, double y, double width, double height, const char* color) {
  char text[160];
  std::snprintf(text, sizeof text, "<rect x=\"%.3f\" y=\"%.3f\" width=\"%.3f\" height=\"%.3f\" fill=\"%s\"/>\n", x, y,
                width, height, color);
  return text;
}

double width_mm(double marker_mm) { return marker_mm * (kBoardColumns + (kBoardColumns - 1) * kBoardGap); }
double height_mm(double marker_mm) { return marker_mm * (kBoardRows + (kBoardRows - 1) * kBoardGap); }

std::string marker(std::uint16_t bits, double x, double y, double side_mm) {
  const double cell = side_mm / kCells;
  std::string text = rectangle(x, y, side_mm, side_mm, "black");
  for (int i = 0; i < 16; ++i)
    if ((bits >> (15 - i) & 1) != 0)
      text += rectangle(x + cell * (1 + i % 4), y + cell * (1 + i / 4), cell, cell, "white");
  return text;
}

}  // namespace

std::string board_svg(double marker_mm) {
  const double width = width_mm(marker_mm) + 2 * kEdge_mm, height = height_mm(marker_mm) + 3 * kEdge_mm;
  char head[240];
  std::snprintf(
      head, sizeof head,
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.3fmm\" height=\"%.3fmm\" viewBox=\"0 0 %.3f %.3f\" "
      "shape-rendering=\"crispEdges\">\n",
      width, height, width, height);
  std::string text = head + rectangle(0, 0, width, height, "white");
  for (std::size_t i = 0; i < kMarkers.size(); ++i)
    text += marker(kMarkers[i], kEdge_mm + static_cast<double>(i % kBoardColumns) * (1 + kBoardGap) * marker_mm,
                   kEdge_mm + static_cast<double>(i / kBoardColumns) * (1 + kBoardGap) * marker_mm, marker_mm);
  text += rectangle(kEdge_mm, height - 1.5 * kEdge_mm, 100.0, 0.5, "black");
  char note[200];
  std::snprintf(
      note, sizeof note,
      "<text x=\"%.3f\" y=\"%.3f\" font-size=\"4\" font-family=\"sans-serif\">the line is 100 mm long, a marker "
      "%.4g mm; print at 100 %%</text>\n",
      kEdge_mm, height - 0.8 * kEdge_mm, marker_mm);
  return text + note + "</svg>\n";
}

std::string board_table(double marker_mm) {
  std::string text = "marker,corner,x_m,y_m,z_m\n";
  for (std::size_t i = 0; i < kMarkers.size(); ++i)
    for (int corner = 0; corner < 4; ++corner) {
      const double right = corner == 1 || corner == 2 ? 1.0 : 0.0, low = corner >= 2 ? 1.0 : 0.0;
      const double column = static_cast<double>(i % kBoardColumns), row = static_cast<double>(i / kBoardColumns);
      const double x = (column * (1 + kBoardGap) + right) * marker_mm - 0.5 * width_mm(marker_mm);
      const double y = 0.5 * height_mm(marker_mm) - (row * (1 + kBoardGap) + low) * marker_mm;
      char line[80];
      std::snprintf(line, sizeof line, "%zu,%d,%.6f,%.6f,0\n", i, corner, x * 1e-3, y * 1e-3);
      text += line;
    }
  return text;
}

}  // namespace telepalp::mixed
