#pragma once

#include <random>
#include <string>

namespace telepalp::solids {

/// Random solids in Polish notation, about 0.1 m in size, reproducible from the seed.
class RandomSolid {
 public:
  explicit RandomSolid(std::uint64_t seed) : random_(seed) {}

  [[nodiscard]] double number(double least, double most) {
    return std::uniform_real_distribution(least, most)(random_);
  }
  [[nodiscard]] int choice(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }
  [[nodiscard]] std::string length() { return " " + std::to_string(number(0.01, 0.06)); }
  [[nodiscard]] std::string three(double most) {
    return " " + std::to_string(number(-most, most)) + " " + std::to_string(number(-most, most)) + " " +
           std::to_string(number(-most, most));
  }

  [[nodiscard]] std::string shape() {
    switch (choice(8)) {
      case 0:
        return "sphere" + length();
      case 1:
        return "capsule" + three(0.05) + three(0.05) + length();
      case 2:
        return std::string("torus") + "xyz"[choice(3)] + length() + length();
      case 3:
        return std::string("arc") + "xyz"[choice(3)] + " 0.06 0.01 -40 " + std::to_string(number(0.0, 300.0));
      case 4:
        return "box" + length() + length() + length();
      case 5:
        return "ellipsoid" + length() + length() + length();
      case 6:
        return std::string("cylinder") + "xyz"[choice(3)] + length() + length();
      default:
        return "clip" + three(1.0) + " 0.01 sphere 0.05";
    }
  }

  [[nodiscard]] std::string tree(int depth) {
    if (depth == 0) return shape();
    const std::string left = tree(depth - 1);
    switch (choice(9)) {
      case 0:
      case 1:
        return "+ " + left + " " + tree(depth - 1);
      case 2:
        return "* " + left + " " + tree(depth - 1);
      case 3:
        return "- " + left + " " + tree(depth - 1);
      case 4:
        return "blend" + length() + " " + left + " " + tree(depth - 1);
      case 5:
        return "tr" + three(0.05) + " " + left;
      case 6:
        return "tx" + three(0.05) + " " + std::to_string(number(-180.0, 180.0)) + three(1.0) + " " + left;
      case 7:
        return "ro " + std::to_string(number(-180.0, 180.0)) + three(1.0) + " " + left;
      default:
        return "sc " + std::to_string(number(0.3, 3.0)) + " " + left;
    }
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace telepalp::solids
