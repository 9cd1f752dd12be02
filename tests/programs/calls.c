/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* calls URI: prints the names and units of a subsystem of one input and one output, and drives it from C to
 * t = 10 s. Its error goes to standard error, with the status 1. */
#include <stdio.h>

#include "tandem/peer.h"

static void print_ports(const tandem_port* ports, int32_t count) {
  int32_t k;
  for (k = 0; k < count; ++k) printf(" %s [%s]", ports[k].name, ports[k].unit);
}

static void print_info(const tandem_info* info) {
  printf("%s", info->name);
  print_ports(info->inputs, info->input_count);
  print_ports(info->outputs, info->output_count);
  printf("\n");
}

int main(int argc, char* argv[]) {
  const tandem_subsystem_api* const api = tandem_remote();
  const double u0 = 0.0;
  double rows[3 * 200];
  tandem_samples y = {rows, 3, 200, 0};
  tandem_clock clock;
  tandem_status status;
  void* self = NULL;
  int k;
  if (argc != 2) return 2;
  status = api->create(argv[1], &self);
  if (status == TANDEM_OK) {
    print_info(api->info(self));
    status = api->initialize(self, 0.0, 10.0, &u0, &y, &clock);
  }
  for (k = 1; k <= 20 && status == TANDEM_OK; ++k) {
    const tandem_segment piece = {0.5 * k, 0.0, {1.0}};
    const tandem_signal u = {&piece, 1, 0, NULL};
    status = api->advance(self, 0.5 * k, 0, &u, &y, &clock);
  }
  if (status != TANDEM_OK) fprintf(stderr, "%s\n", api->last_error(self));
  api->destroy(self);
  return status == TANDEM_OK ? 0 : 1;
}
