// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The functions of an FMU of version 2.0 (FMI for Model Exchange and Co-Simulation 2.0, chapters 2 and 4) but
// for those of Model Exchange.
#include "fmi2.h"

#include <cstring>

#include "instance.hpp"
#include "tandem/error.hpp"

namespace {

using tandem::exported::Instance;
using References = const fmi2ValueReference*;

template <class Work>
fmi2Status with(fmi2Component c, const Work& work) {
  return tandem::exported::with<fmi2Status>(c, work);
}
/// work(instance, value reference, place) for each variable.
template <class Work>
fmi2Status access(fmi2Component c, References v, size_t count, const Work& work) {
  const auto all = [&](Instance& i) {
    tandem::exported::each(v, count, [&](auto ref, auto k) { work(i, ref, k); });
  };
  return tandem::exported::with<fmi2Status>(c, all, true);
}

[[noreturn]] void refuse(const std::string& sentence) {
  throw tandem::Error(tandem::ErrorCode::not_supported, sentence);
}

/// The folder of "file:///a/b%20c", "file://host/a" or "file:/a"; what is no URI is a path.
std::filesystem::path folder_of(std::string uri) {
  if (!uri.starts_with("file:")) return uri;
  uri.erase(0, std::strlen("file:"));
  if (uri.starts_with("//")) uri.erase(0, uri.find('/', 2));
  std::string path;
  for (std::size_t k = 0; k < uri.size(); ++k)
    if (uri[k] == '%' && k + 2 < uri.size())
      path += static_cast<char>(std::stoi(uri.substr(k + 1, 2), nullptr, 16)), k += 2;
    else
      path += uri[k];
  return path;
}

fmi2Status refuse_call(fmi2Component c, const char* name) {
  return with(c, [name](Instance&) { refuse(std::string(name) + " is called; this FMU has no such thing"); });
}

Instance::Log log_of(const fmi2CallbackFunctions* callbacks, const char* name) {
  if (!callbacks || !callbacks->logger) return [](int, const std::string&) {};
  return [logger = callbacks->logger, environment = callbacks->componentEnvironment,
          own = std::string(name ? name : "")](int status, const std::string& text) {
    logger(environment, own.c_str(), static_cast<fmi2Status>(status),
           status == Instance::warning ? "logStatusWarning" : "logStatusError", "%s", text.c_str());
  };
}

}  // namespace

TANDEM_FMI const char* fmi2GetTypesPlatform() { return "default"; }
TANDEM_FMI const char* fmi2GetVersion() { return "2.0"; }

/// Errors and warnings are told always, there is nothing else.
TANDEM_FMI fmi2Status fmi2SetDebugLogging(fmi2Component, fmi2Boolean, size_t, const fmi2String[]) {
  return fmi2OK;
}

TANDEM_FMI fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid,
                                         fmi2String resources, const fmi2CallbackFunctions* callbacks,
                                         fmi2Boolean, fmi2Boolean) {
  const auto log = log_of(callbacks, name);
  if (!resources) return log(Instance::error, tandem::exported::no_resources), nullptr;
  try {
    return tandem::exported::made(folder_of(resources), guid,
                                  type == fmi2ModelExchange ? tandem::exported::Interface::model_exchange
                                                            : tandem::exported::Interface::co_simulation,
                                  log);
  } catch (const std::exception& what) {
    return log(Instance::error, what.what()), nullptr;
  }
}
TANDEM_FMI void fmi2FreeInstance(fmi2Component c) { delete static_cast<Instance*>(c); }

TANDEM_FMI fmi2Status fmi2SetupExperiment(fmi2Component c, fmi2Boolean, fmi2Real, fmi2Real start,
                                          fmi2Boolean has_stop, fmi2Real stop) {
  return with(c, [=](Instance& i) { has_stop ? i.unit.set_span(start, stop) : i.unit.set_span(start); });
}
TANDEM_FMI fmi2Status fmi2EnterInitializationMode(fmi2Component c) {
  return with(c, [](Instance&) {});
}
TANDEM_FMI fmi2Status fmi2ExitInitializationMode(fmi2Component c) {
  return with(c, [](Instance& i) { i.unit.begin(); });
}
TANDEM_FMI fmi2Status fmi2Terminate(fmi2Component c) {
  return with(c, [](Instance&) {});
}
TANDEM_FMI fmi2Status fmi2Reset(fmi2Component c) {
  return with(c, [](Instance& i) { i.unit.reset(); });
}

TANDEM_FMI fmi2Status fmi2GetReal(fmi2Component c, References v, size_t n, fmi2Real to[]) {
  return access(c, v, n, [=](Instance& i, auto ref, auto k) { to[k] = i.unit.number(ref); });
}
TANDEM_FMI fmi2Status fmi2SetReal(fmi2Component c, References v, size_t n, const fmi2Real from[]) {
  return access(c, v, n, [=](Instance& i, auto ref, auto k) { i.unit.set(ref, from[k]); });
}
TANDEM_FMI fmi2Status fmi2GetBoolean(fmi2Component c, References v, size_t n, fmi2Boolean to[]) {
  return access(c, v, n, [=](Instance& i, auto ref, auto k) { to[k] = i.unit.flag(ref); });
}
TANDEM_FMI fmi2Status fmi2SetBoolean(fmi2Component c, References v, size_t n, const fmi2Boolean from[]) {
  return access(c, v, n, [=](Instance& i, auto ref, auto k) { i.unit.set(ref, from[k] != 0); });
}
TANDEM_FMI fmi2Status fmi2GetString(fmi2Component c, References v, size_t n, fmi2String to[]) {
  return access(c, v, n, [=](Instance& i, auto ref, auto k) { to[k] = i.text(ref).c_str(); });
}
TANDEM_FMI fmi2Status fmi2SetString(fmi2Component c, References v, size_t n, const fmi2String from[]) {
  return access(c, v, n,
                [=](Instance& i, auto ref, auto k) { i.unit.set(ref, std::string(from[k] ? from[k] : "")); });
}
TANDEM_FMI fmi2Status fmi2GetInteger(fmi2Component c, References, size_t n, fmi2Integer[]) {
  return n == 0 ? fmi2OK : refuse_call(c, "fmi2GetInteger");
}
TANDEM_FMI fmi2Status fmi2SetInteger(fmi2Component c, References, size_t n, const fmi2Integer[]) {
  return n == 0 ? fmi2OK : refuse_call(c, "fmi2SetInteger");
}

TANDEM_FMI fmi2Status fmi2SetRealInputDerivatives(fmi2Component c, References v, size_t n,
                                                  const fmi2Integer order[], const fmi2Real from[]) {
  return access(c, v, n,
                [=](Instance& i, auto ref, auto k) { i.stepped().set_derivative(ref, order[k], from[k]); });
}
TANDEM_FMI fmi2Status fmi2GetRealOutputDerivatives(fmi2Component c, References v, size_t n,
                                                   const fmi2Integer order[], fmi2Real to[]) {
  return access(c, v, n,
                [=](Instance& i, auto ref, auto k) { to[k] = i.stepped().derivative(ref, order[k]); });
}

TANDEM_FMI fmi2Status fmi2DoStep(fmi2Component c, fmi2Real time, fmi2Real length, fmi2Boolean) {
  return with(c, [=](Instance& i) { i.stepped().step(time, length); });
}
TANDEM_FMI fmi2Status fmi2CancelStep(fmi2Component c) { return refuse_call(c, "fmi2CancelStep"); }
TANDEM_FMI fmi2Status fmi2GetStatus(fmi2Component c, fmi2StatusKind, fmi2Status*) {
  return refuse_call(c, "fmi2GetStatus");
}
TANDEM_FMI fmi2Status fmi2GetRealStatus(fmi2Component c, fmi2StatusKind kind, fmi2Real* to) {
  if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
  return with(c, [=](Instance& i) { *to = i.unit.time(); });
}
TANDEM_FMI fmi2Status fmi2GetIntegerStatus(fmi2Component, fmi2StatusKind, fmi2Integer*) {
  return fmi2Discard;
}
TANDEM_FMI fmi2Status fmi2GetBooleanStatus(fmi2Component c, fmi2StatusKind kind, fmi2Boolean* to) {
  if (kind != fmi2Terminated) return fmi2Discard;
  return with(c, [=](Instance&) { *to = fmi2False; });
}
TANDEM_FMI fmi2Status fmi2GetStringStatus(fmi2Component, fmi2StatusKind, fmi2String*) { return fmi2Discard; }

TANDEM_FMI fmi2Status fmi2GetFMUstate(fmi2Component c, fmi2FMUstate* to) {
  return with(c, [=](Instance& i) { i.keep(*to); });
}
TANDEM_FMI fmi2Status fmi2SetFMUstate(fmi2Component c, fmi2FMUstate from) {
  return with(c, [=](Instance& i) { i.unit.restore(Instance::kept(from)); });
}
TANDEM_FMI fmi2Status fmi2FreeFMUstate(fmi2Component c, fmi2FMUstate* state) {
  return with(c, [=](Instance&) { Instance::forget(*state); });
}
TANDEM_FMI fmi2Status fmi2SerializedFMUstateSize(fmi2Component c, fmi2FMUstate state, size_t* to) {
  return with(c, [=](Instance&) { *to = Instance::kept(state).size(); });
}
TANDEM_FMI fmi2Status fmi2SerializeFMUstate(fmi2Component c, fmi2FMUstate state, fmi2Byte to[], size_t size) {
  return with(c, [=](Instance&) { Instance::serialize(state, to, size); });
}
TANDEM_FMI fmi2Status fmi2DeSerializeFMUstate(fmi2Component c, const fmi2Byte from[], size_t size,
                                              fmi2FMUstate* to) {
  return with(c, [=](Instance&) { Instance::keep(from, size, *to); });
}
TANDEM_FMI fmi2Status fmi2GetDirectionalDerivative(fmi2Component c, References, size_t, References, size_t,
                                                   const fmi2Real[], fmi2Real[]) {
  return refuse_call(c, "fmi2GetDirectionalDerivative");
}
