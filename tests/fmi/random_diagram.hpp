// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <random>
#include <string>

namespace tandem::test {

/// A diagram by chance: blocks that take what stands before them, bounded, with a parameter, two inputs and up to
/// four outputs.
class RandomDiagram {
 public:
  explicit RandomDiagram(std::mt19937& random) : random_(random) {}

  std::string text() {
    for (int left = 3 + one_of(8); left > 0; --left) add();
    std::string all = "[parameters]\nk = { value = " + number() +
                      ", unit = '1' }\nk2 = { value = '$(2 * k)', unit = '1' }\n"
                      "[inputs]\nu = { unit = '1' }\nw = { unit = '1' }\n[blocks]\n" +
                      blocks_ + "[outputs]\n";
    for (int k = std::max(0, count_ - 4); k < count_; ++k) all += name(k) + " = { unit = '1' }\n";
    return all;
  }

 private:
  int one_of(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  std::string number() { return std::to_string(std::uniform_real_distribution<double>(-2.0, 2.0)(random_)); }
  std::string positive() {
    return std::to_string(std::uniform_real_distribution<double>(0.02, 0.5)(random_));
  }
  static std::string name(int k) { return "b" + std::to_string(k); }
  std::string signal() {
    const int k = one_of(count_ + 2);
    return k == 0 ? "'u'" : k == 1 ? "'w'" : "'" + name(k - 2) + "'";
  }

  /// What has no bound of its own stands behind a saturation.
  void add() {
    const std::string kinds[] = {
        "'lag', time = " + positive() + ", gain = '$k'",
        "'sum', inputs = [" + signal() + ", " + signal() + "], gains = [" + number() + ", 0.5]",
        "'saturation', low = -0.7, high = 0.9",
        "'rate_limiter', rising = 2, falling = 1.5, time = " + positive(),
        "'sample', period = " + positive(),
        "'relay', low = -0.2, high = 0.3",
        "'switch', threshold = 0.1, above = " + signal() + ", below = " + signal(),
        "'pid', kp = 1.2, ki = 0.4, low = -1, high = '$(abs(k2) + 1)'",
        "'gain', gain = '$k2'",
        "'delay', delay = " + positive(),
        "'transfer_function', numerator = [1], denominator = [" + positive() + ", 0.3, 1]"};
    const int kind = one_of(std::size(kinds));
    const std::string input = kind == 1   ? ""
                              : kind == 6 ? ", control = " + signal()
                                          : ", input = " + signal();
    blocks_ += name(count_) + " = { kind = " + kinds[kind] + input + " }\n";
    ++count_;
  }

  std::mt19937& random_;
  std::string blocks_;
  int count_ = 0;
};

}  // namespace tandem::test
