// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "instance.hpp"
#include "tandem/subsystem.hpp"

namespace tandem::fmi {

/// An FMU of Model Exchange, integrated by ClassicalSteps with inputs read at each stage.
std::unique_ptr<Subsystem> make_model_exchange(std::shared_ptr<Instance> instance);

}  // namespace tandem::fmi
