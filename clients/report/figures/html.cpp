#include "clients/report/figures/html.h"

#include "support/plot/svg.h"

namespace telepalp::report {

const std::string_view kStyle = R"css(
:root { color-scheme: light; }
body { margin: 0 auto; max-width: 1000px; padding: 24px 20px 60px; background: #f6f7f9; color: #22262d;
  font: 16px/1.5 system-ui, "DejaVu Sans", Arial, sans-serif; }
h1 { font-size: 26px; margin: 0 0 2px; } h2 { font-size: 20px; margin: 0 0 2px; }
.from { color: #667080; margin: 0 0 18px; font-size: 14px; }
.facts { display: flex; flex-wrap: wrap; gap: 4px 22px; margin: 0 0 8px; font-size: 14px; }
.facts div { display: flex; gap: 6px; } .facts dt { color: #667080; } .facts dd { margin: 0; overflow-wrap: anywhere; }
.notice { color: #566070; margin: 0 0 14px; font-size: 13px; }
.causes { margin: 12px 0 4px; padding-left: 24px; } .causes li { margin: 0 0 8px; }
.scroll { overflow-x: auto; } details > summary { cursor: pointer; padding: 6px 0; color: #22262d; }
.meanings { display: grid; grid-template-columns: max-content 1fr; gap: 4px 16px; margin: 0; font-size: 14.5px; }
.meanings dt { font-weight: 600; } .meanings dd { margin: 0; color: #566070; }
.verdict, section { background: #fff; border: 1px solid #e1e5ea; border-radius: 10px; padding: 18px 20px; margin: 0 0 18px; }
.verdict { border-left: 10px solid #009e73; } .verdict.look { border-left-color: #d55e00; }
.verdict.none { border-left-color: #8a8f98; }
.verdict p { margin: 8px 0 0; } .headline { font-size: 21px; font-weight: 650; }
.checks { display: grid; grid-template-columns: repeat(auto-fill, minmax(170px, 1fr)); gap: 10px; margin-top: 16px; }
.check { border: 1px solid #e1e5ea; border-top: 4px solid #009e73; border-radius: 6px; padding: 8px 10px; }
.check.misses { border-top-color: #d55e00; background: #fff6ef; } .check.unknown { border-top-color: #b5bbc4; }
.check .name { font-size: 13px; color: #566070; } .check .value { font-size: 20px; font-weight: 600; }
.check .budget { font-size: 12px; color: #667080; }
section > p { color: #566070; margin: 0 0 12px; font-size: 14.5px; }
svg { display: block; width: 100%; height: auto; margin: 6px 0; }
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 10px 16px; }
img { display: block; width: 100%; height: auto; border-radius: 8px; }
table { border-collapse: collapse; width: 100%; font-size: 14.5px; font-variant-numeric: tabular-nums; }
th, td { padding: 5px 10px; border-bottom: 1px solid #e8ebef; text-align: right; }
th { color: #566070; font-weight: 600; } th:first-child, td:first-child, .words th, .words td { text-align: left; }
.words td { overflow-wrap: anywhere; } .words td:first-child { white-space: nowrap; }
@media (max-width: 700px) { .pair { grid-template-columns: 1fr; } body { padding: 14px 8px 40px; }
  .verdict, section { padding: 12px 10px; } .headline { font-size: 18px; } th, td { padding: 4px 5px; font-size: 12.5px; }
  .words td:first-child { white-space: normal; } td, th, h1, .from { overflow-wrap: anywhere; } }
@media print { body { background: #fff; max-width: none; padding: 0; font-size: 12px; }
  section, .verdict { break-inside: avoid; border-color: #ccc; } }
)css";

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return out;
}

std::string table(const std::vector<std::string>& head, const std::vector<std::vector<std::string>>& rows,
                  Cells cells) {
  std::string out = cells == Cells::Words ? "<table class=\"words\"><thead><tr>" : "<table><thead><tr>";
  for (const std::string& cell : head) out += "<th>" + plot::escaped(cell) + "</th>";
  out += "</tr></thead><tbody>\n";
  for (const auto& row : rows) {
    out += "<tr>";
    for (const std::string& cell : row) out += "<td>" + plot::escaped(cell) + "</td>";
    out += "</tr>\n";
  }
  return out + "</tbody></table>\n";
}

std::string section(std::string_view heading, std::string_view explanation, const std::string& content) {
  return "<section><h2>" + plot::escaped(heading) + "</h2>\n<p>" + plot::escaped(explanation) + "</p>\n" + content +
         "</section>\n";
}

}  // namespace telepalp::report
