// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// tandem/fixed_step.h in C++.
#include <gtest/gtest.h>

#include "tandem/c_subsystem.hpp"
#include "tandem/fixed_step.h"

namespace tandem {
namespace {

const tandem_parameter parameters[] = {{"slope", "m/s", "2", "of the ramp"}, {"h", "s", "0.25", "own step"}};
const tandem_port outputs[] = {{"x", "m", 1, 1, NAN}};

/// x' = slope.
tandem_model ramp_model() {
  tandem_model ramp{};
  ramp.info.name = "ramp";
  ramp.info.outputs = outputs;
  ramp.info.output_count = 1;
  ramp.parameters = parameters;
  ramp.parameter_count = 2;
  ramp.state_size = sizeof(double);
  ramp.own_step = [](const tandem_instance* self) { return self->p[1]; };
  ramp.start = [](tandem_instance* self, double, const double*) {
    *static_cast<double*>(self->state) = 0.0;
    return TANDEM_OK;
  };
  ramp.step = [](tandem_instance* self, tandem_own_step* own, const tandem_signal*) {
    *static_cast<double*>(self->state) += self->p[0] * own->length;
    return TANDEM_OK;
  };
  ramp.outputs = [](const tandem_instance* self, double* y) {
    y[0] = *static_cast<const double*>(self->state);
    y[1] = self->p[0];
  };
  return ramp;
}
const tandem_model ramp = ramp_model();

}  // namespace

TANDEM_EXPORT_FIXED_STEP(tandem_ramp_in_cpp, ramp)

namespace {

TEST(CModelInCpp, IsAModelAsInC) {
  CSubsystem s(tandem_ramp_in_cpp(), "slope=4");
  double rows[4 * 8];
  Samples y(rows, 4, 8);
  s.initialize(1.0, 2.0, {}, y);
  s.advance(1.6, true, {}, y);
  ASSERT_EQ(y.size(), 4);
  EXPECT_EQ(y.time(3), 1.6);
  EXPECT_NEAR(y.values(3)[0], 2.4, 1e-15);
  EXPECT_EQ(y.values(3)[1], 4.0);
}

}  // namespace
}  // namespace tandem
