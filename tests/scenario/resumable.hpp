// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include <cstring>

#include "command.hpp"
#include "sources/all.hpp"
#include "tandem/bytes.hpp"
#include "tandem/coordinator/observers.hpp"
#include "tandem/error.hpp"
#include "tandem/scenario/checkpoint.hpp"

/// Checkpoints as bytes that are changed, and resumed from.
namespace tandem::test::crafted {

namespace fs = std::filesystem;
using scenario::Assembly;
using scenario::Checkpoint;
using scenario::Scenario;

inline constexpr std::size_t head = 28;  // bytes before the payload

template <class T>
void put(std::string& bytes, std::size_t place, T value) {
  const auto wire = to_wire(value);
  std::memcpy(bytes.data() + place, wire.data(), sizeof value);
}

template <class T>
T number_at(const std::string& bytes, std::size_t place) {
  return from_wire<T>(std::as_bytes(std::span(bytes)).subspan(place));
}

/// Length and checksum as they have to be.
inline std::string put_right(std::string bytes) {
  const auto payload = std::as_bytes(std::span(bytes)).subspan(head);
  put(bytes, 12, std::uint64_t{payload.size()});
  put(bytes, 20, checksum(payload));
  return bytes;
}

/// A run with a checkpoint in its middle, from which it can be resumed again and again.
class Resumable {
 public:
  Resumable(const std::string& file, const std::vector<std::string>& overrides, int rounds)
      : scenario_(scenario::read(TANDEM_SOURCE_DIR "/scenarios/" + file, overrides)) {
    Assembly assembly(scenario_, builtins_);
    const auto recorder = assembly.recorder(results());
    const auto indicators = assembly.indicators();
    Observers both;
    both.add(*recorder), both.add(*indicators);
    assembly.coordinator().observe(&both);
    assembly.initialize();
    for (int k = 0; k < rounds && assembly.coordinator().round(); ++k) recorder->between_rounds();
    Checkpoint(scenario_, builtins_, assembly, *recorder, {indicators.get(), nullptr}).write(file_);
    bytes_ = read_text(file_);
    ByteWriter coordinator;
    assembly.coordinator().save(coordinator);
    indicators->save(coordinator);
    recorder_ = states() + coordinator.size();
    while (assembly.coordinator().round()) recorder->between_rounds();
    recorder->close();
    for (const auto& entry : fs::directory_iterator(results()))
      kept_.emplace_back(entry.path(), read_text(entry.path()));
  }

  const std::string& bytes() const { return bytes_; }
  /// Where what the coordinator goes by begins, after the text.
  std::size_t states() const { return head + 4 + number_at<std::uint32_t>(bytes_, head); }

  /// Where what the recorder goes by begins.
  std::size_t recorder() const { return recorder_; }
  std::string results_text() const { return read_text(results() / "results.csv"); }

  /// Resumes from these bytes and, if they are taken, goes on to the end. What it says; empty: nothing.
  std::string resumed(const std::string& bytes) {
    std::ofstream(file_, std::ios::binary) << bytes;
    Assembly assembly(scenario_, builtins_);
    auto recorder = assembly.recorder(results());
    const auto indicators = assembly.indicators();
    assembly.initialize();
    try {
      Checkpoint(scenario_, builtins_, assembly, *recorder, {indicators.get(), nullptr}).resume(file_);
    } catch (const Error& error) {
      recorder.reset();
      EXPECT_TRUE(is_as_before()) << error.what();
      ++refused;
      return error.what();
    }
    std::string said = went_on(assembly, *recorder, *indicators);
    recorder.reset();
    if (said.empty() && is_as_before()) ++same;
    for (const auto& [path, text] : kept_) std::ofstream(path, std::ios::binary) << text;
    return said;
  }

  int refused = 0, same = 0;

 private:
  fs::path results() const { return folder_.path() / "o"; }
  static std::string went_on(Assembly& assembly, Recorder& recorder, Indicators& indicators) try {
    Observers both;
    both.add(recorder), both.add(indicators);
    assembly.coordinator().observe(&both);
    while (assembly.coordinator().round()) recorder.between_rounds();
    recorder.close();
    return "";
  } catch (const Error& error) {
    return error.what();
  }
  bool is_as_before() const {
    return std::all_of(kept_.begin(), kept_.end(),
                       [](const auto& one) { return read_text(one.first) == one.second; });
  }

  const Scratch folder_;
  const fs::path file_ = folder_.path() / "checkpoint";
  Builtins builtins_ = all_sources();
  Scenario scenario_;
  std::string bytes_;
  std::size_t recorder_ = 0;
  std::vector<std::pair<fs::path, std::string>> kept_;
};

}  // namespace tandem::test::crafted
