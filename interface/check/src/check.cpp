// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/check.hpp"

#include "checks.hpp"
#include "tandem/error.hpp"
#include "tandem/nearest.hpp"

namespace tandem {
namespace {

std::vector<checks::Check> all() {
  std::vector<checks::Check> list;
  for (const auto* theme : {&checks::starts, &checks::steps, &checks::events, &checks::states,
                            &checks::samples, &checks::reactions})
    list.insert(list.end(), theme->begin(), theme->end());
  return list;
}

void run(const checks::Check& one, const checks::Subject& of, std::vector<Finding>& findings) {
  using enum Finding::Kind;
  try {
    one.run(of);
  } catch (const checks::LeftOut& why) {
    findings.push_back({left_out, one.name, why.what()});
  } catch (const checks::Broken& how) {
    findings.push_back({wrong, one.name, how.what()});
  } catch (const std::exception& error) {
    findings.push_back({wrong, one.name, std::string("it threw: ") + error.what()});
  }
}

}  // namespace

std::vector<std::string> check_names() {
  std::vector<std::string> names;
  for (const auto& one : all()) names.emplace_back(one.name);
  return names;
}

std::vector<Finding> check(const Opener& open, const CheckSettings& settings) {
  std::vector<Finding> findings;
  for (const auto& one : all()) run(one, {open, settings}, findings);
  return findings;
}

std::vector<Finding> check(const std::string& name, const Opener& open, const CheckSettings& settings) {
  std::vector<Finding> findings;
  for (const auto& one : all()) {
    if (one.name != name) continue;
    run(one, {open, settings}, findings);
    return findings;
  }
  throw Error(ErrorCode::invalid_argument, unknown("check", name, check_names()));
}

}  // namespace tandem
