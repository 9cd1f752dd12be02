// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <exception>
#include <filesystem>
#include <limits>

#include "access_of_3.hpp"
#include "fmi3.h"
#include "instance.hpp"

namespace tandem::fmi {
namespace {

/// Of FMI 3.0. Co-Simulation that has an event mode is run with it, and may return early.
class InstanceOf3 final : public Instance {
 public:
  InstanceOf3(Fmu fmu, Tell tell) : Instance(std::move(fmu), std::move(tell)) {
    for (const Seat& seat : this->fmu().ports.asked)
      asked_.push_back(this->fmu().description.at(seat.variable).reference);
    open();
  }
  ~InstanceOf3() override { close(); }

  void get(Type type, References of, std::span<double> values) override {
    access_.get(type, values, [&](const auto& function, auto* numbers) {
      call(function, of.data(), of.size(), numbers, values.size());
    });
  }
  void set(Type type, References of, std::span<const double> values) override {
    access_.set(type, values, [&](const auto& function, const auto* numbers) {
      call(function, of.data(), of.size(), numbers, values.size());
    });
  }

  Updated update() override;
  Completed complete_step(bool never_back) override;
  void set_input_derivatives(References, std::span<const int>, std::span<const double>) override {}
  void get_output_derivatives(References of, std::span<const int> orders, std::span<double> values) override {
    call(get_output_derivatives_, of.data(), of.size(), orders.data(), values.data(), values.size());
  }
  void derive(References unknowns, References knowns, std::span<const double> seed,
              std::span<double> found) override {
    call(derive_, unknowns.data(), unknowns.size(), knowns.data(), knowns.size(), seed.data(), seed.size(),
         found.data(), found.size());
  }
  void enter_steps() override { call(enter_steps_); }
  Taken do_step(const OwnStep& s, bool never_back, InputsWithin& inputs) override;

 private:
  const char* prefix() const override { return "fmi3"; }
  const char* version() const override { return "3."; }
  void find_functions() override;
  void* instantiate() override;
  void set_up(double t_start, std::optional<double> t_stop) override;
  void set_text(std::uint32_t reference, const std::string& text) override {
    const char* const value = text.c_str();
    call(set_text_, &reference, std::size_t{1}, &value, std::size_t{1});
  }
  void enter_initialization() override {
    const auto& tolerance = fmu().settings.tolerance;
    call(enter_initialization_, tolerance.has_value(), tolerance.value_or(0.0), t_start_, t_stop_.has_value(),
         t_stop_.value_or(0.0));
  }

  static void write_log(void* instance, fmi3Status status, const char*, const char* message) {
    if (message) static_cast<InstanceOf3*>(instance)->log().add(static_cast<Status>(status), message);
  }
  /// fmi3IntermediateUpdateCallback. Nothing is thrown through the FMU.
  static void within_step(void* instance, double time, bool set_requested, bool, bool, bool, bool* early,
                          double*);

  std::vector<std::uint32_t> asked_;
  Accesses access_;
  double t_start_ = 0.0;
  std::optional<double> t_stop_;
  InputsWithin* inputs_ = nullptr;  ///< while a step is taken
  std::exception_ptr failed_;       ///< within it
  Function<fmi3InstantiateModelExchangeType> instantiate_exchange_;
  Function<fmi3InstantiateCoSimulationType> instantiate_steps_;
  Function<fmi3EnterInitializationModeType> enter_initialization_;
  Call<> enter_configuration_, exit_configuration_, enter_steps_;
  Function<fmi3SetStringType> set_text_;
  Function<fmi3UpdateDiscreteStatesType> update_;
  Function<fmi3CompletedIntegratorStepType> complete_step_;
  Function<fmi3GetOutputDerivativesType> get_output_derivatives_;
  Function<fmi3GetDirectionalDerivativeType> derive_;
  Function<fmi3DoStepType> do_step_;
};

void InstanceOf3::find_functions() {
  access_.find([this](auto& function, const std::string& name) { find(function, name); });
  find(enter_initialization_, "EnterInitializationMode"), find(set_text_, "SetString");
  find(enter_configuration_, "EnterConfigurationMode"), find(exit_configuration_, "ExitConfigurationMode");
  if (exchanges() || offer().has_events) find(update_, "UpdateDiscreteStates");
  if (exchanges()) {
    find(instantiate_exchange_, "InstantiateModelExchange");
    find(complete_step_, "CompletedIntegratorStep");
    if (offer().gives_derivatives) find(derive_, "GetDirectionalDerivative");
  } else {
    find(instantiate_steps_, "InstantiateCoSimulation"), find(do_step_, "DoStep");
    if (offer().has_events) find(enter_steps_, "EnterStepMode");
    if (fmu().settings.derives_outputs) find(get_output_derivatives_, "GetOutputDerivatives");
  }
}

void* InstanceOf3::instantiate() {
  const Description& d = fmu().description;
  const std::string path = resources() + "/";
  const char* const folder = std::filesystem::is_empty(path) ? nullptr : path.c_str();
  const bool logs = fmu().settings.logs;
  if (exchanges())
    return instantiate_exchange_.call(d.name.c_str(), d.guid.c_str(), folder, false, logs, this, write_log);
  const bool asked = fmu().settings.held == Held::intermediate;
  return instantiate_steps_.call(d.name.c_str(), d.guid.c_str(), folder, false, logs, offer().has_events,
                                 offer().has_events && offer().returns_early, asked ? asked_.data() : nullptr,
                                 asked ? asked_.size() : 0, this, write_log, asked ? within_step : nullptr);
}

void InstanceOf3::set_up(double t_start, std::optional<double> t_stop) {
  t_start_ = t_start, t_stop_ = t_stop;
  bool entered = false;
  for (const Setting& s : fmu().settings.values) {
    const Variable& v = fmu().description.at(s.variable);
    if (v.causality != Causality::structural_parameter) continue;
    if (!std::exchange(entered, true)) call(enter_configuration_);
    set(v.type, {&v.reference, 1}, s.numbers);
  }
  if (entered) call(exit_configuration_);
}

Updated InstanceOf3::update() {
  bool again = false, ended = false, nominals = false, states = false, known = false;
  double next = 0.0;
  call(update_, &again, &ended, &nominals, &states, &known, &next);
  return {again, ended, known ? next : std::numeric_limits<double>::infinity()};
}

Completed InstanceOf3::complete_step(bool never_back) {
  Completed completed{};
  call(complete_step_, never_back, &completed.event, &completed.ended);
  return completed;
}

Taken InstanceOf3::do_step(const OwnStep& s, bool never_back, InputsWithin& inputs) {
  Taken taken{s.end, false, false};
  bool early = false;
  double reached = s.end;
  inputs_ = &inputs, failed_ = nullptr;
  const auto status =
      do_step_.call(component(), s.begin, s.length, never_back, &taken.event, &taken.ended, &early, &reached);
  inputs_ = nullptr;
  if (failed_) std::rethrow_exception(std::exchange(failed_, nullptr));
  check(do_step_.name, status);
  if (!early && !taken.ended) check_time(s, reached);
  if (early || taken.ended) taken.time = std::clamp(reached, s.begin, s.end);
  return taken;
}

void InstanceOf3::within_step(void* instance, double time, bool set_requested, bool, bool, bool, bool* early,
                              double*) {
  auto& self = *static_cast<InstanceOf3*>(instance);
  if (early) *early = false;
  if (!set_requested || !self.inputs_ || self.failed_) return;
  try {
    self.inputs_->set(time);
  } catch (...) {
    self.failed_ = std::current_exception();
  }
}

}  // namespace

std::shared_ptr<Instance> make_instance_of_3(Fmu fmu, Tell tell) {
  return std::make_shared<InstanceOf3>(std::move(fmu), std::move(tell));
}

}  // namespace tandem::fmi
