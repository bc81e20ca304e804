#include "support/program/people/account.h"

#include <pwd.h>
#include <unistd.h>

namespace telepalp::program {

std::string account() {
  const ::passwd* const account = ::getpwuid(::getuid());
  return "account " + (account == nullptr ? std::to_string(::getuid()) : std::string(account->pw_name));
}

}  // namespace telepalp::program
