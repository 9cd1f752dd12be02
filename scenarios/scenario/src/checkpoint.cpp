// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/scenario/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "run_estimate.hpp"
#include "tandem/bytes.hpp"
#include "tandem/error.hpp"
#include "tandem/input_file.hpp"
#include "tandem/output/files.hpp"
#include "tandem/output/json.hpp"
#include "tandem/output/provenance.hpp"
#include "tandem/printable.hpp"
#include "tandem/scenario/file_text.hpp"

namespace tandem::scenario {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::string_view magic = "TANDEMCP";
constexpr std::size_t head_size = 28;                 // bytes before the payload
constexpr std::uint32_t longest_identity = 1U << 28;  // bytes

[[noreturn]] void refuse_file(const fs::path& file, const std::string& why) {
  throw Error(ErrorCode::invalid_argument, fmt::format("checkpoint '{}' {}", file.string(), why));
}

std::string checkpoint_at(const fs::path& file) {
  if (!fs::exists(file)) refuse_file(file, "is not there");
  return read_file(file, std::numeric_limits<std::uint64_t>::max(), "checkpoint");
}

/// The file of a subsystem, of a scenario with those of its members.
std::string contents_of(const SubsystemEntry& entry) {
  std::string text = source_contents(entry.file());
  if (entry.scheme() == "scenario")
    for (const SubsystemEntry& member : read(entry.file()).subsystems) text += contents_of(member);
  return text;
}

/// What follows the head, after all checks of the file itself.
std::span<const std::byte> payload_of(std::span<const std::byte> all, const fs::path& file) {
  if (all.size() < magic.size() || std::memcmp(all.data(), magic.data(), magic.size()) != 0)
    refuse_file(file, "is no checkpoint: it does not begin with TANDEMCP");
  if (all.size() < head_size)
    refuse_file(file,
                fmt::format("is truncated: it has {} bytes; allowed are {} or more", all.size(), head_size));
  ByteReader head(all.subspan(magic.size()), file.native(), "checkpoint");
  const auto version = head.take<std::uint32_t>();
  if (version != Checkpoint::format_version)
    refuse_file(file,
                fmt::format("has the format version {}; allowed is {}", version, Checkpoint::format_version));
  const auto length = head.take<std::uint64_t>(), sum = head.take<std::uint64_t>();
  const auto payload = all.subspan(head_size);
  if (payload.size() != length)
    refuse_file(file,
                fmt::format("{}: {} bytes follow its head; allowed are {}",
                            payload.size() < length ? "is truncated" : "has grown", payload.size(), length));
  if (checksum(payload) != sum)
    refuse_file(file, fmt::format("is damaged: the checksum of its bytes is {:016x}; allowed is {:016x}",
                                  checksum(payload), sum));
  return payload;
}

Json ports_of(const std::vector<Port>& ports) {
  Json list = Json::array();
  for (const Port& port : ports) list.push_back(fmt::format("{} [{}] x {}", port.name, port.unit, port.size));
  return list;
}

/// The value at a path, for a sentence.
std::string value_at(const nlohmann::json& json, const nlohmann::json::json_pointer& path) {
  return json.contains(path) ? printable(json.at(path).dump(), 200) : "nothing";
}

[[noreturn]] void refuse_other_run(const fs::path& file, const std::string& path, const nlohmann::json& there,
                                   const nlohmann::json& here) {
  const nlohmann::json::json_pointer at(path);
  refuse_file(file, fmt::format("is of another run: {} is {} there; allowed is {}, as it is here",
                                printable(path.substr(1), 200), value_at(there, at), value_at(here, at)));
}

}  // namespace

Checkpoint::Checkpoint(const Scenario& scenario, const Builtins& builtins, Assembly& assembly,
                       Recorder& recorder, Watching watching)
    : scenario_(scenario),
      builtins_(builtins),
      assembly_(assembly),
      recorder_(recorder),
      watching_(watching) {}

/// The scenario with what was set, and of each subsystem its ports and the file that it is read from. Where a
/// subsystem lives does not matter if it is elsewhere: its address may be another one.
std::string Checkpoint::identity() const {
  Json all = {{"tandem", output::version()},
              {"scenario", Json::parse(scenario_.values)},
              {"taken", scenario_.taken},
              {"subsystems", Json::object()}};
  for (int i = 0; i < assembly_.topology().size(); ++i) {
    const SubsystemEntry& entry = scenario_.subsystems[static_cast<std::size_t>(i)];
    const SubsystemInfo& info = assembly_.topology().info(i);
    Json& one = all["subsystems"][entry.name];
    one = {{"name", info.name}, {"inputs", ports_of(info.inputs)}, {"outputs", ports_of(info.outputs)}};
    const bool elsewhere = source_of(entry.source, builtins_).elsewhere;
    if (elsewhere && all["scenario"].contains("subsystems")) {
      Json& there = all["scenario"]["subsystems"][entry.name];
      there["source"] =
          "elsewhere" + entry.source.substr(std::min(entry.source.find('?'), entry.source.size()));
      there.erase("command");
    }
    if (elsewhere || entry.scheme() == "builtin") continue;
    const std::string text = contents_of(entry);
    one["checksum of its file"] = fmt::format("{:016x}", checksum(std::as_bytes(std::span(text))));
  }
  return all.dump();
}

void Checkpoint::check_identity(const std::string& text, const fs::path& file) const {
  const std::string own = identity();
  if (text == own) return;
  const nlohmann::json there =
      output::parse_json(text, fmt::format("checkpoint '{}': what it is of", file.string()));
  const nlohmann::json here = nlohmann::json::parse(own);
  if (!there.is_object()) refuse_file(file, "does not say what it is a checkpoint of");
  for (const char* part : {"tandem", "scenario", "taken", "subsystems"}) {
    const nlohmann::json difference =
        nlohmann::json::diff({{part, there.value(part, nlohmann::json())}}, {{part, here.at(part)}});
    if (!difference.empty()) refuse_other_run(file, difference[0]["path"], there, here);
  }
}

void Checkpoint::write(const fs::path& file) {
  recorder_.flush();
  for (const fs::path& results : recorder_.files()) output::sync(results);
  ByteWriter to;
  to.put_bytes(std::as_bytes(std::span(magic)));
  to.put(format_version);
  to.put(std::uint64_t{0});
  to.put(std::uint64_t{0});
  to.put_text(identity());
  assembly_.coordinator().save(to);
  if (watching_.indicators) watching_.indicators->save(to);
  if (watching_.estimate) watching_.estimate->save(to);
  recorder_.save(to);
  const auto payload = to.bytes().subspan(head_size);
  const std::uint64_t length = payload.size(), sum = checksum(payload);
  to.put_at(12, length);
  to.put_at(20, sum);
  output::replace_durably(file, to.bytes());
}

std::vector<std::string> Checkpoint::taken(const fs::path& file) {
  const std::string text = checkpoint_at(file);
  ByteReader from(payload_of(std::as_bytes(std::span(text)), file), file.native(), "checkpoint");
  const nlohmann::json there = output::parse_json(
      from.take_text(longest_identity), fmt::format("checkpoint '{}': what it is of", file.string()));
  std::vector<std::string> all;
  for (const auto& one : there.is_object() ? there.value("taken", nlohmann::json::array()) : nlohmann::json())
    if (one.is_string()) all.push_back(one.get<std::string>());
  return all;
}

void Checkpoint::resume(const fs::path& file) {
  const std::string text = checkpoint_at(file);
  ByteReader from(payload_of(std::as_bytes(std::span(text)), file), file.native(), "checkpoint");
  check_identity(from.take_text(longest_identity), file);
  assembly_.coordinator().restore(from);
  if (watching_.indicators) watching_.indicators->resume(from);
  if (watching_.estimate) watching_.estimate->resume(from);
  recorder_.resume(from);
}

}  // namespace tandem::scenario
