// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstring>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "tandem/error.hpp"
#include "tandem/exported/exchanged_unit.hpp"
#include "tandem/exported/stepped_unit.hpp"

#define TANDEM_FMI extern "C" __attribute__((visibility("default")))

namespace tandem::exported {

/// An instance that an importer has: the unit, and who hears of it. Both versions share this header, which is
/// long as it holds all that they have in common.
struct Instance {
  /// Takes (status by the numbers of both versions, sentence).
  using Log = std::function<void(int, const std::string&)>;
  static constexpr int warning = 1, discard = 2, error = 3;

  Instance(const std::filesystem::path& resources, const std::string& token, Log to)
      : log(std::move(to)),
        owner(open_unit(resources, [this](const std::string& what) { log(warning, what); })),
        unit(*owner),
        steps(dynamic_cast<SteppedUnit*>(owner.get())),
        exchange(dynamic_cast<ExchangedUnit*>(owner.get())) {
    if (token != unit.manifest().token)
      throw Error(ErrorCode::invalid_argument, "guid or instantiationToken is '" + token +
                                                   "'; allowed is that of this FMU, '" +
                                                   unit.manifest().token + "'");
  }
  /// Throws if it is none, as its calls do that are of no use then.
  SteppedUnit& stepped() {
    if (!steps) throw Error(ErrorCode::not_supported, "this FMU is for Model Exchange, and takes no steps");
    return *steps;
  }
  ExchangedUnit& exchanged() {
    if (!exchange)
      throw Error(ErrorCode::not_supported, "this FMU is for Co-Simulation, and integrates itself");
    return *exchange;
  }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  /// work(*this) with its errors as a status, told to the importer.
  /// - trial: where it has no value, as a loop has no solution, a shorter step may be tried.
  template <class Status, class Work>
  Status guarded(const Work& work, bool trial = false) noexcept {
    try {
      work(*this);
      return Status{};
    } catch (const Error& what) {
      const bool tried = trial && exchange && what.code() == ErrorCode::numerical;
      return tell<Status>(what.what(), tried ? discard : error);
    } catch (const std::exception& what) {
      return tell<Status>(what.what(), error);
    } catch (...) {
      return tell<Status>("an error that is not known", error);
    }
  }
  template <class Status>
  Status tell(const char* sentence, int status) const noexcept {
    try {
      log(status, sentence);
    } catch (...) {
      return static_cast<Status>(status);  // which tells it
    }
    return static_cast<Status>(status);
  }

  /// A text that stays until the next one of that variable is asked for.
  const std::string& text(std::size_t reference) { return texts[reference] = unit.word(reference); }

  // States that the importer keeps, each as a pointer.
  using State = std::vector<std::byte>;
  /// Into the one that is there already, if it is.
  void keep(void*& state) {
    State now = unit.state();
    state ? void(*static_cast<State*>(state) = std::move(now)) : void(state = new State(std::move(now)));
  }
  static void keep(const void* bytes, std::size_t size, void*& state) {
    const auto* first = static_cast<const std::byte*>(bytes);
    state = new State(first, first + size);
  }
  static const State& kept(void* state) {
    if (!state) throw Error(ErrorCode::invalid_argument, "there is no state");
    return *static_cast<const State*>(state);
  }
  static void serialize(void* state, void* to, std::size_t size) {
    if (size < kept(state).size())
      throw Error(ErrorCode::invalid_argument,
                  "the state does not fit into " + std::to_string(size) + " bytes");
    std::memcpy(to, kept(state).data(), kept(state).size());
  }
  static void forget(void*& state) {
    delete static_cast<State*>(state);
    state = nullptr;
  }

  Log log;
  std::unique_ptr<Unit> owner;
  Unit& unit;
  SteppedUnit* steps;  ///< one of both is null
  ExchangedUnit* exchange;
  std::map<std::size_t, std::string> texts = {};
};

/// The instance behind a pointer of the importer's; null gives an error's status.
template <class Status, class Work>
Status with(void* instance, const Work& work, bool trial = false) noexcept {
  return instance ? static_cast<Instance*>(instance)->guarded<Status>(work, trial)
                  : static_cast<Status>(Instance::error);
}
/// Of Model Exchange: work(unit).
template <class Status, class Work>
Status exchange(void* instance, const Work& work) noexcept {
  return with<Status>(instance, [&](Instance& i) { work(i.exchanged()); });
}
/// The same at a time and states that may be tried.
template <class Status, class Work>
Status evaluate(void* instance, const Work& work) noexcept {
  return with<Status>(
      instance, [&](Instance& i) { work(i.exchanged()); }, true);
}

constexpr const char* no_resources = "the folder of resources is not given; this FMU has resources";

/// Makes one; null, and told, if it can't be.
inline Instance* made(const std::filesystem::path& resources, const char* token, Interface wanted,
                      const Instance::Log& log) noexcept {
  try {
    auto instance = std::make_unique<Instance>(resources, token ? token : "", log);
    wanted == Interface::model_exchange ? void(instance->exchanged()) : void(instance->stepped());
    return instance.release();
  } catch (const std::exception& what) {
    log(Instance::error, what.what());
  } catch (...) {
    log(Instance::error, "an error that is not known");
  }
  return nullptr;
}

/// For each value reference the work with its place.
template <class Work>
void each(const unsigned* references, std::size_t count, const Work& work) {
  for (std::size_t k = 0; k < count; ++k) work(std::size_t{references[k]}, k);
}

}  // namespace tandem::exported
