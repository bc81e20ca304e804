#include "server/oidc/settings.h"

#include <algorithm>
#include <fstream>

#include "messages/sign_in.pb.h"
#include "proto/keys/key_file.h"
#include "proto/words/error_line.h"
#include "server/oidc/web/web_address.h"
#include "support/program/text/text_format.h"

namespace telepalp::oidc {
namespace {

namespace fs = std::filesystem;

constexpr double kLeast_h = 0.1;
constexpr double kMost_h = 12.0;  // of any browser (gateway::WebSessions::kLongest)
constexpr std::size_t kLongestSecret = 1024;

/// The message of a file, and the places of its values.
struct Read {
  std::string file;
  msg::HospitalSignIn message{};
  program::NumberPlaces places{};

  [[nodiscard]] Error wrong(const char* field, const std::string& value, std::string what, std::string fix) const {
    return {.what = std::move(what), .where = places.where(file, field, value, 0), .fix = std::move(fix)};
  }
  [[nodiscard]] fs::path beside(const std::string& name) const { return fs::path(file).parent_path() / name; }
};

Result<void> check_addresses(const Read& read) {
  const msg::HospitalSignIn& message = read.message;
  if (!is_safe_address(message.issuer()) || message.issuer().find_first_of("?#") != std::string::npos)
    return read.wrong("issuer", message.issuer(), "the issuer is not an address that begins with https://",
                      R"(give the provider's address as it calls itself: issuer: "https://login.hospital.example")");
  if (!is_https_origin(message.page()))
    return read.wrong("page", message.page(),
                      "the page is not https:// and a host, in lower case, without a path and without :443",
                      R"(give the address by which browsers reach this server: page: "https://tele.hospital.example")");
  if (message.client_id().empty())
    return read.wrong("client_id", "", "no client_id is given",
                      "register this server at the provider, and give the client's name there");
  return {};
}

Result<void> check_scope(const Read& read) {
  for (const std::string& one : read.message.scope())
    if (one.empty() || !std::ranges::all_of(one, [](char c) { return c > ' ' && c < 127 && c != '"' && c != '\\'; }))
      return read.wrong("scope", one, "'" + one + "' is no scope", "give one word for each scope: scope: \"groups\"");
  return {};
}

Result<std::chrono::seconds> longest(const Read& read) {
  const double hours = read.message.longest_hours();
  if (hours == 0.0) return Settings{}.longest;
  if (hours >= kLeast_h && hours <= kMost_h)
    return std::chrono::duration_cast<std::chrono::seconds>(std::chrono::duration<double, std::ratio<3600>>(hours));
  return Error{.what = "longest_hours is " + number_text(hours),
               .where = read.places.where(read.file, "longest_hours", hours),
               .fix = "give 0.1 to 12"};
}

Result<std::vector<Rule>> rules(const Read& read) {
  std::vector<Rule> all;
  for (const msg::HospitalSignIn::Rule& rule : read.message.rule()) {
    const auto wrong = [&](std::string what, std::string fix) {
      return Error{.what = std::move(what), .where = read.places.where(read.file, rule), .fix = std::move(fix)};
    };
    const auto role = keys::role_named(rule.role());
    if (!role) return wrong("'" + rule.role() + "' is no role", "give technician, doctor, viewer or qa");
    if (rule.claim().empty() || rule.value().empty())
      return wrong("this rule has no claim or no value, so it fits everybody or nobody",
                   R"(give both: rule { claim: "groups" value: "palpation-doctors" role: "doctor" })");
    all.push_back({.claim = rule.claim(), .value = rule.value(), .role = *role});
  }
  if (!all.empty()) return all;
  return Error{.what = "there is no rule, so nobody could sign in",
               .where = read.file,
               .fix = R"(add rule { claim: "groups" value: "palpation-doctors" role: "doctor" })"};
}

Result<std::string> secret(const Read& read) {
  if (read.message.client_secret_file().empty()) return std::string();
  const fs::path file = read.beside(read.message.client_secret_file());
  if (const Result<void> secret_is_kept = keys::check_private(file); !secret_is_kept) return secret_is_kept.error();
  std::ifstream stream(file, std::ios::binary);
  std::string line(kLongestSecret + 1, '\0');
  stream.read(line.data(), static_cast<std::streamsize>(line.size()));
  line.resize(static_cast<std::size_t>(stream.gcount()));
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
  const bool is_text = std::ranges::all_of(line, [](char c) { return c >= ' ' && c < 127; });
  if (!line.empty() && line.size() <= kLongestSecret && is_text) return line;
  return Error{.what = "this is not one line with the client's secret",
               .where = file.string(),
               .fix = "write the secret that the provider shows for this client into the file, and nothing else"};
}

Result<fs::path> authority(const Read& read) {
  if (read.message.authority_file().empty()) return fs::path();
  const fs::path file = read.beside(read.message.authority_file());
  if (std::ifstream(file).good() && fs::is_regular_file(file)) return file;
  return read.wrong("authority_file", read.message.authority_file(), "the file " + file.string() + " cannot be read",
                    "name the PEM file of the authority that certifies the provider, or leave authority_file out");
}

}  // namespace

std::string Settings::back() const { return page + kBackTarget; }

Result<Settings> read_settings(const fs::path& file) {
  Read read{.file = file.string()};
  Result<program::NumberPlaces> places = program::read_text_format(file, read.message);
  if (!places) return places.error();
  read.places = std::move(places).value();
  if (const Result<void> fine = check_addresses(read); !fine) return fine.error();
  if (const Result<void> fine = check_scope(read); !fine) return fine.error();
  const Result<std::chrono::seconds> until = longest(read);
  if (!until) return until.error();
  Result<std::vector<Rule>> all_rules = rules(read);
  if (!all_rules) return all_rules.error();
  Result<std::string> client_secret = secret(read);
  if (!client_secret) return client_secret.error();
  Result<fs::path> authority_file = authority(read);
  if (!authority_file) return authority_file.error();
  Settings settings{.issuer = read.message.issuer(),
                    .client_id = read.message.client_id(),
                    .client_secret = std::move(client_secret).value(),
                    .authority_file = std::move(authority_file).value(),
                    .page = read.message.page(),
                    .longest = *until,
                    .rules = std::move(all_rules).value()};
  for (const std::string& one : read.message.scope()) settings.scope += " " + one;
  if (!read.message.name_claim().empty()) settings.name_claim = read.message.name_claim();
  return settings;
}

}  // namespace telepalp::oidc
