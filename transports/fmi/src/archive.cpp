// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/fmi/archive.hpp"

#include <minizip/unzip.h>
#include <sys/stat.h>

#include <array>
#include <set>

#include "tandem/error.hpp"
#include "tandem/input_file.hpp"
#include "tandem/nearest.hpp"
#include "tandem/output_file.hpp"
#include "tandem/printable.hpp"

namespace tandem::fmi {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 4096;

/// Why a name is not allowed; empty if it is.
std::string fault_of(std::string_view name) {
  if (name.empty() || name.size() > longest_name)
    return "a name of " + std::to_string(name.size()) + " bytes";
  if (name.find('\\') != std::string_view::npos) return "a backslash in its name";
  if (name.find('\0') != std::string_view::npos) return "a zero byte in its name";
  if (name.front() == '/') return "a name that begins at the root";
  if (name.back() == '/') name.remove_suffix(1);
  for (std::size_t begin = 0, end; begin <= name.size(); begin = end + 1) {
    end = std::min(name.find('/', begin), name.size());
    const std::string_view part = name.substr(begin, end - begin);
    if (part.empty() || part == "." || part == "..") return "'" + std::string(part) + "' in its name";
  }
  return "";
}

bool is_link(const unz_file_info64& info) {
  constexpr unsigned long unix_system = 3;
  return info.version >> 8 == unix_system && S_ISLNK(info.external_fa >> 16);
}

std::string quoted(const std::string& name) { return "'" + printable(name, 200) + "'"; }

}  // namespace

void Archive::Close::operator()(void* zip) const { unzClose(zip); }

Archive::Archive(fs::path file, std::string what, std::uint64_t most_bytes)
    : file_(std::move(file)), what_(std::move(what)), most_bytes_(most_bytes), packed_(file_) {
  const InputFile regular(packed_.on_disk(), what_);  // refuses what is no regular file
  zip_.reset(unzOpen64(packed_.on_disk().c_str()));
  if (!zip_) refuse("is no zip archive, or is not whole");
  list();
}

Archive::~Archive() = default;

void Archive::refuse(const std::string& why) const {
  throw Error(ErrorCode::input_output, what_ + " '" + file_.string() + "' " + why);
}

std::pair<std::string, Archive::Place> Archive::entry() const {
  std::array<char, longest_name + 1> name{};
  unz_file_info64 info{};
  if (unzGetCurrentFileInfo64(zip_.get(), &info, name.data(), name.size(), nullptr, 0, nullptr, 0) != UNZ_OK)
    refuse("has a list of files that is damaged");
  const std::string text(name.data(), std::min<std::size_t>(info.size_filename, longest_name));
  std::string fault = info.size_filename > longest_name ? "a name of too many bytes" : fault_of(text);
  if (is_link(info)) fault = "a link in its place";
  if ((info.flag & 1U) != 0) fault = "encrypted content";
  if (!fault.empty())
    refuse("holds " + quoted(text) + ", which has " + fault + "; allowed are plain files below its root");
  unz64_file_pos at{};
  unzGetFilePos64(zip_.get(), &at);
  return {text, {at.pos_in_zip_directory, at.num_of_file, info.uncompressed_size, info.crc}};
}

void Archive::list() {
  unz_global_info64 all{};
  unzGetGlobalInfo64(zip_.get(), &all);
  int status = all.number_entry == 0 ? UNZ_END_OF_LIST_OF_FILE : unzGoToFirstFile(zip_.get());
  for (std::uint64_t k = 0; status == UNZ_OK; ++k, status = unzGoToNextFile(zip_.get())) {
    if (k == most_files) refuse("holds more than " + std::to_string(most_files) + " files");
    const auto [name, place] = entry();
    const auto [it, is_new] = places_.try_emplace(name, place);
    const bool same = it->second.size == place.size && it->second.sum == place.sum;
    if (!is_new && !same && !name.ends_with('/'))  // a folder holds nothing of its own
      refuse("holds " + quoted(name) + " twice, with different content");
  }
  if (status != UNZ_END_OF_LIST_OF_FILE) refuse("has a list of files that is damaged");
  if (places_.empty()) refuse("holds no files, or is not whole");
}

std::string Archive::folders_in(std::string_view folder) const {
  std::set<std::string> found;
  for (const auto& [name, place] : places_) {
    const auto end = name.find('/', folder.size());
    if (name.starts_with(folder) && end != std::string::npos)
      found.insert(printable(name.substr(folder.size(), end - folder.size()), 100));
  }
  return tandem::listed({found.begin(), found.end()});
}

std::string Archive::file_in(const std::string& name) const {
  for (std::size_t end = 0; end < name.size(); ++end) {
    end = std::min(name.find('/', end), name.size());
    if (has(name.substr(0, end))) return name.substr(0, end);
  }
  return "";
}

/// take(bytes) for each block of the file's content.
template <class Take>
void Archive::read(const std::string& name, const Take& take) const {
  const Place& at = places_.at(name);
  const unz64_file_pos place{at.offset, at.number};
  unz_file_info64 info{};
  if (unzGoToFilePos64(zip_.get(), &place) != UNZ_OK || unzOpenCurrentFile(zip_.get()) != UNZ_OK ||
      unzGetCurrentFileInfo64(zip_.get(), &info, nullptr, 0, nullptr, 0, nullptr, 0) != UNZ_OK)
    refuse("holds " + quoted(name) +
           ", which can't be unpacked: its entry is damaged, or packed in a way "
           "that is not known");
  std::array<char, 1U << 16> block;
  std::uint64_t total = 0;
  int count = 0;
  while ((count = unzReadCurrentFile(zip_.get(), block.data(), block.size())) > 0) {
    total += static_cast<std::uint64_t>(count);
    take(std::string_view(block.data(), static_cast<std::size_t>(count)));
  }
  const bool sound = unzCloseCurrentFile(zip_.get()) == UNZ_OK;
  if (count < 0 || !sound || total != info.uncompressed_size)
    refuse("holds " + quoted(name) + ", whose content is damaged");
}

std::string Archive::text(const std::string& name, std::uint64_t most) const {
  std::string all;
  read(name, [&](std::string_view block) {
    if (all.size() + block.size() > most)
      refuse("holds " + quoted(name) + " with more than the " + std::to_string(most) +
             " bytes that are allowed");
    all += block;
  });
  return all;
}

void Archive::unpack(std::string_view folder, const fs::path& to) {
  for (auto it = places_.lower_bound(std::string(folder)); it != places_.end(); ++it)
    if (it->first.starts_with(folder))
      unpack_file(it->first, to);
    else
      break;
}

void Archive::unpack_file(const std::string& name, const fs::path& to) {
  std::error_code failed;
  const bool is_folder = name.back() == '/';
  fs::create_directories(is_folder ? to / name.substr(0, name.size() - 1) : (to / name).parent_path(),
                         failed);
  if (failed) refuse("holds " + quoted(name) + ", for which no folder can be made: " + failed.message());
  if (is_folder) return;
  OutputFile out(to / name, OutputFile::Begin::fresh);
  read(name, [&](std::string_view block) {
    if ((written_ += block.size()) > most_bytes_)
      refuse("unpacks to more than the " + std::to_string(most_bytes_) + " bytes that are allowed");
    out.write(block);
  });
  out.close();
}

}  // namespace tandem::fmi
