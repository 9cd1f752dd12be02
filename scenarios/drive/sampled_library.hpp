// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// What the libraries in C++ share.
#pragma once
#include <memory>
#include <string>

#include "tandem/sampled.hpp"
#include "tandem/transports/parameters.hpp"

inline double needed(tandem::Parameters& p, const std::string& name) {
  if (!p.has(name))
    throw tandem::Error(tandem::ErrorCode::invalid_argument, "the parameter '" + name + "' is needed");
  return p.number(name, 0.0);
}

template <class Model>
std::unique_ptr<tandem::Subsystem> make(const std::string& text) {
  tandem::Parameters parameters;
  if (!text.empty()) parameters.read(text, "parameters");
  auto subsystem = std::make_unique<tandem::Sampled<Model>>(Model(parameters));
  parameters.refuse_unused("parameters");
  return subsystem;
}
