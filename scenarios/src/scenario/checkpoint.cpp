// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "scenario/checkpoint.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <system_error>

#include "output/files.hpp"
#include "tandem/bytes.hpp"
#include "tandem/error.hpp"

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

std::string contents(const fs::path& file) {
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in && !in.eof())
    throw Error(ErrorCode::input_output, fmt::format("file '{}' can't be read: {}", file.string(),
                                                     std::generic_category().message(errno)));
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
std::string value_at(const Json& json, const Json::json_pointer& path) {
  return json.contains(path) ? json.at(path).dump() : "nothing";
}

}  // namespace

Checkpoint::Checkpoint(const Scenario& scenario, const Builtins& builtins, Assembly& assembly,
                       Recorder& recorder)
    : scenario_(scenario), builtins_(builtins), assembly_(assembly), recorder_(recorder) {}

/// The scenario with what was set, and of each subsystem its ports and the file that it is read from. Where a
/// subsystem lives does not matter if it is elsewhere: its address may be another one.
Json Checkpoint::identity() const {
  Json all = {{"tandem", TANDEM_VERSION}, {"scenario", scenario_.document}, {"subsystems", Json::object()}};
  for (int i = 0; i < assembly_.topology().size(); ++i) {
    const SubsystemEntry& entry = scenario_.subsystems[static_cast<std::size_t>(i)];
    const SubsystemInfo& info = assembly_.topology().info(i);
    Json& one = all["subsystems"][entry.name];
    one = {{"name", info.name}, {"inputs", ports_of(info.inputs)}, {"outputs", ports_of(info.outputs)}};
    const std::string source = entry.source.substr(0, entry.source.find('?'));
    const std::string kind = source.substr(0, source.find(':'));
    if (builtins_.addresses.count(kind) != 0 && all["scenario"].contains("subsystems"))
      all["scenario"]["subsystems"][entry.name]["source"] = "elsewhere" + entry.source.substr(source.size());
    if (builtins_.files.count(kind) == 0) continue;
    const std::string text =
        contents(fs::path(entry.place.file).parent_path() / source.substr(kind.size() + 1));
    one["checksum of its file"] = fmt::format("{:016x}", checksum(std::as_bytes(std::span(text))));
  }
  return all;
}

void Checkpoint::check_identity(const std::string& text, const fs::path& file) const {
  const Json there = Json::parse(text, nullptr, false), here = Json::parse(identity().dump());
  if (there.is_discarded()) refuse_file(file, "does not say what it is a checkpoint of");
  const Json difference = Json::diff(there, here);
  if (difference.empty()) return;
  const std::string path = difference[0]["path"];
  const Json::json_pointer at(path);
  refuse_file(file, fmt::format("is of another run: {} is {} there; allowed is {}, as it is here",
                                path.substr(1), value_at(there, at), value_at(here, at)));
}

void Checkpoint::write(const fs::path& file) {
  recorder_.flush();
  for (const fs::path& results : recorder_.files()) output::sync(results);
  ByteWriter to;
  to.put_bytes(std::as_bytes(std::span(magic)));
  to.put(format_version);
  to.put(std::uint64_t{0});
  to.put(std::uint64_t{0});
  to.put_text(identity().dump());
  assembly_.coordinator().save(to);
  recorder_.save(to);
  const auto payload = to.bytes().subspan(head_size);
  const std::uint64_t length = payload.size(), sum = checksum(payload);
  to.put_at(12, length);
  to.put_at(20, sum);
  output::replace_durably(file, to.bytes());
}

void Checkpoint::resume(const fs::path& file) {
  if (!fs::is_regular_file(file)) refuse_file(file, "is not there, or no file");
  const std::string text = contents(file);
  ByteReader from(payload_of(std::as_bytes(std::span(text)), file), file.native(), "checkpoint");
  check_identity(from.take_text(longest_identity), file);
  assembly_.coordinator().restore(from);
  recorder_.resume(from);
  from.end();
}

}  // namespace tandem::scenario
