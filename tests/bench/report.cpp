#include "tests/bench/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <thread>

#include "support/program/version.h"

namespace telepalp::bench {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') out += '\\';
    out += static_cast<unsigned char>(letter) < 0x20 ? ' ' : letter;
  }
  return out + "\"";
}

std::string number(double value) {
  if (!std::isfinite(value)) return "null";
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string asked(const Row& row) {
  if (row.bound == Bound::None) return "";
  return (row.bound == Bound::AtMost ? "<= " : ">= ") + number(row.reach);
}

}  // namespace

std::string machine_name() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.starts_with("model name"))
      return line.substr(std::min(line.size(), line.find(": ") + 2)) + ", " +
             std::to_string(std::thread::hardware_concurrency()) + " cores";
  return "unknown";
}

bool Row::holds() const noexcept {
  if (!std::isfinite(value)) return false;
  if (bound == Bound::AtMost) return value <= reach;
  if (bound == Bound::AtLeast) return value >= reach;
  return true;
}

bool Report::holds() const noexcept {
  return std::all_of(rows.begin(), rows.end(), [](const Row& row) { return row.holds(); });
}

Row measured(std::string name, double value, std::string unit) {
  return {std::move(name), value, std::move(unit), Bound::None, 0.0};
}
Row at_most(std::string name, double value, std::string unit, double reach) {
  return {std::move(name), value, std::move(unit), Bound::AtMost, reach};
}
Row at_least(std::string name, double value, std::string unit, double reach) {
  return {std::move(name), value, std::move(unit), Bound::AtLeast, reach};
}

std::string to_json(const Report& report) {
  std::string json = "{\"bench\":" + quoted(report.bench) + ",\"commit\":" + quoted(program::commit()) +
                     ",\"machine\":" + quoted(machine_name()) + ",\"rows\":[";
  for (const Row& row : report.rows) {
    if (json.back() != '[') json += ',';
    json += "\n  {\"name\":" + quoted(row.name) + ",\"value\":" + number(row.value) + ",\"unit\":" + quoted(row.unit) +
            ",\"reach\":" + (row.bound == Bound::None ? "null" : number(row.reach)) +
            ",\"holds\":" + (row.holds() ? "true" : "false") + "}";
  }
  return json + "\n]}\n";
}

std::string to_table(const Report& report) {
  std::size_t width = 20;
  for (const Row& row : report.rows) width = std::max(width, row.name.size());
  std::string table = report.bench + "  (" + machine_name() + ", commit " + program::commit() + ")\n";
  for (const Row& row : report.rows) {
    char line[400];
    std::snprintf(line, sizeof line, "  %-*s %12s %-8s %-14s %s\n", static_cast<int>(width), row.name.c_str(),
                  std::isfinite(row.value) ? number(row.value).c_str() : "not finite", row.unit.c_str(),
                  asked(row).c_str(), row.bound == Bound::None ? "" : (row.holds() ? "holds" : "MISSES"));
    table += line;
  }
  for (const std::string& note : report.notes) table += "  " + note + "\n";
  return table;
}

}  // namespace telepalp::bench
