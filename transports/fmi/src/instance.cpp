// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "instance.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/printable.hpp"

namespace tandem::fmi {
namespace {

namespace fs = std::filesystem;

std::string word_of(Status status) {
  static const char* const words[] = {"OK", "Warning", "Discard", "Error", "Fatal", "Pending"};
  return status <= Status::pending ? words[static_cast<std::size_t>(status)]
                                   : "status " + std::to_string(static_cast<int>(status));
}

/// With its own symbols before those of this program: it may bring other versions of the same libraries.
boost::dll::shared_library load(const Fmu& fmu, const fs::path& from) {
#if defined(__SANITIZE_ADDRESS__)
  return load_library(fmu.file, from);  // which takes the place of symbols itself
#else
  return load_library(fmu.file, from, boost::dll::load_mode::rtld_deepbind);
#endif
}

}  // namespace

std::shared_ptr<Instance> Instance::make(Fmu fmu, Tell tell) {
  const bool two = fmu.description.version == Version::two;
  return two ? make_instance_of_2(std::move(fmu), std::move(tell))
             : make_instance_of_3(std::move(fmu), std::move(tell));
}

Instance::Instance(Fmu fmu, Tell tell)
    : fmu_(std::move(fmu)),
      only_(fmu_),
      name_("FMU '" + fmu_.file.string() + "'"),
      log_(name_, fmu_.description, fmu_.settings.logs, std::move(tell)) {
  const std::string library = library_of(fmu_);
  fmu_.archive->unpack(library.substr(0, library.rfind('/') + 1), folder_.path());
  fmu_.archive->unpack("resources/", folder_.path());
  fs::create_directories(folder_.path() / "resources");
  resources_ = (folder_.path() / "resources").string();
  library_ = std::make_unique<LoadedLibrary>(load(fmu_, folder_.path() / library));
}

void Instance::open() {
  find_common();
  find_functions();
  try {
    within([this] { check_version(), make_instance(); });
  } catch (const Error& error) {
    if (LibraryCall::has_faulted()) throw Error(error.code(), name_ + ": " + error.what());
    throw;
  }
}

void Instance::check_version() const {
  const char* const found = functions_.get_version.call();
  if (!std::string_view(found ? found : "").starts_with(version()))
    throw Error(ErrorCode::invalid_argument, name_ + ": its library is of FMI version '" +
                                                 printable(found ? found : "", 100) + "'; allowed is " +
                                                 version());
}

void Instance::close() noexcept {
  if (!component_ || fatal_ || LibraryCall::has_faulted()) return;
  try {
    within([this] { free(); });
  } catch (const Error& fault) {
    log_.tell("at its end " + std::string(fault.what()));
  }
}

void Instance::free() noexcept {
  if (std::exchange(running_, false)) functions_.terminate.call(component_);
  functions_.free_instance.call(std::exchange(component_, nullptr));
  ++made_;
}

/// Names that differ: of 2.0, of 3.0.
void Instance::find_common() {
  const bool two = fmu_.description.version == Version::two;
  const auto either = [two](const char* of_2, const char* of_3) { return std::string(two ? of_2 : of_3); };
  Functions& f = functions_;
  find(f.get_version, "GetVersion"), find(f.free_instance, "FreeInstance");
  find(f.exit_initialization, "ExitInitializationMode");
  find(f.terminate, "Terminate"), find(f.reset, "Reset");
  if (offer().keeps_state) {
    find(f.get_state, either("GetFMUstate", "GetFMUState"));
    find(f.set_state, either("SetFMUstate", "SetFMUState"));
    find(f.free_state, either("FreeFMUstate", "FreeFMUState"));
  }
  if (offer().serializes_state) {
    find(f.state_size, either("SerializedFMUstateSize", "SerializedFMUStateSize"));
    find(f.serialize, either("SerializeFMUstate", "SerializeFMUState"));
    find(f.deserialize, either("DeSerializeFMUstate", "DeserializeFMUState"));
  }
  if (exchanges() || offer().has_events) find(f.enter_events, "EnterEventMode");
  if (!exchanges()) return;
  find(f.enter_continuous_time, "EnterContinuousTimeMode"), find(f.set_time, "SetTime");
  find(f.set_states, "SetContinuousStates"), find(f.get_states, "GetContinuousStates");
  find(f.get_rates, either("GetDerivatives", "GetContinuousStateDerivatives"));
  find(f.get_indicators, "GetEventIndicators");
}

void Instance::make_instance() {
  component_ = instantiate();
  fresh_ = component_ != nullptr;
  if (component_) return;
  const std::string why = log_.take_last();
  throw Error(ErrorCode::invalid_argument,
              name_ + " makes no instance (" + prefix() + "Instantiate)" + (why.empty() ? "" : ": " + why));
}

void Instance::fail(const std::string& name, Status status) {
  if (status != Status::discard) running_ = false;
  fatal_ = fatal_ || status == Status::fatal;
  const std::string why = log_.take_last();
  const std::string sentence =
      name_ + ": " + name + " gives " + prefix() + word_of(status) + (why.empty() ? "" : ": " + why);
  if (status != Status::discard) failed_ = sentence;
  throw Error(ErrorCode::numerical, sentence);
}

void Instance::begin(double t_start, std::optional<double> t_stop) {
  if (fatal_ || !component_)
    throw Error(ErrorCode::numerical, name_ + " has failed for good, and can't be started again");
  failed_.clear();
  if (!std::exchange(fresh_, false)) {
    const bool reset = is_good(functions_.reset.call(component_));
    running_ = running_ && !reset;
    if (!reset) free(), make_instance(), fresh_ = false;
  }
  set_up(t_start, t_stop);
  set_values();
  enter_initialization();
}

void Instance::end_initialization() {
  call(functions_.exit_initialization);
  running_ = true;
}

/// Those of structural parameters are set up.
void Instance::set_values() {
  for (const Setting& s : fmu_.settings.values) {
    const Variable& v = fmu_.description.at(s.variable);
    if (v.causality == Causality::structural_parameter) continue;
    if (v.type == Type::text)
      set_text(v.reference, s.text);
    else
      set(v.type, {&v.reference, 1}, s.numbers);
  }
}

void Instance::release(void* state, int made) noexcept {
  if (made == made_ && component_ && !fatal_) functions_.free_state.call(component_, &state);
}

void* Instance::state() {
  void* state = nullptr;
  call(functions_.get_state, &state);
  return state;
}

void* Instance::state_from(std::span<const std::byte> bytes) {
  void* state = nullptr;
  call(functions_.deserialize, reinterpret_cast<const char*>(bytes.data()), bytes.size(), &state);
  return state;
}

std::vector<std::byte> Instance::bytes(void* state) {
  std::size_t size = 0;
  call(functions_.state_size, state, &size);
  std::vector<std::byte> all(size);
  call(functions_.serialize, state, reinterpret_cast<char*>(all.data()), size);
  return all;
}

/// The difference is a good part of the step, where sums of rounded steps are far below a hundredth of it.
void Instance::check_time(const OwnStep& s, double own) {
  constexpr int enough = 100;
  const double off = std::abs(own - s.end);
  if (off <= 0.01 * s.length) return void(++right_steps_);
  if (right_steps_ >= enough && off <= 1.01 * s.length) {
    if (!std::exchange(told_of_time_, true))
      log_.tell(fmt::format(
          "after {} steps that were right its own time is {} s at the end of the step to {} s, as it sums "
          "up its steps otherwise; it goes on",
          right_steps_, own, s.end));
    return;
  }
  throw Error(
      ErrorCode::numerical,
      fmt::format("the FMU says that it has taken the step from {} to {} s, but its own time is {} s; "
                  "allowed is a step that it can take",
                  s.begin, s.end, own));
}

}  // namespace tandem::fmi
