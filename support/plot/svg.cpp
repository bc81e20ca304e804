#include "support/plot/svg.h"

#include <cmath>

#include "support/plot/number.h"

namespace telepalp::plot {
namespace {

std::string attribute(std::string_view name, double value) {
  return " " + std::string(name) + "=\"" + number(value) + "\"";
}

std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + escaped(value) + "\"";
}

std::string stroke(std::string_view color, double width, std::string_view dashes) {
  return attribute("stroke", color) + attribute("stroke-width", width) +
         (dashes.empty() ? "" : attribute("stroke-dasharray", dashes));
}

}  // namespace

std::string escaped(std::string_view text) {
  std::string out;
  for (const char letter : text) {
    if (letter == '&')
      out += "&amp;";
    else if (letter == '<')
      out += "&lt;";
    else if (letter == '>')
      out += "&gt;";
    else if (letter == '"')
      out += "&quot;";
    else if (letter == '\'')
      out += "&#39;";
    else
      out += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
  }
  return out;
}

Svg::Svg(double width, double height, std::string_view title) {
  out_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(width) + " " + number(height) +
         "\" role=\"img\" font-family=\"system-ui, 'DejaVu Sans', Arial, sans-serif\">\n<title>" + escaped(title) +
         "</title>\n";
}

void Svg::line(Pixel from, Pixel to, std::string_view color, double width, std::string_view dashes) {
  out_ += "<line" + attribute("x1", from.x) + attribute("y1", from.y) + attribute("x2", to.x) + attribute("y2", to.y) +
          stroke(color, width, dashes) + "/>\n";
}

void Svg::path(const std::vector<Pixel>& points, std::string_view color, double width, std::string_view dashes) {
  std::string d;
  bool pen_down = false;
  for (const Pixel& point : points) {
    const bool finite = std::isfinite(point.x) && std::isfinite(point.y);
    if (finite) d += (pen_down ? "L" : "M") + number(point.x) + " " + number(point.y);
    pen_down = finite;
  }
  if (d.empty()) return;
  out_ += "<path fill=\"none\" stroke-linejoin=\"round\" stroke-linecap=\"round\"" + stroke(color, width, dashes) +
          attribute("d", d) + "/>\n";
}

void Svg::polygon(const std::vector<Pixel>& points, std::string_view fill, double opacity) {
  std::string list;
  for (const Pixel& point : points)
    if (std::isfinite(point.x) && std::isfinite(point.y))
      list += (list.empty() ? "" : " ") + number(point.x) + "," + number(point.y);
  if (!list.empty())
    out_ +=
        "<polygon" + attribute("fill", fill) + attribute("fill-opacity", opacity) + attribute("points", list) + "/>\n";
}

void Svg::rect(Pixel corner, Pixel opposite, std::string_view fill, double opacity) {
  out_ += "<rect" + attribute("x", std::min(corner.x, opposite.x)) + attribute("y", std::min(corner.y, opposite.y)) +
          attribute("width", std::abs(opposite.x - corner.x)) + attribute("height", std::abs(opposite.y - corner.y)) +
          attribute("fill", fill) + (opacity < 1.0 ? attribute("fill-opacity", opacity) : "") + "/>\n";
}

void Svg::disc(Pixel centre, double radius, std::string_view fill) {
  if (!std::isfinite(centre.x) || !std::isfinite(centre.y)) return;
  out_ += "<circle" + attribute("cx", centre.x) + attribute("cy", centre.y) + attribute("r", radius) +
          attribute("fill", fill) + "/>\n";
}

void Svg::text(Pixel at, std::string_view words, Anchor anchor, double size, std::string_view color, bool bold,
               bool upright) {
  constexpr std::string_view kAnchors[] = {"start", "middle", "end"};
  out_ += "<text" + attribute("x", at.x) + attribute("y", at.y) + attribute("font-size", size) +
          attribute("fill", color) + attribute("text-anchor", kAnchors[static_cast<int>(anchor)]) +
          (bold ? " font-weight=\"600\"" : "") +
          (upright ? "" : " transform=\"rotate(-90 " + number(at.x) + " " + number(at.y) + ")\"") + ">" +
          escaped(words) + "</text>\n";
}

std::string Svg::finish() && { return std::move(out_) + "</svg>\n"; }

}  // namespace telepalp::plot
