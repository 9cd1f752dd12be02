/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* The C interface of an FMU of version 3.0, by the names and numbers of the standard (Functional Mock-up
 * Interface 3.0, chapters 2 to 4), as far as it is called here and version 2.0 has it otherwise. */
#ifndef TANDEM_FMI3_H
#define TANDEM_FMI3_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef void* fmi3Instance;
typedef void* fmi3InstanceEnvironment;
typedef void* fmi3FMUState;
typedef uint32_t fmi3ValueReference;
typedef const char* fmi3String;
typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;

typedef void (*fmi3LogMessageCallback)(fmi3InstanceEnvironment, fmi3Status, fmi3String category,
                                       fmi3String message);
typedef void (*fmi3IntermediateUpdateCallback)(fmi3InstanceEnvironment, double time, bool set_requested,
                                               bool get_allowed, bool step_finished, bool can_return_early,
                                               bool* return_early, double* return_time);

typedef fmi3Instance fmi3InstantiateModelExchangeType(fmi3String name, fmi3String token, fmi3String resources,
                                                      bool visible, bool logging, fmi3InstanceEnvironment,
                                                      fmi3LogMessageCallback);
typedef fmi3Instance fmi3InstantiateCoSimulationType(fmi3String name, fmi3String token, fmi3String resources,
                                                     bool visible, bool logging, bool event_mode,
                                                     bool early_return,
                                                     const fmi3ValueReference intermediate[], size_t,
                                                     fmi3InstanceEnvironment, fmi3LogMessageCallback,
                                                     fmi3IntermediateUpdateCallback);
typedef fmi3Status fmi3EnterInitializationModeType(fmi3Instance, bool tolerance_defined, double tolerance,
                                                   double start, bool stop_defined, double stop);

typedef fmi3Status fmi3SetStringType(fmi3Instance, const fmi3ValueReference[], size_t, const fmi3String[],
                                     size_t);
typedef fmi3Status fmi3UpdateDiscreteStatesType(fmi3Instance, bool* again, bool* terminate,
                                                bool* nominals_changed, bool* states_changed,
                                                bool* next_event_defined, double* next_event);
typedef fmi3Status fmi3CompletedIntegratorStepType(fmi3Instance, bool no_return_before,
                                                   bool* enter_event_mode, bool* terminate);
typedef fmi3Status fmi3GetDirectionalDerivativeType(fmi3Instance, const fmi3ValueReference unknowns[], size_t,
                                                    const fmi3ValueReference knowns[], size_t,
                                                    const double seed[], size_t, double found[], size_t);
typedef fmi3Status fmi3GetOutputDerivativesType(fmi3Instance, const fmi3ValueReference[], size_t,
                                                const int32_t orders[], double[], size_t);
typedef fmi3Status fmi3DoStepType(fmi3Instance, double time, double length, bool no_return_before,
                                  bool* event_needed, bool* terminate, bool* early_return, double* reached);

#ifdef __cplusplus
}
#endif
#endif
