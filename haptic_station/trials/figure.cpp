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
constexpr double kMostTicks = 8.0;

struct Range {
  double least = 1e300;
  double most = -1e300;
  void cover(double value) {
    if (!std::isfinite(value)) return;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  /// The range, widened if it is empty, so that a flat curve can be drawn.
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

/// The smallest step of 1, 2 or 5 times a power of ten that divides `length` into at most kMostTicks parts.
double round_step(double length) {
  const double least = length / kMostTicks;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * decade >= least) return factor * decade;
  return 10.0 * decade;
}

/// Calls `draw` with each round number within the range.
template <class Draw>
void for_each_tick(const Range& range, Draw draw) {
  const double step = round_step(range.most - range.least);
  for (double count = std::ceil(range.least / step); count * step <= range.most; ++count)
    draw(count == 0.0 ? 0.0 : count * step);  // never -0
}

std::string axes(const Range& x, const Range& y) {
  std::string out;
  for_each_tick(x, [&](double value) {
    const double at = kLeft + (kRight - kLeft) * x.share(value);
    out += format("<path d=\"M%.1f %.1fV%.1f\" stroke=\"#ddd\"/>\n", at, kTop, kBottom);
    out += text_at(at, kBottom + 14.0, "middle", format("%.6g", value));
  });
  for_each_tick(y, [&](double value) {
    const double at = kBottom - (kBottom - kTop) * y.share(value);
    out += format("<path d=\"M%.1f %.1fH%.1f\" stroke=\"#ddd\"/>\n", kLeft, at, kRight);
    out += text_at(kLeft - 6.0, at + 4.0, "end", format("%.6g", value));
  });
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
