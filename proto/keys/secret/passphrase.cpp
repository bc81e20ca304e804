#include "proto/keys/secret/passphrase.h"

#include <fcntl.h>
#include <openssl/err.h>
#include <openssl/evp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>

#include "proto/keys/secret/small_file.h"

namespace telepalp::keys {
namespace {

constexpr std::size_t kMostPassphraseBytes = 256;
constexpr std::size_t kLeastBytes = 12;  // of a new one: a stolen file can be attacked without a server that slows down
constexpr int kAttempts = 3;

struct Variables {
  const char* text;
  const char* file;
};
constexpr Variables kOld{"TELEPALP_PASSPHRASE", "TELEPALP_PASSPHRASE_FILE"};
constexpr Variables kNew{"TELEPALP_NEW_PASSPHRASE", "TELEPALP_NEW_PASSPHRASE_FILE"};

Error no_passphrase(const std::string& what, const Variables& variables, const std::string& why) {
  return {.what = why,
          .where = what,
          .fix = std::string("start the program in a terminal and type the passphrase, or write it to a file that only "
                             "you may read, and name this file in the environment variable ") +
                 variables.file};
}

Result<std::string> first_line_of(const std::string& file, const std::string& what, const Variables& variables) {
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0 && (status.st_mode & S_IRWXO) != 0)
    return Error{
        .what = "every user of this computer has access to this passphrase", .where = file, .fix = "chmod 600 " + file};
  std::string text = read_small_file(file, kMostPassphraseBytes + 1).value_or("");
  text.resize(std::min(text.size(), text.find_first_of("\r\n")));
  if (!text.empty() && text.size() <= kMostPassphraseBytes) return text;
  return no_passphrase(
      what, variables,
      "the file " + file + ", which " + variables.file + " names, has no first line of 1 to 256 bytes");
}

/// nullopt: neither variable is set.
std::optional<Result<std::string>> of_environment(const Variables& variables, const std::string& what) {
  if (const char* const text = std::getenv(variables.text); text != nullptr && *text != '\0') return std::string(text);
  if (const char* const file = std::getenv(variables.file); file != nullptr && *file != '\0')
    return first_line_of(file, what, variables);
  return std::nullopt;
}

/// A process in the background that read from the terminal would be stopped (SIGTTIN).
bool has_terminal() {
  const int terminal = ::open("/dev/tty", O_RDWR | O_NOCTTY | O_CLOEXEC);
  if (terminal < 0) return false;
  const bool is_in_front = ::tcgetpgrp(terminal) == ::getpgrp();
  ::close(terminal);
  return is_in_front;
}

/// OpenSSL switches the echo off, and on again also after Ctrl-C.
std::optional<std::string> typed(const std::string& prompt, std::size_t least, bool twice) {
  std::array<char, kMostPassphraseBytes + 1> text{};
  const int failed =
      EVP_read_pw_string_min(text.data(), static_cast<int>(least), kMostPassphraseBytes, prompt.c_str(), twice ? 1 : 0);
  ERR_clear_error();
  std::string passphrase(text.data());
  OPENSSL_cleanse(text.data(), text.size());
  return failed == 0 ? std::optional(std::move(passphrase)) : std::nullopt;
}

}  // namespace

Result<std::string> passphrase_of_environment(const std::string& what, int attempt) {
  if (const auto given = of_environment(kOld, what)) {
    if (attempt == 0 || !*given) return *given;
    return no_passphrase(what, kOld,
                         std::string("the passphrase that ") + kOld.text + " or " + kOld.file + " gives is wrong");
  }
  return no_passphrase(what, kOld, "a passphrase protects this key, and nobody can be asked for it");
}

bool environment_has_passphrase() { return of_environment(kOld, {}).has_value(); }

Result<std::string> ask_passphrase(const std::string& what, int attempt) {
  if (of_environment(kOld, what) || !has_terminal()) return passphrase_of_environment(what, attempt);
  const std::string again = attempt == 0 ? "" : "wrong. ";
  const auto passphrase = attempt < kAttempts ? typed(again + "passphrase of " + what + ": ", 0, false) : std::nullopt;
  if (passphrase) return *passphrase;
  return Error{.what = attempt < kAttempts ? "no passphrase was typed" : "three wrong passphrases were typed",
               .where = what,
               .fix =
                   "type the passphrase of this key; nobody can restore a forgotten one: ask the technician for a "
                   "new key"};
}

Result<std::string> new_passphrase(const std::string& what) {
  const auto given = of_environment(kNew, what);
  if (given && (!*given || (*given)->size() >= kLeastBytes)) return *given;
  if (!given && !has_terminal())
    return no_passphrase(what, kNew, "a new passphrase is wanted, and nobody can be asked for it");
  if (!given)
    if (const auto passphrase = typed("new passphrase for " + what + ", 12 characters or more: ", kLeastBytes, true))
      return *passphrase;
  return Error{.what = given ? "the new passphrase is shorter than 12 characters"
                             : "no passphrase of 12 characters or more was typed twice",
               .where = what,
               .fix = "choose a longer one, such as four words"};
}

}  // namespace telepalp::keys
