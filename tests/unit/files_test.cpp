// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Files that are read and written by a name that somebody gave.
#include "tandem/output/files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/input_file.hpp"
#include "tandem/output/json.hpp"
#include "tandem/output_file.hpp"
#include "tandem/transports/key_file.hpp"

namespace tandem {
namespace {

namespace fs = std::filesystem;
using test::refuses;
using test::Scratch;

fs::path fifo_in(const Scratch& folder, const std::string& name = "fifo") {
  EXPECT_EQ(::mkfifo((folder.path() / name).c_str(), 0600), 0);
  return folder.path() / name;
}

/// A socket of the file system, which nobody listens at.
fs::path socket_in(const Scratch& folder) {
  sockaddr_un address{AF_UNIX, {}};
  (folder.path() / "socket").string().copy(address.sun_path, sizeof address.sun_path - 1);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  EXPECT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ::close(socket);
  return folder.path() / "socket";
}

auto reading(const fs::path& file) {
  return [file] { read_file(file, 1000); };
}

TEST(InputFile, ReadsARegularFileAlsoByALink) {
  const Scratch folder;
  folder.write("a", "one\ntwo\n\nthree");
  fs::create_symlink(folder.path() / "a", folder.path() / "link");
  EXPECT_EQ(read_file(folder.path() / "link", 1000), "one\ntwo\n\nthree");
  InputFile in(folder.path() / "a");
  EXPECT_EQ(in.size(), 14U);
  std::vector<std::string> lines;
  for (std::string line; in.line(line);) lines.push_back(line);
  EXPECT_EQ(lines, (std::vector<std::string>{"one", "two", "", "three"}));
}

TEST(InputFile, FindsLinesOfAnyLengthOverTheBlocksItReads) {
  const Scratch folder;
  std::string text;
  std::vector<std::string> lines;
  for (const std::size_t length : {0, 1, 65535, 65536, 65537, 200000, 3}) {
    lines.push_back(std::string(length, static_cast<char>('a' + lines.size())));
    text += lines.back() + '\n';
  }
  InputFile in(folder.write("a", text));
  std::vector<std::string> found;
  for (std::string line; in.line(line);) found.push_back(line);
  EXPECT_EQ(found, lines);
}

TEST(InputFile, WaitsForNothingThatIsNoRegularFile) {
  const Scratch folder;
  const auto code = ErrorCode::input_output;
  EXPECT_TRUE(refuses(code, {"/fifo' can't be read: it is a FIFO; allowed is a regular file"},
                      reading(fifo_in(folder))));
  EXPECT_TRUE(refuses(code, {"it is a folder; allowed is a regular file"}, reading(folder.path())));
  EXPECT_TRUE(refuses(code, {"'/dev/zero' can't be read: it is a device"}, reading("/dev/zero")));
  EXPECT_TRUE(refuses(code, {"/socket' can't be read: "}, reading(socket_in(folder))));
  EXPECT_TRUE(refuses(code, {"file '/nowhere' is not there"}, reading("/nowhere")));
  EXPECT_TRUE(refuses(code, {"file '/dev/null/a' is not there"}, reading("/dev/null/a")));
}

TEST(InputFile, TakesNoMoreThanItIsTold) {
  const Scratch folder;
  const fs::path file = folder.write("a", std::string(1001, 'x'));
  EXPECT_TRUE(refuses(ErrorCode::input_output,
                      {"/a' can't be read: it has 1001 bytes; allowed are up to 1000"}, reading(file)));
  EXPECT_EQ(read_file(file, 1001).size(), 1001U);
  EXPECT_GT(read_file("/proc/self/status", 1U << 20).size(), 100U) << "its size is told as 0";
  fs::resize_file(file, InputFile::longest_line + 2);
  std::string line;
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"a line of more than"}, [&] { InputFile(file).line(line); }));
}

TEST(KeyFile, ThatIsAFifoIsRefusedAndNotWaitedFor) {
  const Scratch folder;
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"key file '", "it is a FIFO"},
                      [&] { read_key_file(fifo_in(folder), true); }));
}

TEST(OutputFile, ReplacesOrGoesOnOrIsNew) {
  const Scratch folder;
  const fs::path file = folder.path() / "a";
  const auto put = [&](OutputFile::Begin begin, const std::string& text) {
    OutputFile out(file, begin);
    out.write(text);
    EXPECT_EQ(out.written(), text.size());
    out.close();
  };
  put(OutputFile::Begin::fresh, "new");
  put(OutputFile::Begin::kept, " and more");
  EXPECT_EQ(test::read_text(file), "new and more");
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"/a' can't be written: File exists"},
                      [&] { put(OutputFile::Begin::fresh, "again"); }));
  put(OutputFile::Begin::empty, "other");
  EXPECT_EQ(test::read_text(file), "other");
}

TEST(OutputFile, WaitsForNoReaderOfAFifo) {
  const Scratch folder;
  const fs::path fifo = fifo_in(folder);
  for (const auto begin : {OutputFile::Begin::empty, OutputFile::Begin::kept})
    EXPECT_TRUE(refuses(ErrorCode::input_output, {"/fifo' can't be written: it is a FIFO"},
                        [&] { OutputFile(fifo, begin); }));
  const int reader = ::open(fifo.c_str(), O_RDONLY | O_NONBLOCK);
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"it is a FIFO; allowed is a regular file"},
                      [&] { OutputFile(fifo, OutputFile::Begin::empty); }));
  ::close(reader);
  EXPECT_NO_THROW(OutputFile("/dev/null", OutputFile::Begin::empty).write("gone"));
}

TEST(ReplaceText, LeavesNoPartWhateverGoesWrong) {
  const Scratch folder;
  const fs::path file = folder.path() / "a", part = folder.path() / "a.part";
  fifo_in(folder, "a.part");
  folder.write("elsewhere", "theirs");
  output::replace_text(file, "first");
  EXPECT_EQ(test::read_text(file), "first");
  fs::create_symlink(folder.path() / "elsewhere", part);
  output::replace_text(file, "second");
  EXPECT_EQ(test::read_text(file), "second");
  EXPECT_EQ(test::read_text(folder.path() / "elsewhere"), "theirs");
  EXPECT_FALSE(fs::exists(fs::symlink_status(part)));
}

TEST(ReplaceText, TakesThePlaceOfNothingThatIsNoRegularFile) {
  const Scratch folder;
  const fs::path fifo = fifo_in(folder);
  fs::create_directory(folder.path() / "b");
  for (const auto& [file, why] :
       {std::pair(fifo, "no regular file"), {folder.path() / "b", "there is a folder"}}) {
    EXPECT_TRUE(refuses(ErrorCode::input_output, {file.string(), why},
                        [at = file] { output::replace_text(at, "text"); }));
    EXPECT_FALSE(fs::exists(output::part_of(file)));
  }
  EXPECT_TRUE(fs::is_fifo(fifo));
}

TEST(Json, ANumberThatIsNoneIsToldByTheFile) {
  try {
    output::parse_json("{\"secret\": 123456789e999}", "file 'it'");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::input_output);
    EXPECT_STREQ(error.what(), "file 'it' has a number that is too large; allowed are those of 64 bits");
  }
}

TEST(Json, DeepOnesAreRefusedWithoutGoingDown) {
  const auto nested = [](int depth, const std::string& open, const std::string& close) {
    std::string text;
    for (int k = 0; k < depth; ++k) text += open;
    text += "0";
    for (int k = 0; k < depth; ++k) text += close;
    return text;
  };
  for (const auto& [open, close] : {std::pair("[", "]"), {"{\"a\":", "}"}}) {
    EXPECT_NO_THROW(output::parse_json(nested(output::deepest_json, open, close), "it"));
    EXPECT_TRUE(refuses(ErrorCode::input_output,
                        {"it has objects and arrays in each other more than 200 deep"},
                        [&] { output::parse_json(nested(output::deepest_json + 1, open, close), "it"); }));
    EXPECT_THROW(output::parse_json(nested(1'000'000, open, close), "it"), Error);
  }
  const std::string brackets(1000, '[');
  EXPECT_EQ(output::parse_json("{\"a\": \"\\\"" + brackets + "\"}", "it")["a"], "\"" + brackets);
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"it is not JSON: line 2, column 3"},
                      [] { output::parse_json("{\n  x}", "it"); }));
}

}  // namespace
}  // namespace tandem
