#include "proto/wire/mcap/sealed/given_key.h"

#include <vector>

namespace telepalp::wire::mcap {

Result<keys::SiteKey> given_site_key(const std::string& id, const std::string& file) {
  const Result<std::vector<keys::SiteKey>> site_keys = keys::site_keys_of_environment();
  if (!site_keys) return site_keys.error();
  const keys::SiteKey* found = nullptr;
  for (const keys::SiteKey& key : *site_keys)
    if (key.id() == id && (found == nullptr || key.has_private_part())) found = &key;
  if (found != nullptr) return *found;
  return Error{.what = "is encrypted with the site's key " + keys::in_hexadecimal_digits(id) + ", which is not given",
               .where = file,
               .fix = "name the private part of this key in the environment: TELEPALP_SITE_KEYS=NAME.key"};
}

}  // namespace telepalp::wire::mcap
