#include "haptic_station/trials/figure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace telepalp::trials {
namespace {

constexpr double kLeft = 70.0;
constexpr double kRight = 885.0;
constexpr double kTop = 30.0;
constexpr double kBottom = 215.0;
constexpr int kTicks = 6;

struct Range {
  double least = 1e300;
  double most = -1e300;
  void cover(double value) {
    if (!std::isfinite(value)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  /// Never empty, so that a flat curve can be drawn.
  [[nodiscard]] Range usable() const {
    if (least > most) return {0.0, 1.0};
    const double margin = std::max(0.03 * (most - least), 1e-6);
    return {least - margin, most + margin};
  }
  [[nodiscard]] double share(double value) const { return (value - least) / (most - least); }
};

std::string format(const char* pattern, double a, double b = 0.0, double c = 0.0, double d = 0.0) {
  char text[200];
  std::snprintf(text, sizeof text, pattern, a, b, c, d);
  return text;
}

std::string text_at(double x, double y, const std::string& anchor, const std::string& text) {
  return format("<text x=\"%.1f\" y=\"%.1f\" ", x, y) + "text-anchor=\"" + anchor + "\">" + text + "</text>\n";
}

std::string polyline(const Curve& curve, const Range& x, const Range& y) {
  std::string points;
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i]))
      points += format("%.1f,%.1f ", kLeft + (kRight - kLeft) * x.share(curve.x[i]),
                       kBottom - (kBottom - kTop) * y.share(curve.y[i]));
  return "<polyline fill=\"none\" stroke-width=\"1.3\" stroke=\"" + curve.color + "\" points=\"" + points + "\"/>\n";
}

std::string axes(const Range& x, const Range& y) {
  std::string out;
  for (int i = 0; i <= kTicks; ++i) {
    const double share = static_cast<double>(i) / kTicks;
    const double at_x = kLeft + (kRight - kLeft) * share;
    const double at_y = kBottom - (kBottom - kTop) * share;
    out += format("<path d=\"M%.1f %.1fV%.1f\" stroke=\"#ddd\"/>\n", at_x, kTop, kBottom);
    out += format("<path d=\"M%.1f %.1fH%.1f\" stroke=\"#ddd\"/>\n", kLeft, at_y, kRight);
    out += text_at(at_x, kBottom + 14.0, "middle", format("%.3g", x.least + share * (x.most - x.least)));
    out += text_at(kLeft - 6.0, at_y + 4.0, "end", format("%.3g", y.least + share * (y.most - y.least)));
  }
  return out;
}

}  // namespace

std::string to_svg(const Figure& figure) {
  Range x_data;
  Range y_data;
  for (const Curve& curve : figure.curves) {
    for (const double value : curve.x) x_data.cover(value);
    for (const double value : curve.y) y_data.cover(value);
  }
  const Range x = x_data.usable();
  const Range y = y_data.usable();
  std::string out =
      "<svg viewBox=\"0 0 900 260\" width=\"900\" height=\"260\" font-family=\"sans-serif\" font-size=\"11\">\n";
  for (const Stretch& stretch : figure.stretches) {
    const double from = kLeft + (kRight - kLeft) * x.share(stretch.from);
    const double to = kLeft + (kRight - kLeft) * x.share(stretch.to);
    out += format("<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" ", from, kTop, std::max(0.0, to - from),
                  kBottom - kTop) +
           "fill=\"" + stretch.color + "\"/>\n";
  }
  out += axes(x, y);
  for (const Curve& curve : figure.curves) out += polyline(curve, x, y);
  out += text_at(kLeft, 16.0, "start", "<tspan font-weight=\"bold\">" + figure.title + "</tspan>");
  double legend_x = kRight;
  for (const Curve& curve : figure.curves) {
    out += text_at(legend_x, 16.0, "end", "<tspan fill=\"" + curve.color + "\">" + curve.name + "</tspan>");
    legend_x -= 8.0 * static_cast<double>(curve.name.size()) + 14.0;
  }
  out += text_at(0.5 * (kLeft + kRight), kBottom + 32.0, "middle", figure.x_label);
  out += "<text transform=\"translate(14 130) rotate(-90)\" text-anchor=\"middle\">" + figure.y_label + "</text>\n";
  return out + "</svg>\n";
}

}  // namespace telepalp::trials
