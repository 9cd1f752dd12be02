// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "two_mass_oracle.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace tandem::test {
namespace {

std::string output_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) throw std::runtime_error("could not run " + command);
  std::string text;
  std::array<char, 512> buffer{};
  while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe)) text += buffer.data();
  if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
  return text;
}

/// The cells of a CSV line as numbers; a text is 0.
std::vector<double> numbers(const std::string& line) {
  std::vector<double> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, ',');)
    cells.push_back(std::strtod(cell.c_str(), nullptr));
  return cells;
}

}  // namespace

OracleRow ask_oracle(const std::string& arguments) {
  const std::string line = output_of(std::string(TANDEM_TWO_MASS_ORACLE) + " " + arguments);
  const std::vector<double> c = numbers(line);
  if (c.size() != 16) throw std::runtime_error("the oracle printed " + line);
  return {c[4],
          c[5],
          c[6],
          c[7],
          c[8],
          c[9],
          c[10],
          c[11],
          c[12],
          static_cast<long>(c[13]),
          static_cast<long>(c[14]),
          static_cast<long>(c[15])};
}

}  // namespace tandem::test
