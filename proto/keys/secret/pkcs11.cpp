// OpenSSL 3.0 takes a PKCS#11 token by an engine; Debian 12 has no provider for it. OpenSSL calls engines deprecated.
#define OPENSSL_SUPPRESS_DEPRECATED

#include "proto/keys/secret/pkcs11.h"

#include <openssl/engine.h>
#include <openssl/err.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "proto/keys/x509/openssl.h"

namespace telepalp::keys {
namespace {

constexpr std::string_view kScheme = "pkcs11:";
constexpr std::size_t kMostAddressBytes = 512;

using EnginePtr = std::unique_ptr<ENGINE, Freed<ENGINE_free>>;

Error wrong_address(std::string_view text, std::string what) {
  return {.what = std::move(what),
          .where = std::string(text.substr(0, 80)),
          .fix = "give pkcs11:token=NAME;object=LABEL, and if needed ?module-path=FILE, the token's driver"};
}

std::optional<std::string> without_percents(std::string_view text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    unsigned value = static_cast<unsigned char>(text[at]);
    if (text[at] == '%') {
      const std::string_view digits = text.substr(at + 1, 2);
      const auto [end, failed] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
      if (digits.size() != 2 || failed != std::errc() || end != digits.data() + 2) return std::nullopt;
      at += 2;
    }
    plain += static_cast<char>(value);
  }
  return plain;
}

/// The value of `name` in "name=value;name=value"; empty: it is not there. nullopt: a wrong percent sign.
std::optional<std::string> value_of(std::string_view list, std::string_view name, char between) {
  while (!list.empty()) {
    const std::string_view one = list.substr(0, list.find(between));
    list.remove_prefix(std::min(list.size(), one.size() + 1));
    if (one.starts_with(name) && one.substr(name.size()).starts_with('='))
      return without_percents(one.substr(name.size() + 1));
  }
  return "";
}

Error engine_failed(const std::string& what, const Pkcs11Address& address, const std::string& fix) {
  const Error cause = openssl_error(address.key);
  return {.what = what + " (" + cause.what + ")", .where = address.key, .fix = fix};
}

/// The engine keeps its driver and its sessions with the token until the program ends.
Result<EnginePtr> ready_engine(const Pkcs11Address& address) {
  EnginePtr engine(ENGINE_by_id("pkcs11"));
  if (!engine)
    return engine_failed("OpenSSL's engine for hardware tokens cannot be loaded", address,
                         "apt install libengine-pkcs11-openssl");
  if (!address.module.empty() && ENGINE_ctrl_cmd_string(engine.get(), "MODULE_PATH", address.module.c_str(), 0) != 1)
    return engine_failed("the engine does not take the driver " + address.module, address, "check ?module-path=FILE");
  if (ENGINE_init(engine.get()) != 1)
    return engine_failed("the token's driver cannot be started", address,
                         "name the driver by ?module-path=FILE, or by the environment variable PKCS11_MODULE_PATH");
  return engine;
}

}  // namespace

bool is_pkcs11(std::string_view text) noexcept { return text.starts_with(kScheme); }

Result<Pkcs11Address> read_pkcs11(std::string_view text) {
  const auto is_odd = [](char letter) { return letter <= ' ' || letter > '~' || letter == '"'; };
  if (!is_pkcs11(text) || text.size() > kMostAddressBytes || std::any_of(text.begin(), text.end(), is_odd))
    return wrong_address(text, "this is not the address of a key in a token");
  const std::string_view key = text.substr(0, text.find('?'));
  const std::string_view query = text.substr(std::min(text.size(), key.size() + 1));
  if (text.find("pin-value") != std::string_view::npos || text.find("pin-source") != std::string_view::npos)
    return wrong_address(key, "the address of a key must not have the PIN: other users see a command line");
  const auto object = value_of(key.substr(kScheme.size()), "object", ';');
  const auto module = value_of(query, "module-path", '&');
  if (!object || object->empty() || !module)
    return wrong_address(text, "the address of the key names no object, or has a wrong percent sign");
  return Pkcs11Address{.key = std::string(key), .object = *object, .module = *module};
}

Result<PrivateKey> open_pkcs11(const Pkcs11Address& address, const AskPassphrase& ask) {
  const Result<std::string> pin =
      ask ? ask("the token with " + address.key + ", which is its PIN", 0)
          : Result<std::string>(Error{.what = "the key is in a token", .where = address.key, .fix = "give its PIN"});
  if (!pin) return pin.error();
  const Result<EnginePtr> engine = ready_engine(address);
  if (!engine) return engine.error();
  ENGINE* const token = engine->get();
  EVP_PKEY* const key = ENGINE_ctrl_cmd_string(token, "PIN", pin->c_str(), 0) == 1
                            ? ENGINE_load_private_key(token, address.key.c_str(), nullptr, nullptr)
                            : nullptr;
  if (key == nullptr)
    return engine_failed("the token has no such key, or the PIN is wrong", address,
                         "insert the token, compare its name and the key's label, and type its PIN");
  ERR_clear_error();
  return PrivateKey(key, EVP_PKEY_free);
}

}  // namespace telepalp::keys
