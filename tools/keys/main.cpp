// telepalp-keys: makes, renews and revokes the keys by which a server knows its peers, and checks its audit log.

#include <sys/stat.h>

#include <array>
#include <cstdio>

#include "proto/keys/key_file.h"
#include "support/program/options.h"
#include "tools/keys/commands.h"

namespace {

using namespace telepalp;
using keys_tool::Asked;

constexpr std::string_view kProgram = "telepalp-keys";

program::Usage usage() {
  return {.program = kProgram,
          .purpose = "makes, signs, renews and revokes keys; checks an audit log",
          .positional = {},
          .options = {{"dir", "DIR", "folder with the authority and the keys", "keys"},
                      {"name", "NAME", "name of the person, server or authority to make a key for"},
                      {"role", "ROLE", "technician, doctor, viewer or qa: what the key allows"},
                      {.name = "host",
                       .argument = "HOST",
                       .help = "server: a host that clients connect to; authority: a host or network for which it may "
                               "sign; may be repeated",
                       .repeatable = true},
                      {"passphrase", "", "protect the new private key with a passphrase"},
                      {"key", "pkcs11:ADDRESS", "use the private key in a hardware token"},
                      {"anchors", "FILE",
                       "audit-verify: lines 'anchor …' of the server, kept elsewhere, after its certificate"},
                      {"days", "N", "days of validity; default: authority 3650, keys 365, tokens 30"}},
          .example = "telepalp-keys authority --host 10.0.0.5 --passphrase",
          .commands = {{"authority", "", "make a new certificate authority; needs --host"},
                       {"server", "", "make a key for telepalp-server --key; needs --host"},
                       {"client", "", "make a key for a person's programs; needs --name and --role"},
                       {"token", "",
                        "make a token with which a person signs in on the browser page; needs --name and --role"},
                       {"request", "", "make your own key, and a request to send; needs --name"},
                       {"sign", "FILE", "make a certificate of a request; needs --role or --host"},
                       {"site-key", "", "make the key of a site's encrypted recordings; needs --name"},
                       {"passphrase", "FILE", "protect the private key in FILE with a new passphrase"},
                       {"renew", "FILE", "replace the key or token in FILE by a new one, valid for --days from now"},
                       {"revoke", "FILE|SERIAL", "revoke a key or token"},
                       {"list", "", "print all keys and tokens that were issued"},
                       {"show", "FILE", "print whose key FILE is, what it allows, until when"},
                       {"audit-verify", "FILE",
                        "check that no line of a server's audit log was altered, or removed since an anchor"}},
          .needs_command = true};
}

struct Row {
  std::string_view name;
  bool takes_file;
  Result<std::string> (*run)(const Asked&);
  Result<void> (*check)(const Asked&) = nullptr;  // of the command line; nullptr: no option is needed
};
constexpr std::array kCommands{Row{"authority", false, keys_tool::make_authority, keys_tool::check_hosts},
                               Row{"server", false, keys_tool::make_server_key, keys_tool::check_hosts},
                               Row{"client", false, keys_tool::make_client_key, keys_tool::check_person},
                               Row{"token", false, keys_tool::make_token, keys_tool::check_person},
                               Row{"request", false, keys_tool::make_key_and_request, keys_tool::check_name_given},
                               Row{"sign", true, keys_tool::sign, keys_tool::check_person_or_hosts},
                               Row{"site-key", false, keys_tool::make_site_key, keys_tool::check_name_given},
                               Row{"passphrase", true, keys_tool::set_passphrase},
                               Row{"renew", true, keys_tool::renew},
                               Row{"revoke", true, keys_tool::revoke},
                               Row{"list", false, keys_tool::list},
                               Row{"show", true, keys_tool::show},
                               Row{"audit-verify", true, keys_tool::verify_audit}};

Error asked_wrongly(std::string what) {
  return {.what = std::move(what), .where = std::string(kProgram), .fix = "see telepalp-keys --help"};
}

Result<const Row*> command_of(const program::Arguments& arguments) {
  const std::vector<std::string>& words = arguments.positional();
  if (words.empty()) return asked_wrongly("no command is given");
  for (const Row& row : kCommands) {
    if (row.name != words.front()) continue;
    if (words.size() == (row.takes_file ? 2U : 1U)) return &row;
    return asked_wrongly(words.front() +
                         (row.takes_file ? " takes exactly one argument" : " takes only options, no file"));
  }
  return asked_wrongly("'" + words.front() + "' is not a command");
}

Result<Asked> read_asked(const program::Arguments& arguments) {
  Asked asked{.folder = arguments.text("dir"),
              .file = arguments.positional().size() > 1 ? arguments.positional()[1] : "",
              .name = arguments.text("name"),
              .role = arguments.text("role"),
              .hosts = arguments.all("host"),
              .anchors = arguments.text("anchors"),
              .key = arguments.text("key"),
              .passphrase = arguments.has("passphrase"),
              .valid = {},
              .now = std::chrono::system_clock::now()};
  if (!arguments.has("days")) return asked;
  const Result<std::int64_t> days = arguments.whole("days", 1, 36500);
  if (!days) return days.error();
  asked.valid = std::chrono::days(*days);
  return asked;
}

int run_asked(const program::Arguments& arguments) {
  const Result<const Row*> command = command_of(arguments);
  if (!command) return program::fail(command.error(), program::kAskedWrongly);
  const Result<Asked> asked = read_asked(arguments);
  if (!asked) return program::fail(asked.error(), program::kAskedWrongly);
  if (const auto check = (*command)->check)
    if (const Result<void> complete = check(*asked); !complete)
      return program::fail(complete.error(), program::kAskedWrongly);
  ::umask(0077);  // a key is its owner's alone: 0600
  keys::forbid_dumps();
  const Result<std::string> said = (*command)->run(*asked);
  if (!said) return program::fail(said.error());
  return program::print(*said);
}

}  // namespace

int main(int argc, char** argv) { return program::run_program(usage(), argc, argv, run_asked); }
