// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cctype>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "fmi2.h"
#include "instance.hpp"

namespace tandem::fmi {
namespace {

/// A path as a URI: what is no plain character stands as %XX.
std::string uri_of(const std::string& path) {
  constexpr std::string_view plain = "/-_.~", digits = "0123456789ABCDEF";
  std::string uri = "file://";
  for (const unsigned char c : path)
    if (std::isalnum(c) || plain.find(static_cast<char>(c)) != std::string_view::npos)
      uri += static_cast<char>(c);
    else
      uri += {'%', digits[c >> 4], digits[c & 15]};
  return uri;
}

/// fmi2CallbackFunctions::logger. `log`: a Log.
void write_log(fmi2ComponentEnvironment log, fmi2String, fmi2Status status, fmi2String, fmi2String message,
               ...) {
  if (!log || !message) return;
  std::array<char, 4096> text{};
  std::va_list values;
  va_start(values, message);
  std::vsnprintf(text.data(), text.size(), message, values);
  va_end(values);
  static_cast<Log*>(log)->add(static_cast<Status>(status), text.data());
}

/// Of FMI 2.0.
class InstanceOf2 final : public Instance {
 public:
  InstanceOf2(Fmu fmu, Tell tell)
      : Instance(std::move(fmu), std::move(tell)),
        resources_uri_(uri_of(resources())),
        callbacks_{write_log, std::calloc, std::free, nullptr, &log()} {
    const auto& all = this->fmu().description.variables;
    own_time_ = std::find_if(all.begin(), all.end(),
                             [](const Variable& v) {
                               return v.causality == Causality::independent && v.type == Type::float64;
                             }) -
                all.begin();
    open();
  }
  ~InstanceOf2() override { close(); }

  void get(Type type, References of, std::span<double> values) override {
    if (type == Type::float64) return call(get_real_, of.data(), of.size(), values.data());
    wholes_.resize(of.size());
    call(type == Type::boolean ? get_boolean_ : get_integer_, of.data(), of.size(), wholes_.data());
    std::copy(wholes_.begin(), wholes_.end(), values.begin());
  }
  void set(Type type, References of, std::span<const double> values) override {
    if (type == Type::float64) return call(set_real_, of.data(), of.size(), values.data());
    wholes_.resize(of.size());
    std::transform(values.begin(), values.end(), wholes_.begin(),
                   [](double v) { return static_cast<int>(v); });
    call(type == Type::boolean ? set_boolean_ : set_integer_, of.data(), of.size(), wholes_.data());
  }

  Updated update() override;
  Completed complete_step(bool never_back) override;
  void set_input_derivatives(References of, std::span<const int> orders,
                             std::span<const double> values) override {
    call(set_input_derivatives_, of.data(), of.size(), orders.data(), values.data());
  }
  void get_output_derivatives(References of, std::span<const int> orders, std::span<double> values) override {
    call(get_output_derivatives_, of.data(), of.size(), orders.data(), values.data());
  }
  void derive(References unknowns, References knowns, std::span<const double> seed,
              std::span<double> found) override {
    call(derive_, unknowns.data(), unknowns.size(), knowns.data(), knowns.size(), seed.data(), found.data());
  }
  void enter_steps() override {}
  Taken do_step(const OwnStep& s, bool never_back, InputsWithin&) override;

 private:
  const char* prefix() const override { return "fmi2"; }
  const char* version() const override { return "2.0"; }
  void find_functions() override;
  void* instantiate() override {
    const fmi2Type type = exchanges() ? fmi2ModelExchange : fmi2CoSimulation;
    const Description& d = fmu().description;
    return instantiate_.call(d.name.c_str(), type, d.guid.c_str(), resources_uri_.c_str(), &callbacks_,
                             fmi2False, fmu().settings.logs);
  }
  void set_up(double t_start, std::optional<double> t_stop) override {
    const auto& tolerance = fmu().settings.tolerance;
    call(set_up_, tolerance ? fmi2True : fmi2False, tolerance.value_or(0.0), t_start,
         t_stop ? fmi2True : fmi2False, t_stop.value_or(0.0));
  }
  void set_text(std::uint32_t reference, const std::string& text) override {
    const char* const value = text.c_str();
    call(set_text_, &reference, std::size_t{1}, &value);
  }
  void enter_initialization() override { call(enter_initialization_); }
  Taken discarded(const OwnStep& s);
  double own_time() {
    double now = 0.0;
    call(get_real_, &fmu().description.variables[static_cast<std::size_t>(own_time_)].reference,
         std::size_t{1}, &now);
    return now;
  }

  std::string resources_uri_;
  fmi2CallbackFunctions callbacks_;
  std::vector<int> wholes_;
  std::ptrdiff_t own_time_;  ///< the variable that is the FMU's time, if there is one
  Function<fmi2InstantiateType> instantiate_;
  Function<fmi2SetupExperimentType> set_up_;
  Function<fmi2EnterInitializationModeType> enter_initialization_;
  Function<fmi2GetRealType> get_real_;
  Function<fmi2SetRealType> set_real_;
  Function<fmi2GetIntegerType> get_integer_, get_boolean_;
  Function<fmi2SetIntegerType> set_integer_, set_boolean_;
  Function<fmi2SetStringType> set_text_;
  Function<fmi2NewDiscreteStatesType> update_;
  Function<fmi2CompletedIntegratorStepType> complete_step_;
  Function<fmi2SetRealInputDerivativesType> set_input_derivatives_;
  Function<fmi2GetRealOutputDerivativesType> get_output_derivatives_;
  Function<fmi2GetDirectionalDerivativeType> derive_;
  Function<fmi2DoStepType> do_step_;
  Function<fmi2GetRealStatusType> real_status_;
  Function<fmi2GetBooleanStatusType> boolean_status_;
};

void InstanceOf2::find_functions() {
  find(instantiate_, "Instantiate"), find(set_up_, "SetupExperiment");
  find(enter_initialization_, "EnterInitializationMode");
  find(get_real_, "GetReal"), find(get_integer_, "GetInteger"), find(get_boolean_, "GetBoolean");
  find(set_real_, "SetReal"), find(set_integer_, "SetInteger"), find(set_boolean_, "SetBoolean");
  find(set_text_, "SetString");
  if (fmu().settings.derives_outputs) find(get_output_derivatives_, "GetRealOutputDerivatives");
  if (offer().interpolates_inputs) find(set_input_derivatives_, "SetRealInputDerivatives");
  if (exchanges()) {
    find(update_, "NewDiscreteStates"), find(complete_step_, "CompletedIntegratorStep");
    if (offer().gives_derivatives) find(derive_, "GetDirectionalDerivative");
  } else {
    find(do_step_, "DoStep"), find(real_status_, "GetRealStatus"), find(boolean_status_, "GetBooleanStatus");
  }
}

Updated InstanceOf2::update() {
  fmi2EventInfo info{};
  call(update_, &info);
  return {
      info.newDiscreteStatesNeeded != fmi2False, info.terminateSimulation != fmi2False,
      info.nextEventTimeDefined != fmi2False ? info.nextEventTime : std::numeric_limits<double>::infinity()};
}

Completed InstanceOf2::complete_step(bool never_back) {
  fmi2Boolean event = fmi2False, ended = fmi2False;
  call(complete_step_, static_cast<fmi2Boolean>(never_back), &event, &ended);
  return {event != fmi2False, ended != fmi2False};
}

Taken InstanceOf2::do_step(const OwnStep& s, bool never_back, InputsWithin&) {
  const auto status = do_step_.call(component(), s.begin, s.length, static_cast<fmi2Boolean>(never_back));
  if (status == fmi2Discard) return discarded(s);
  check(do_step_.name, status);
  if (own_time_ < std::ssize(fmu().description.variables)) check_time(s, own_time());
  return {s.end, false, false};
}

/// Of a step that it has not taken to its end: it is one that ends there, or an error.
Taken InstanceOf2::discarded(const OwnStep& s) {
  fmi2Boolean terminated = fmi2False;
  double reached = s.begin;
  const bool told = boolean_status_.call(component(), fmi2Terminated, &terminated) <= fmi2Warning;
  if (!told || terminated == fmi2False) check(do_step_.name, fmi2Discard);
  call(real_status_, fmi2LastSuccessfulTime, &reached);
  return {std::clamp(reached, s.begin, s.end), false, true};
}

}  // namespace

std::shared_ptr<Instance> make_instance_of_2(Fmu fmu, Tell tell) {
  return std::make_shared<InstanceOf2>(std::move(fmu), std::move(tell));
}

}  // namespace tandem::fmi
