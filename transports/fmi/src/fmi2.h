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

/* FUNCTION(result, name, arguments) of every function: what both kinds have; what goes with an ability; what
 * one kind has. */
#define TANDEM_FMI2_COMMON(FUNCTION)                                                                         \
  FUNCTION(const char*, GetVersion, (void))                                                                  \
  FUNCTION(fmi2Component, Instantiate,                                                                       \
           (fmi2String name, fmi2Type, fmi2String guid, fmi2String resources, const fmi2CallbackFunctions*,  \
            fmi2Boolean visible, fmi2Boolean logging))                                                       \
  FUNCTION(void, FreeInstance, (fmi2Component))                                                              \
  FUNCTION(fmi2Status, SetupExperiment,                                                                      \
           (fmi2Component, fmi2Boolean tolerance_defined, fmi2Real tolerance, fmi2Real start,                \
            fmi2Boolean stop_defined, fmi2Real stop))                                                        \
  FUNCTION(fmi2Status, EnterInitializationMode, (fmi2Component))                                             \
  FUNCTION(fmi2Status, ExitInitializationMode, (fmi2Component))                                              \
  FUNCTION(fmi2Status, Terminate, (fmi2Component))                                                           \
  FUNCTION(fmi2Status, Reset, (fmi2Component))                                                               \
  FUNCTION(fmi2Status, GetReal, (fmi2Component, const fmi2ValueReference[], size_t, fmi2Real[]))             \
  FUNCTION(fmi2Status, GetInteger, (fmi2Component, const fmi2ValueReference[], size_t, fmi2Integer[]))       \
  FUNCTION(fmi2Status, GetBoolean, (fmi2Component, const fmi2ValueReference[], size_t, fmi2Boolean[]))       \
  FUNCTION(fmi2Status, SetReal, (fmi2Component, const fmi2ValueReference[], size_t, const fmi2Real[]))       \
  FUNCTION(fmi2Status, SetInteger, (fmi2Component, const fmi2ValueReference[], size_t, const fmi2Integer[])) \
  FUNCTION(fmi2Status, SetBoolean, (fmi2Component, const fmi2ValueReference[], size_t, const fmi2Boolean[])) \
  FUNCTION(fmi2Status, SetString, (fmi2Component, const fmi2ValueReference[], size_t, const fmi2String[]))

#define TANDEM_FMI2_STATES(FUNCTION)                                \
  FUNCTION(fmi2Status, GetFMUstate, (fmi2Component, fmi2FMUstate*)) \
  FUNCTION(fmi2Status, SetFMUstate, (fmi2Component, fmi2FMUstate))  \
  FUNCTION(fmi2Status, FreeFMUstate, (fmi2Component, fmi2FMUstate*))

#define TANDEM_FMI2_BYTES(FUNCTION)                                                          \
  FUNCTION(fmi2Status, SerializedFMUstateSize, (fmi2Component, fmi2FMUstate, size_t*))       \
  FUNCTION(fmi2Status, SerializeFMUstate, (fmi2Component, fmi2FMUstate, fmi2Byte[], size_t)) \
  FUNCTION(fmi2Status, DeSerializeFMUstate, (fmi2Component, const fmi2Byte[], size_t, fmi2FMUstate*))

#define TANDEM_FMI2_MODEL_EXCHANGE(FUNCTION)                                             \
  FUNCTION(fmi2Status, EnterEventMode, (fmi2Component))                                  \
  FUNCTION(fmi2Status, NewDiscreteStates, (fmi2Component, fmi2EventInfo*))               \
  FUNCTION(fmi2Status, EnterContinuousTimeMode, (fmi2Component))                         \
  FUNCTION(fmi2Status, CompletedIntegratorStep,                                          \
           (fmi2Component, fmi2Boolean no_return_before, fmi2Boolean * enter_event_mode, \
            fmi2Boolean * terminate))                                                    \
  FUNCTION(fmi2Status, SetTime, (fmi2Component, fmi2Real))                               \
  FUNCTION(fmi2Status, SetContinuousStates, (fmi2Component, const fmi2Real[], size_t))   \
  FUNCTION(fmi2Status, GetContinuousStates, (fmi2Component, fmi2Real[], size_t))         \
  FUNCTION(fmi2Status, GetDerivatives, (fmi2Component, fmi2Real[], size_t))              \
  FUNCTION(fmi2Status, GetEventIndicators, (fmi2Component, fmi2Real[], size_t))

#define TANDEM_FMI2_INPUT_DERIVATIVES(FUNCTION) \
  FUNCTION(                                     \
      fmi2Status, SetRealInputDerivatives,      \
      (fmi2Component, const fmi2ValueReference[], size_t, const fmi2Integer orders[], const fmi2Real[]))

#define TANDEM_FMI2_CO_SIMULATION(FUNCTION)                                               \
  FUNCTION(fmi2Status, DoStep,                                                            \
           (fmi2Component, fmi2Real time, fmi2Real length, fmi2Boolean no_return_before)) \
  FUNCTION(fmi2Status, GetRealStatus, (fmi2Component, fmi2StatusKind, fmi2Real*))         \
  FUNCTION(fmi2Status, GetBooleanStatus, (fmi2Component, fmi2StatusKind, fmi2Boolean*))

#ifdef __cplusplus
}
#endif
#endif
