// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The functions of an FMU of version 3.0 (Functional Mock-up Interface 3.0, chapters 2 and 4) but for those
// of Model Exchange.
#include "fmi3.h"

#include "instance.hpp"
#include "tandem/error.hpp"

namespace {

using tandem::exported::Instance;
using References = const fmi3ValueReference*;

template <class Work>
fmi3Status with(fmi3Instance c, const Work& work) {
  return tandem::exported::with<fmi3Status>(c, work);
}

Instance::Log log_of(fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger) {
  return [environment, logger](int status, const std::string& text) {
    if (logger)
      logger(environment, static_cast<fmi3Status>(status),
             status == Instance::warning ? "logStatusWarning" : "logStatusError", text.c_str());
  };
}

/// work(instance, value reference, place) for each variable, of which each is one value.
template <class Work>
fmi3Status access(fmi3Instance c, References v, size_t variables, size_t values, const Work& work) {
  const auto all = [&](Instance& i) {
    if (variables != values)
      throw tandem::Error(tandem::ErrorCode::invalid_argument, std::to_string(values) + " values belong to " +
                                                                   std::to_string(variables) +
                                                                   " variables; allowed is one for each");
    tandem::exported::each(v, variables, [&](auto ref, auto k) { work(i, ref, k); });
  };
  return tandem::exported::with<fmi3Status>(c, all, true);
}

fmi3Status refuse_call(fmi3Instance c, const char* name) {
  return with(c, [name](Instance&) {
    throw tandem::Error(tandem::ErrorCode::not_supported,
                        std::string(name) + " is called; this FMU has no such thing");
  });
}

}  // namespace

/// What an FMU without clocks and derivatives of its variables has not.
#define TANDEM_REFUSED(name, ...) \
  TANDEM_FMI fmi3Status name(fmi3Instance c __VA_OPT__(, ) __VA_ARGS__) { return refuse_call(c, #name); }
/// Access to a type that none of its variables has.
#define TANDEM_NO_VALUES(type, ...)                                                              \
  TANDEM_FMI fmi3Status fmi3Get##type(fmi3Instance c, References, size_t n, __VA_ARGS__) {       \
    return n == 0 ? fmi3OK : refuse_call(c, "fmi3Get" #type);                                    \
  }                                                                                              \
  TANDEM_FMI fmi3Status fmi3Set##type(fmi3Instance c, References, size_t n, const __VA_ARGS__) { \
    return n == 0 ? fmi3OK : refuse_call(c, "fmi3Set" #type);                                    \
  }

TANDEM_FMI const char* fmi3GetVersion() { return "3.0"; }
/// Errors and warnings are told always, there is nothing else.
TANDEM_FMI fmi3Status fmi3SetDebugLogging(fmi3Instance, bool, size_t, const fmi3String[]) { return fmi3OK; }

TANDEM_FMI fmi3Instance fmi3InstantiateCoSimulation(fmi3String, fmi3String token, fmi3String resources, bool,
                                                    bool, bool, bool, const fmi3ValueReference[], size_t,
                                                    fmi3InstanceEnvironment environment,
                                                    fmi3LogMessageCallback logger,
                                                    fmi3IntermediateUpdateCallback) {
  const auto log = log_of(environment, logger);
  if (!resources) return log(Instance::error, tandem::exported::no_resources), nullptr;
  return tandem::exported::made(resources, token, tandem::exported::Interface::co_simulation, log);
}
TANDEM_FMI fmi3Instance fmi3InstantiateModelExchange(fmi3String, fmi3String token, fmi3String resources, bool,
                                                     bool, fmi3InstanceEnvironment environment,
                                                     fmi3LogMessageCallback logger) {
  const auto log = log_of(environment, logger);
  if (!resources) return log(Instance::error, tandem::exported::no_resources), nullptr;
  return tandem::exported::made(resources, token, tandem::exported::Interface::model_exchange, log);
}
TANDEM_FMI fmi3Instance fmi3InstantiateScheduledExecution(fmi3String, fmi3String, fmi3String, bool, bool,
                                                          fmi3InstanceEnvironment environment,
                                                          fmi3LogMessageCallback logger,
                                                          void (*)(fmi3InstanceEnvironment), void (*)(),
                                                          void (*)()) {
  return log_of(environment, logger)(Instance::error, "this FMU is not for Scheduled Execution"), nullptr;
}
TANDEM_FMI void fmi3FreeInstance(fmi3Instance c) { delete static_cast<Instance*>(c); }

TANDEM_FMI fmi3Status fmi3EnterInitializationMode(fmi3Instance c, bool, double, double start, bool has_stop,
                                                  double stop) {
  return with(c, [=](Instance& i) { has_stop ? i.unit.set_span(start, stop) : i.unit.set_span(start); });
}
TANDEM_FMI fmi3Status fmi3ExitInitializationMode(fmi3Instance c) {
  return with(c, [](Instance& i) { i.unit.begin(); });
}
TANDEM_FMI fmi3Status fmi3EnterConfigurationMode(fmi3Instance c) {
  return with(c, [](Instance&) {});
}
TANDEM_FMI fmi3Status fmi3ExitConfigurationMode(fmi3Instance c) {
  return with(c, [](Instance&) {});
}
TANDEM_FMI fmi3Status fmi3Terminate(fmi3Instance c) {
  return with(c, [](Instance&) {});
}
TANDEM_FMI fmi3Status fmi3Reset(fmi3Instance c) {
  return with(c, [](Instance& i) { i.unit.reset(); });
}

TANDEM_FMI fmi3Status fmi3GetFloat64(fmi3Instance c, References v, size_t n, double to[], size_t values) {
  return access(c, v, n, values, [=](Instance& i, auto ref, auto k) { to[k] = i.unit.number(ref); });
}
TANDEM_FMI fmi3Status fmi3SetFloat64(fmi3Instance c, References v, size_t n, const double from[],
                                     size_t values) {
  return access(c, v, n, values, [=](Instance& i, auto ref, auto k) { i.unit.set(ref, from[k]); });
}
TANDEM_FMI fmi3Status fmi3GetBoolean(fmi3Instance c, References v, size_t n, bool to[], size_t values) {
  return access(c, v, n, values, [=](Instance& i, auto ref, auto k) { to[k] = i.unit.flag(ref); });
}
TANDEM_FMI fmi3Status fmi3SetBoolean(fmi3Instance c, References v, size_t n, const bool from[],
                                     size_t values) {
  return access(c, v, n, values, [=](Instance& i, auto ref, auto k) { i.unit.set(ref, from[k]); });
}
TANDEM_FMI fmi3Status fmi3GetString(fmi3Instance c, References v, size_t n, fmi3String to[], size_t values) {
  return access(c, v, n, values, [=](Instance& i, auto ref, auto k) { to[k] = i.text(ref).c_str(); });
}
TANDEM_FMI fmi3Status fmi3SetString(fmi3Instance c, References v, size_t n, const fmi3String from[],
                                    size_t values) {
  return access(c, v, n, values,
                [=](Instance& i, auto ref, auto k) { i.unit.set(ref, std::string(from[k] ? from[k] : "")); });
}
TANDEM_NO_VALUES(Float32, float[], size_t)
TANDEM_NO_VALUES(Int8, int8_t[], size_t)
TANDEM_NO_VALUES(UInt8, uint8_t[], size_t)
TANDEM_NO_VALUES(Int16, int16_t[], size_t)
TANDEM_NO_VALUES(UInt16, uint16_t[], size_t)
TANDEM_NO_VALUES(Int32, int32_t[], size_t)
TANDEM_NO_VALUES(UInt32, uint32_t[], size_t)
TANDEM_NO_VALUES(Int64, int64_t[], size_t)
TANDEM_NO_VALUES(UInt64, uint64_t[], size_t)
TANDEM_REFUSED(fmi3GetBinary, References, size_t, size_t[], const uint8_t*[], size_t)
TANDEM_REFUSED(fmi3SetBinary, References, size_t, const size_t[], const uint8_t* const[], size_t)
TANDEM_REFUSED(fmi3GetClock, References, size_t, bool[])
TANDEM_REFUSED(fmi3SetClock, References, size_t, const bool[])

TANDEM_FMI fmi3Status fmi3GetOutputDerivatives(fmi3Instance c, References v, size_t n, const int32_t order[],
                                               double to[], size_t values) {
  return access(c, v, n, values,
                [=](Instance& i, auto ref, auto k) { to[k] = i.stepped().derivative(ref, order[k]); });
}
TANDEM_FMI fmi3Status fmi3EnterStepMode(fmi3Instance c) {
  return with(c, [](Instance&) {});
}
TANDEM_FMI fmi3Status fmi3DoStep(fmi3Instance c, double time, double length, bool, bool* event_needed,
                                 bool* terminate, bool* early_return, double* reached) {
  *event_needed = *early_return = *terminate = false;
  const fmi3Status status = with(c, [=](Instance& i) { i.stepped().step(time, length); });
  if (c) *reached = static_cast<Instance*>(c)->unit.time();
  return status;
}

TANDEM_FMI fmi3Status fmi3GetFMUState(fmi3Instance c, fmi3FMUState* to) {
  return with(c, [=](Instance& i) { i.keep(*to); });
}
TANDEM_FMI fmi3Status fmi3SetFMUState(fmi3Instance c, fmi3FMUState from) {
  return with(c, [=](Instance& i) { i.unit.restore(Instance::kept(from)); });
}
TANDEM_FMI fmi3Status fmi3FreeFMUState(fmi3Instance c, fmi3FMUState* state) {
  return with(c, [=](Instance&) { Instance::forget(*state); });
}
TANDEM_FMI fmi3Status fmi3SerializedFMUStateSize(fmi3Instance c, fmi3FMUState state, size_t* to) {
  return with(c, [=](Instance&) { *to = Instance::kept(state).size(); });
}
TANDEM_FMI fmi3Status fmi3SerializeFMUState(fmi3Instance c, fmi3FMUState state, uint8_t to[], size_t size) {
  return with(c, [=](Instance&) { Instance::serialize(state, to, size); });
}
TANDEM_FMI fmi3Status fmi3DeserializeFMUState(fmi3Instance c, const uint8_t from[], size_t size,
                                              fmi3FMUState* to) {
  return with(c, [=](Instance&) { Instance::keep(from, size, *to); });
}

TANDEM_REFUSED(fmi3GetNumberOfVariableDependencies, fmi3ValueReference, size_t*)
TANDEM_REFUSED(fmi3GetVariableDependencies, fmi3ValueReference, size_t[], fmi3ValueReference[], size_t[],
               int[], size_t)
TANDEM_REFUSED(fmi3GetDirectionalDerivative, References, size_t, References, size_t, const double[], size_t,
               double[], size_t)
TANDEM_REFUSED(fmi3GetAdjointDerivative, References, size_t, References, size_t, const double[], size_t,
               double[], size_t)
TANDEM_REFUSED(fmi3GetIntervalDecimal, References, size_t, double[], int[])
TANDEM_REFUSED(fmi3GetIntervalFraction, References, size_t, uint64_t[], uint64_t[], int[])
TANDEM_REFUSED(fmi3GetShiftDecimal, References, size_t, double[])
TANDEM_REFUSED(fmi3GetShiftFraction, References, size_t, uint64_t[], uint64_t[])
TANDEM_REFUSED(fmi3SetIntervalDecimal, References, size_t, const double[])
TANDEM_REFUSED(fmi3SetIntervalFraction, References, size_t, const uint64_t[], const uint64_t[])
TANDEM_REFUSED(fmi3SetShiftDecimal, References, size_t, const double[])
TANDEM_REFUSED(fmi3SetShiftFraction, References, size_t, const uint64_t[], const uint64_t[])
TANDEM_REFUSED(fmi3EvaluateDiscreteStates)
TANDEM_REFUSED(fmi3ActivateModelPartition, fmi3ValueReference, double)
