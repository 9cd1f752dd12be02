/* Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause */
/* The C interface of an FMU of version 2.0, by the names and numbers of the standard (FMI for Model Exchange
 * and Co-Simulation 2.0, chapters 2 to 4), as far as it is called here. Platform "default": double, int,
 * const char*. */
#ifndef TANDEM_FMI2_H
#define TANDEM_FMI2_H
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef void* fmi2Component;
typedef void* fmi2ComponentEnvironment;
typedef void* fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef const char* fmi2String;
typedef char fmi2Byte;

enum { fmi2False = 0, fmi2True = 1 };
typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated } fmi2StatusKind;

typedef struct {
  void (*logger)(fmi2ComponentEnvironment, fmi2String instance, fmi2Status, fmi2String category,
                 fmi2String message, ...);
  void* (*allocateMemory)(size_t count, size_t size);
  void (*freeMemory)(void*);
  void (*stepFinished)(fmi2ComponentEnvironment, fmi2Status);
  fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;

typedef struct {
  fmi2Boolean newDiscreteStatesNeeded;
  fmi2Boolean terminateSimulation;
  fmi2Boolean nominalsOfContinuousStatesChanged;
  fmi2Boolean valuesOfContinuousStatesChanged;
  fmi2Boolean nextEventTimeDefined;
  fmi2Real nextEventTime;
} fmi2EventInfo;

/* Functions of which version 3.0 has others, or none. */
typedef fmi2Component fmi2InstantiateType(fmi2String name, fmi2Type, fmi2String guid, fmi2String resources,
                                          const fmi2CallbackFunctions*, fmi2Boolean visible,
                                          fmi2Boolean logging);
typedef fmi2Status fmi2SetupExperimentType(fmi2Component, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                                           fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop);
typedef fmi2Status fmi2EnterInitializationModeType(fmi2Component);
typedef fmi2Status fmi2GetRealType(fmi2Component, const fmi2ValueReference[], size_t, fmi2Real[]);
typedef fmi2Status fmi2GetIntegerType(fmi2Component, const fmi2ValueReference[], size_t, fmi2Integer[]);
typedef fmi2Status fmi2SetRealType(fmi2Component, const fmi2ValueReference[], size_t, const fmi2Real[]);
typedef fmi2Status fmi2SetIntegerType(fmi2Component, const fmi2ValueReference[], size_t, const fmi2Integer[]);
typedef fmi2Status fmi2SetStringType(fmi2Component, const fmi2ValueReference[], size_t, const fmi2String[]);
typedef fmi2Status fmi2NewDiscreteStatesType(fmi2Component, fmi2EventInfo*);
typedef fmi2Status fmi2CompletedIntegratorStepType(fmi2Component, fmi2Boolean no_return_before,
                                                   fmi2Boolean* enter_event_mode, fmi2Boolean* terminate);
typedef fmi2Status fmi2GetDirectionalDerivativeType(fmi2Component, const fmi2ValueReference unknowns[],
                                                    size_t, const fmi2ValueReference knowns[], size_t,
                                                    const fmi2Real seed[], fmi2Real found[]);
typedef fmi2Status fmi2SetRealInputDerivativesType(fmi2Component, const fmi2ValueReference[], size_t,
                                                   const fmi2Integer orders[], const fmi2Real[]);
typedef fmi2Status fmi2GetRealOutputDerivativesType(fmi2Component, const fmi2ValueReference[], size_t,
                                                    const fmi2Integer orders[], fmi2Real[]);
typedef fmi2Status fmi2DoStepType(fmi2Component, fmi2Real time, fmi2Real length,
                                  fmi2Boolean no_return_before);
typedef fmi2Status fmi2GetRealStatusType(fmi2Component, fmi2StatusKind, fmi2Real*);
typedef fmi2Status fmi2GetBooleanStatusType(fmi2Component, fmi2StatusKind, fmi2Boolean*);

#ifdef __cplusplus
}
#endif
#endif
