// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/fmi/archive.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/transports/temporary_folder.hpp"
#include "zip_file.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;
using fmi::Archive;

std::size_t files_below(const fs::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) count += entry.is_regular_file() ? 1 : 0;
  return count;
}

TEST(FmuArchive, GivesWhatWasPacked) {
  const Scratch scratch;
  const std::string all_bytes = [] {
    std::string text;
    for (int k = 0; k < 100000; ++k) text += static_cast<char>(k * k % 251);
    return text;
  }();
  Archive archive(
      write_zip(scratch.path() / "a.fmu",
                {{"x.txt", "hello"}, {"resources/deep/y.bin", all_bytes}, {"binaries/win64/z.dll", "z"}}));
  EXPECT_EQ(archive.text("x.txt", 5), "hello");
  EXPECT_EQ(archive.folders_in("binaries/"), "win64");
  EXPECT_EQ(archive.folders_in("sources/"), "none");
  const fs::path to = scratch.path() / "out";
  archive.unpack("resources/", to);
  EXPECT_EQ(read_text(to / "resources/deep/y.bin"), all_bytes);
  EXPECT_EQ(files_below(to), 1U);
}

TEST(FmuArchive, NamesThatLeadElsewhereAreRefused) {
  const Scratch scratch;
  for (const auto& [name, text] :
       std::vector<std::pair<std::string, std::string>>{{"../x", "'..'"},
                                                        {"a/../../x", "'..'"},
                                                        {"/x", "begins at the root"},
                                                        {"a\\..\\x", "a backslash"},
                                                        {"a//x", "'' in its name"},
                                                        {"a/./x", "'.' in its name"}})
    EXPECT_TRUE(refuses(ErrorCode::input_output, {"a.fmu' holds", text}, [&] {
      Archive(write_zip(scratch.path() / "a.fmu", {{name, "x"}}));
    })) << name;
}

TEST(FmuArchive, LinksAndNamesOfTwoContentsAreRefused) {
  const Scratch scratch;
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"'resources/x'", "a link"}, [&] {
    Archive(write_zip(scratch.path() / "a.fmu", {{"resources/x", "/etc/passwd", S_IFLNK | 0777U}}));
  }));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"'x' twice"}, [&] {
    Archive(write_zip(scratch.path() / "a.fmu", {{"x", "1"}, {"x", "2"}}));
  }));
  const Archive same(write_zip(scratch.path() / "a.fmu", {{"x", "1"}, {"x", "1"}}));
  EXPECT_EQ(same.text("x", 10), "1");
}

TEST(FmuArchive, AFileThatIsMoreThanItMayBeIsRefused) {
  const Scratch scratch;
  const Archive archive(write_zip(scratch.path() / "a.fmu", {{"x", std::string(1001, 'x')}}));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"'x'", "1000 bytes"}, [&] { archive.text("x", 1000); }));
}

/// By the bytes that come out, in all files together.
TEST(FmuArchive, ABombIsRefusedBeforeItFillsTheDisk) {
  const Scratch scratch;
  const std::string zeros(600000, '\0');
  Archive archive(write_zip(scratch.path() / "a.fmu", {{"resources/1", zeros}, {"resources/2", zeros}}),
                  "FMU", 1000000);
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"unpacks to more than the 1000000 bytes"},
                      [&] { archive.unpack("resources/", scratch.path() / "out"); }));
}

TEST(FmuArchive, WhatIsNoArchiveIsRefused) {
  const Scratch scratch;
  for (const std::string text : {"", "no archive", "PK\x03\x04"})
    EXPECT_TRUE(refuses(ErrorCode::input_output, {"b.fmu' is no zip archive"},
                        [&] { Archive(scratch.write("b.fmu", text)); }));
  EXPECT_TRUE(
      refuses(ErrorCode::input_output, {"nothing.fmu"}, [&] { Archive(scratch.path() / "nothing.fmu"); }));
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"folder"}, [&] { Archive(scratch.path()); }));
}

/// Whatever byte is another, or wherever it ends: what is read is what was packed, or an error.
TEST(FmuArchive, NoDamagePassesUnseen) {
  const Scratch scratch;
  const std::string packed = "some words that are packed, some words that are not";
  const std::string whole = read_text(write_zip(scratch.path() / "a.fmu", {{"x", packed}}));
  const auto try_it = [&](const std::string& bytes) {
    try {
      const Archive archive(scratch.write("b.fmu", bytes));
      EXPECT_EQ(archive.has("x") ? archive.text("x", 1000) : packed, packed);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::input_output);
    }
  };
  for (std::size_t k = 0; k < whole.size(); ++k) {
    try_it(whole.substr(0, k));
    for (const char flip : {'\x01', '\x80', '\xff'}) {
      std::string bytes = whole;
      bytes[k] = static_cast<char>(bytes[k] ^ flip);
      try_it(bytes);
    }
  }
}

TEST(FmuArchive, ATemporaryFolderGoesWithItsOwner) {
  fs::path path;
  {
    const TemporaryFolder folder;
    path = folder.path();
    struct stat there {};
    ASSERT_EQ(::stat(path.c_str(), &there), 0);
    EXPECT_EQ(there.st_mode & 0777U, 0700U);
  }
  EXPECT_FALSE(fs::exists(path));
}

}  // namespace
}  // namespace tandem::test
