// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem {

/// The words of take_stepper(). A client of a server may set all but those that take the machine's threads.
Words stepper_words();

/// The settings of a stepper among the parameters. Throws Error for a value that is not allowed.
mbs::StepperSettings take_stepper(Parameters& parameters);

}  // namespace tandem
