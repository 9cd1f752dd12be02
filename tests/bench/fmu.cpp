// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <dlfcn.h>
#include <fmt/format.h>

#include <cstdlib>
#include <memory>

#include "bench/bench.hpp"
#include "bench/in_turns.hpp"
#include "fmi2.h"
#include "tandem/error.hpp"
#include "tandem/fmi/archive.hpp"
#include "tandem/fmi/fmi.hpp"
#include "tandem/transports/temporary_folder.hpp"

namespace tandem::bench {
namespace {

constexpr double step = 1e-3;
constexpr fmi2ValueReference x = 1, u = 3, work = 0;

/// u = 1 + t.
double input(double t) { return 1.0 + t; }

void log(void*, fmi2String, fmi2Status, fmi2String, fmi2String, ...) {}

/// The FMU `busy`, called directly: what is called for each step is what an importer cannot do without.
class Direct {
 public:
  Direct(fmi2Type type, int amount) {
    const fmi2CallbackFunctions callbacks{log, std::calloc, std::free, nullptr, nullptr};
    fmu_ = find<fmi2InstantiateType>("Instantiate")("busy", type, "busy-1", "file:///tmp", &callbacks,
                                                    fmi2False, fmi2False);
    find<fmi2SetupExperimentType>("SetupExperiment")(fmu_, fmi2False, 0.0, 0.0, fmi2False, 0.0);
    find<fmi2SetIntegerType>("SetInteger")(fmu_, &work, 1, &amount);
    find<fmi2EnterInitializationModeType>("EnterInitializationMode")(fmu_);
    find<fmi2EnterInitializationModeType>("ExitInitializationMode")(fmu_);
  }

  void take_step(double held, bool derivatives) {
    const double value = input(t_ + held * step), rate = 1.0;
    const int order = 1;
    set_(fmu_, &u, 1, &value);
    if (derivatives) set_rate_(fmu_, &u, 1, &order, &rate);
    do_step_(fmu_, t_, step, fmi2True);
    t_ += step;
    get_(fmu_, &x, 1, &y_);
  }

  /// The classical Runge-Kutta method.
  void integrate() {
    double k[4], now = 0.0;
    get_states_(fmu_, &now, 1);
    for (int stage = 0; stage < 4; ++stage) {
      const double at = stage == 0 ? 0.0 : stage == 3 ? step : 0.5 * step, value = input(t_ + at);
      const double moved = stage == 0 ? now : now + at * k[stage - 1];
      set_time_(fmu_, t_ + at);
      set_states_(fmu_, &moved, 1);
      set_(fmu_, &u, 1, &value);
      get_rates_(fmu_, &k[stage], 1);
    }
    now += step / 6.0 * (k[0] + 2.0 * k[1] + 2.0 * k[2] + k[3]);
    t_ += step;
    const double value = input(t_);
    fmi2Boolean event, end;
    set_time_(fmu_, t_), set_states_(fmu_, &now, 1), set_(fmu_, &u, 1, &value);
    completed_(fmu_, fmi2True, &event, &end);
    get_(fmu_, &x, 1, &y_);
  }

 private:
  template <class Signature>
  Signature* find(const char* name) const {
    return reinterpret_cast<Signature*>(::dlsym(library_, ("fmi2" + std::string(name)).c_str()));
  }
  using Move = fmi2Status(fmi2Component, const fmi2Real[], size_t);
  using Give = fmi2Status(fmi2Component, fmi2Real[], size_t);

  void* load() const {
    const std::string library = "binaries/linux64/";
    fmi::Archive(TANDEM_FMUS "/busy.fmu").unpack(library, folder_.path());
    void* const loaded = ::dlopen((folder_.path() / (library + "busy.so")).c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!loaded) throw Error(ErrorCode::input_output, ::dlerror());
    return loaded;
  }

  TemporaryFolder folder_;
  void* library_ = load();
  fmi2Component fmu_ = nullptr;
  double t_ = 0.0, y_ = 0.0;
  fmi2SetRealType* set_ = find<fmi2SetRealType>("SetReal");
  fmi2GetRealType* get_ = find<fmi2GetRealType>("GetReal");
  fmi2SetRealInputDerivativesType* set_rate_ =
      find<fmi2SetRealInputDerivativesType>("SetRealInputDerivatives");
  fmi2DoStepType* do_step_ = find<fmi2DoStepType>("DoStep");
  fmi2Status (*set_time_)(fmi2Component, double) = find<fmi2Status(fmi2Component, double)>("SetTime");
  Move* set_states_ = find<Move>("SetContinuousStates");
  Give* get_states_ = find<Give>("GetContinuousStates");
  Give* get_rates_ = find<Give>("GetDerivatives");
  fmi2CompletedIntegratorStepType* completed_ =
      find<fmi2CompletedIntegratorStepType>("CompletedIntegratorStep");
};

/// The same through the Subsystem, one step for each call of advance.
class Ours {
 public:
  explicit Ours(const std::string& how) : row_(16) {
    Builtins builtins;
    add_fmi(builtins);
    fmu_ = open("fmu:" TANDEM_FMUS "/busy.fmu?" + how, builtins);
    Samples y(row_.data(), fmu_->info().row_size(), 1);
    const double u0 = input(0.0);
    clock_ = fmu_->initialize(0.0, 1e6, {&u0, 1}, y);
  }
  void take_step() {
    Samples y(row_.data(), fmu_->info().row_size(), 2);  // room for an event, of which there are none
    clock_ = fmu_->advance(clock_.next_time, false, {&signal_, 1}, y);
  }

 private:
  std::unique_ptr<Subsystem> fmu_;
  std::vector<double> row_;
  Segment ramp_{1e6, 0.0, {1.0, 1.0}};
  Signal signal_{&ramp_, 1, 1};
  Clock clock_{};
};

struct Way {
  std::string name, how;
  fmi2Type type;
  int work;
  std::function<void(Direct&)> direct;
};

}  // namespace

Table fmu() {
  Table table({"inputs", "ns_direct", "ns_tandem", "ratio"});
  const auto steps = [](double held, bool derivatives) {
    return [=](Direct& fmu) { fmu.take_step(held, derivatives); };
  };
  // Two evaluations in a step of Co-Simulation, and one of Model Exchange, take about 1 us.
  constexpr int half = 310, whole = 620;
  for (const Way& way : std::vector<Way>{
           {"left", "type=cs&inputs=left", fmi2CoSimulation, half, steps(0.0, false)},
           {"mean", "type=cs&inputs=mean", fmi2CoSimulation, half, steps(0.5, false)},
           {"derivatives", "type=cs&inputs=derivatives", fmi2CoSimulation, half, steps(0.0, true)},
           {"Model Exchange", "type=me", fmi2ModelExchange, whole, [](Direct& fmu) { fmu.integrate(); }}}) {
    Direct direct(way.type, way.work);
    Ours ours(way.how + "&set.work=" + std::to_string(way.work));
    const InTurns both = measure_in_turns([&] { ours.take_step(); }, [&] { way.direct(direct); }, 4000, 50);
    table.add({way.name, fmt::format("{:.0f}", 1e9 * both.raw.median),
               fmt::format("{:.0f}", 1e9 * both.tandem.median),
               fmt::format("{:.3f}", both.tandem.median / both.raw.median)});
  }
  return table;
}

}  // namespace tandem::bench
