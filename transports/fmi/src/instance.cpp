// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "instance.hpp"

#include <cstdlib>
#include <cstring>

#include "tandem/error.hpp"
#include "tandem/printable.hpp"

namespace tandem::fmi {
namespace {

namespace fs = std::filesystem;

/// A path as a URI: what is no plain character stands as %XX.
std::string uri_of(const fs::path& path) {
  constexpr std::string_view plain = "/-_.~", digits = "0123456789ABCDEF";
  std::string uri = "file://";
  for (const unsigned char c : path.string())
    if (std::isalnum(c) || plain.find(static_cast<char>(c)) != std::string_view::npos)
      uri += static_cast<char>(c);
    else
      uri += {'%', digits[c >> 4], digits[c & 15]};
  return uri;
}

std::string word_of(fmi2Status status) {
  static const char* const words[] = {"fmi2OK",    "fmi2Warning", "fmi2Discard",
                                      "fmi2Error", "fmi2Fatal",   "fmi2Pending"};
  return status >= fmi2OK && status <= fmi2Pending ? words[status] : "status " + std::to_string(status);
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

Instance::Instance(Fmu fmu, Tell tell)
    : fmu_(std::move(fmu)),
      name_("FMU '" + fmu_.file.string() + "'"),
      log_(name_, fmu_.description, fmu_.settings.logs, std::move(tell)),
      callbacks_{Log::write, std::calloc, std::free, nullptr, &log_} {
  const std::string library = library_of(fmu_);
  fmu_.archive->unpack(library.substr(0, library.rfind('/') + 1), folder_.path());
  fmu_.archive->unpack("resources/", folder_.path());
  fs::create_directories(folder_.path() / "resources");
  resources_ = uri_of(folder_.path() / "resources");
  library_ = std::make_unique<LoadedLibrary>(load(fmu_, folder_.path() / library));
  find_functions();
  within([this] {
    if (const char* version = functions_.GetVersion(); !version || std::strcmp(version, "2.0") != 0)
      throw Error(ErrorCode::invalid_argument, name_ + ": its library is of FMI version '" +
                                                   printable(version ? version : "", 100) +
                                                   "'; allowed is 2.0");
    instantiate();
  });
}

Instance::~Instance() {
  if (!component_ || fatal_ || LibraryCall::has_faulted()) return;
  const LibraryCall in_library(name_.c_str());
  free();
}

void Instance::free() noexcept {
  if (std::exchange(running_, false)) functions_.Terminate(component_);
  functions_.FreeInstance(std::exchange(component_, nullptr));
}

template <class Function>
void Instance::find(Function*& function, const char* name) {
  const auto& library = library_->get();
  if (!library.has(name))
    throw Error(ErrorCode::invalid_argument, name_ + ": its library has no function '" + name + "'");
  function = &library.get<Function>(name);
  check_function(reinterpret_cast<const void*>(function), name_, name);
}

void Instance::find_functions() {
  const Offer& offer = offer_of(fmu_.description, fmu_.settings.kind);
#define TANDEM_FMI2_FIND(result, name, arguments) find(functions_.name, "fmi2" #name);
  TANDEM_FMI2_COMMON(TANDEM_FMI2_FIND)
  if (offer.keeps_state) {
    TANDEM_FMI2_STATES(TANDEM_FMI2_FIND)
  }
  if (offer.serializes_state) {
    TANDEM_FMI2_BYTES(TANDEM_FMI2_FIND)
  }
  if (offer.interpolates_inputs) {
    TANDEM_FMI2_INPUT_DERIVATIVES(TANDEM_FMI2_FIND)
  }
  if (fmu_.settings.kind == Kind::model_exchange) {
    TANDEM_FMI2_MODEL_EXCHANGE(TANDEM_FMI2_FIND)
  } else {
    TANDEM_FMI2_CO_SIMULATION(TANDEM_FMI2_FIND)
  }
#undef TANDEM_FMI2_FIND
}

void Instance::instantiate() {
  const fmi2Type type = fmu_.settings.kind == Kind::co_simulation ? fmi2CoSimulation : fmi2ModelExchange;
  component_ = functions_.Instantiate(fmu_.description.name.c_str(), type, fmu_.description.guid.c_str(),
                                      resources_.c_str(), &callbacks_, fmi2False,
                                      fmu_.settings.logs ? fmi2True : fmi2False);
  fresh_ = true;
  if (component_) return;
  const std::string why = log_.take_last();
  throw Error(ErrorCode::invalid_argument,
              name_ + " makes no instance (fmi2Instantiate)" + (why.empty() ? "" : ": " + why));
}

void Instance::check(const char* name, fmi2Status status) {
  if (status == fmi2OK || status == fmi2Warning) return;
  if (status != fmi2Discard) running_ = false;
  fatal_ = fatal_ || status == fmi2Fatal;
  const std::string why = log_.take_last();
  throw Error(ErrorCode::numerical,
              name_ + ": " + name + " gives " + word_of(status) + (why.empty() ? "" : ": " + why));
}

void Instance::begin(double t_start, std::optional<double> t_stop) {
  if (!std::exchange(fresh_, false)) {
    const bool reset = functions_.Reset(component_) <= fmi2Warning;
    running_ = running_ && !reset;
    if (!reset) free(), instantiate(), fresh_ = false;
  }
  const auto& tolerance = fmu_.settings.tolerance;
  call(&Functions::SetupExperiment, "fmi2SetupExperiment", tolerance ? fmi2True : fmi2False,
       tolerance.value_or(0.0), t_start, t_stop ? fmi2True : fmi2False, t_stop.value_or(0.0));
  set_values();
  call(&Functions::EnterInitializationMode, "fmi2EnterInitializationMode");
}

void Instance::end_initialization() {
  call(&Functions::ExitInitializationMode, "fmi2ExitInitializationMode");
  running_ = true;
}

void Instance::set_values() {
  for (const Setting& s : fmu_.settings.values) {
    const Variable& v = fmu_.description.variables[static_cast<std::size_t>(s.variable)];
    const std::size_t one = 1;
    const auto whole = static_cast<int>(s.number);
    const char* const text = s.text.c_str();
    switch (v.type) {
      case Type::real:
        call(&Functions::SetReal, "fmi2SetReal", &v.reference, one, &s.number);
        break;
      case Type::boolean:
        call(&Functions::SetBoolean, "fmi2SetBoolean", &v.reference, one, &whole);
        break;
      case Type::string:
        call(&Functions::SetString, "fmi2SetString", &v.reference, one, &text);
        break;
      default:
        call(&Functions::SetInteger, "fmi2SetInteger", &v.reference, one, &whole);
    }
  }
}

}  // namespace tandem::fmi
