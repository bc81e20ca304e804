#include "haptic_station/tracking/hand_trace.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>

#include "haptic_station/tracking/hand_axes.h"
#include "proto/words/number_word.h"
#include "proto/words/numbers/number_row.h"

namespace telepalp::tracking {
namespace {

constexpr std::uintmax_t kMostBytes = 64u << 20;

std::vector<std::string_view> fields(std::string_view line) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  std::vector<std::string_view> out;
  for (std::size_t start = 0;;) {
    const std::size_t comma = line.find(',', start);
    out.push_back(line.substr(start, comma == std::string_view::npos ? comma : comma - start));
    if (comma == std::string_view::npos) return out;
    start = comma + 1;
  }
}

enum Column { kTime, kX, kY, kZ, kVx, kVy, kVz, kHand, kQx, kQy, kQz, kQw, kNx, kNy, kNz, kDx, kDy, kDz, kColumns };
constexpr std::array<std::string_view, kColumns> kNames = {
    "timestamp_us", "palm_x_mm", "palm_y_mm", "palm_z_mm", "vel_x_mm_s", "vel_y_mm_s", "vel_z_mm_s", "hand_id", "qx",
    "qy",           "qz",        "qw",        "nx",        "ny",         "nz",         "dx",         "dy",      "dz"};

using Columns = std::array<std::optional<std::size_t>, kColumns>;

Columns find_columns(std::string_view header) {
  Columns columns;
  const std::vector<std::string_view> names = fields(header);
  for (std::size_t i = 0; i < names.size(); ++i)
    for (std::size_t c = 0; c < kColumns; ++c)
      if (names[i] == kNames[c]) columns[c] = i;
  return columns;
}

/// The field as a finite number.
std::optional<double> number(const std::vector<std::string_view>& row, std::optional<std::size_t> column) {
  if (!column || *column >= row.size()) return std::nullopt;
  return finite_number_of(row[*column]);
}

struct ParsedRow {
  double time_us;
  double hand;
  TraceSample sample;
};

using Numbers = std::array<std::optional<double>, kColumns>;

bool has_all(const Numbers& n, Column first, int count) {
  return std::all_of(n.begin() + first, n.begin() + first + count, [](const auto& one) { return one.has_value(); });
}

std::optional<Eigen::Quaterniond> attitude_of(const Numbers& n) {
  if (has_all(n, kQx, 4)) {
    const Eigen::Quaterniond q(*n[kQw], *n[kQx], *n[kQy], *n[kQz]);
    if (std::abs(q.norm() - 1.0) < 0.01) return q.normalized();
  }
  if (!has_all(n, kNx, 6)) return std::nullopt;
  return hand_axes({*n[kDx], *n[kDy], *n[kDz]}, {*n[kNx], *n[kNy], *n[kNz]});
}

std::optional<ParsedRow> parse_row(const std::vector<std::string_view>& row, const Columns& columns) {
  Numbers n;
  for (std::size_t c = 0; c < kColumns; ++c) n[c] = number(row, columns[c]);
  constexpr double kFurthest_mm = 10'000.0;
  for (const Column c : {kTime, kX, kY, kZ})
    if (!n[c]) return std::nullopt;
  for (const Column c : {kX, kY, kZ})
    if (std::abs(*n[c]) > kFurthest_mm) return std::nullopt;
  if (std::abs(*n[kTime]) > 9e15) return std::nullopt;  // beyond it a double cannot represent single microseconds
  ParsedRow parsed{.time_us = *n[kTime], .hand = n[kHand].value_or(0.0), .sample = {}};
  parsed.sample.palm.m = Eigen::Vector3d{*n[kX], *n[kY], *n[kZ]} * 1e-3;
  if (n[kVx] && n[kVy] && n[kVz]) parsed.sample.velocity.v = Eigen::Vector3d{*n[kVx], *n[kVy], *n[kVz]} * 1e-3;
  parsed.sample.attitude = attitude_of(n);
  return parsed;
}

}  // namespace

Result<HandTrace> parse_hand_trace(std::string_view text, std::string_view name) {
  const Columns columns = find_columns(take_line(text));
  for (const Column c : {kTime, kX, kY, kZ})
    if (!columns[c])
      return Error{.what = "there is no column " + std::string(kNames[c]),
                   .where = std::string(name) + ":1",
                   .fix = "give a CSV with timestamp_us, palm_x_mm, palm_y_mm and palm_z_mm in its first row"};
  HandTrace trace;
  std::optional<ParsedRow> first;
  double last_us = 0.0;
  while (!text.empty()) {
    const std::string_view line = take_line(text);
    if (line.empty()) continue;
    std::optional<ParsedRow> row = parse_row(fields(line), columns);
    if (!row || (first && (row->hand != first->hand || row->time_us <= last_us))) {
      ++trace.skipped;
      continue;
    }
    if (!first) first = row;
    last_us = row->time_us;
    row->sample.at = SessionTime{from_seconds((row->time_us - first->time_us) * 1e-6)};
    trace.samples.push_back(row->sample);
  }
  if (trace.samples.size() < 2)
    return Error{.what = "fewer than two usable rows (skipped rows: " + std::to_string(trace.skipped) +
                         "; a row is skipped if its time or palm position is not a finite number, a coordinate is "
                         "beyond 10000 mm, its hand_id is not that of the first row, or its time is not after that "
                         "of the row before)",
                 .where = std::string(name),
                 .fix =
                     "give at least two rows of numbers, with the same hand_id, and with a timestamp_us that grows "
                     "from row to row"};
  return trace;
}

Result<HandTrace> read_hand_trace(const std::filesystem::path& file) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(file, code);
  if (code) return Error{.what = "cannot be read: " + code.message(), .where = file.string(), .fix = "check the path"};
  if (size > kMostBytes)
    return Error{.what = "is larger than 64 MiB", .where = file.string(), .fix = "give a shorter hand trace"};
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  if (!stream) return Error{.what = "cannot be read", .where = file.string(), .fix = "check its permissions"};
  return parse_hand_trace(text.str(), file.string());
}

RecordedIntention::RecordedIntention(const HandTrace& trace,
                                     const Transform<HapticBase, HandTracker>& haptic_from_tracker,
                                     const Point<HapticBase>& skin, double depth_m) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double lowest_m = 1e9;
  for (const TraceSample& sample : trace.samples) {
    times_s_.push_back(to_seconds(sample.at.time_since_epoch()));
    path_m_.push_back((haptic_from_tracker * sample.palm).m);
    sum += path_m_.back();
    lowest_m = std::min(lowest_m, path_m_.back().y());
    if (sample.attitude) attitudes_.push_back(Eigen::Quaterniond(haptic_from_tracker.iso.linear()) * *sample.attitude);
  }
  if (attitudes_.size() != path_m_.size()) attitudes_.clear();
  const Eigen::Vector3d mean = sum / static_cast<double>(path_m_.size());
  const Eigen::Vector3d shift = skin.m - Eigen::Vector3d{mean.x(), lowest_m + depth_m, mean.z()};
  for (Eigen::Vector3d& point : path_m_) point += shift;
}

double RecordedIntention::duration_s() const noexcept { return times_s_.back(); }

RecordedIntention::Place RecordedIntention::place(double time_s) const noexcept {
  const double there_and_back = std::fmod(std::max(time_s, 0.0), 2.0 * duration_s());
  const bool back = there_and_back > duration_s();
  const double t = back ? 2.0 * duration_s() - there_and_back : there_and_back;
  const auto after = std::upper_bound(times_s_.begin() + 1, times_s_.end() - 1, t);
  const auto before = static_cast<std::size_t>(after - times_s_.begin()) - 1;
  const double share = (t - times_s_[before]) / (times_s_[before + 1] - times_s_[before]);
  return {before, std::clamp(share, 0.0, 1.0), back};
}

device::Intention RecordedIntention::at(double time_s) const noexcept {
  const Place now = place(time_s);
  const double span_s = times_s_[now.before + 1] - times_s_[now.before];
  const Eigen::Vector3d way = path_m_[now.before + 1] - path_m_[now.before];
  return {.at = {path_m_[now.before] + way * now.share}, .velocity = {way * ((now.back ? -1.0 : 1.0) / span_s)}};
}

std::optional<Eigen::Quaterniond> RecordedIntention::attitude(double time_s) const noexcept {
  if (attitudes_.empty()) return std::nullopt;
  const Place now = place(time_s);
  return attitudes_[now.before].slerp(now.share, attitudes_[now.before + 1]);
}

}  // namespace telepalp::tracking
