// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Files that are FIFOs, too deep, too wide or too many, through the commands that read and write them.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "command.hpp"

namespace tandem::test {
namespace {

namespace fs = std::filesystem;
using Arguments = std::vector<std::string>;

std::string nested(int depth, const std::string& open, const std::string& close) {
  std::string text;
  for (int k = 0; k < depth; ++k) text += open;
  for (int k = 0; k < depth; ++k) text += close;
  return text;
}

class OddFiles : public testing::Test {
 protected:
  std::string fifo(const std::string& name) const {
    EXPECT_EQ(::mkfifo((folder.path() / name).c_str(), 0600), 0);
    return name;
  }
  void says(const Arguments& words, const std::string& sentence, int status = 2) const {
    const Said said = tandem(folder, words);
    EXPECT_EQ(said.status, status) << words[0] << " " << words[1] << ": " << said.err.substr(0, 1000);
    EXPECT_TRUE(contains(said.err, sentence))
        << words[0] << " " << words[1] << ": " << said.err.substr(0, 1000);
  }
  /// A short run of the two masses into a folder.
  Arguments run(const std::string& output, const Arguments& more = {}) const {
    Arguments words = {
        "run", two_mass_file("two_mass.toml"), "--no-reference", "--set", "span.stop=1", "--output", output};
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }
  const Scratch folder;
};

TEST_F(OddFiles, AFifoIsReadByNoCommand) {
  const std::string sentence = "it is a FIFO; allowed is a regular file";
  fifo("f.toml"), fifo("f.csv"), fifo("f.m"), fifo("f.so");
  for (const Arguments& words : {Arguments{"run", "f.toml"},
                                 {"validate", "f.toml"},
                                 {"info", "f.toml"},
                                 {"modes", "f.toml"},
                                 {"ladder", "f.toml"},
                                 {"info", "mechanism:f.toml"},
                                 {"info", "diagram:f.toml"},
                                 {"info", "lib:f.so"},
                                 {"info", "three_functions:f.so?step=1"},
                                 {"info", "functions:f.so?step=0.1"},
                                 {"compare", "f.csv", "f.csv"},
                                 {"view", "f.csv"},
                                 {"run", two_mass_file("two_mass.toml"), "--resume", "f.csv"}})
    says(words, sentence);
  says({"info", "functions:f.m?step=0.1"}, "there is no file");
  says({"validate", "/dev/zero"}, "it is a device; allowed is a regular file");
}

TEST_F(OddFiles, AFifoInTheFolderOfResultsIsReadByNoCommand) {
  fs::create_directory(folder.path() / "o");
  fifo("o/results.json"), fifo("o/ladder.json"), fifo("o/ladder.csv");
  const std::string sentence = "it is a FIFO; allowed is a regular file";
  says({"view", "o"}, sentence);
  says({"compare", "o", "o"}, sentence);
  says({"chart", "ladder", "--results", "o"}, sentence);
  fs::create_directory(folder.path() / "s");
  fifo("s/schemes.part");
  const std::string study = TANDEM_SOURCE_DIR "/scenarios/motor_crank/study.toml";
  says({"sweep", study, "--resume", "--output", "s"}, sentence, 1);
  fs::create_directory(folder.path() / "c");
  fifo("c/schemes.csv");
  says({"chart", study, "--results", "c"}, sentence);
}

TEST_F(OddFiles, AFifoIsWrittenByNoCommand) {
  const std::string sentence = "can't be written: it is a FIFO";
  for (const std::string name : {"results.csv", "checkpoint", "results.json", "machine.json"}) {
    fs::create_directory(folder.path() / name);
    fifo(name + "/" + name);
    const bool before_the_run = name.starts_with("results"), replaced = name != "results.csv";
    says(run(name, {"--checkpoint-every", "0.1"}), replaced ? "what is there is no regular file" : sentence,
         before_the_run ? 2 : 1);
  }
  says({"--log", fifo("log"), "list", "builtins"}, "log file 'log' can't be written: it is a FIFO");
  ASSERT_EQ(tandem(folder, run("o")).status, 0);
  fifo("o/view.html");
  says({"view", "o", "--plots-only"}, "what is there is no regular file");
  fs::create_directory(folder.path() / "d");
  fifo("d/results.csv");
  says(run("d", {"--set", "record.clock=own", "--resume", "o/results.csv"}), "is no checkpoint");
}

TEST_F(OddFiles, DeepTomlAndJsonAreRefusedByEveryCommand) {
  constexpr int depth = 50'000;
  folder.write("keys.toml", nested(depth, "a.", "") + "a = 1\n");
  folder.write("header.toml", "[" + nested(depth, "a.", "") + "a]\n");
  folder.write("arrays.toml", "a = " + nested(depth, "[", "]") + "\n");
  for (const std::string file : {"keys.toml", "header.toml", "arrays.toml"})
    for (const Arguments& words : {Arguments{"run", file},
                                   {"validate", file},
                                   {"info", "mechanism:" + file},
                                   {"info", "diagram:" + file},
                                   {"ladder", file},
                                   {"modes", file}})
      says(words, file + ":1: tables and arrays stand in each other more than 100 deep");
  says(run("o", {"--set", nested(20'000, "a.", "") + "a=1"}), "more than 100 deep");
  says(run("o", {"--set", "parameters.a=" + nested(20'000, "[", "]")}), "more than 100 deep");
  ASSERT_EQ(tandem(folder, run("o")).status, 0);
  for (const std::string& text :
       std::vector<std::string>{nested(depth, "[", "]"), nested(depth, "{\"scenario\":", "}")}) {
    folder.write("o/results.json", text);
    says({"view", "o"}, "objects and arrays in each other more than 200 deep");
    says({"compare", "o", "o"}, "objects and arrays in each other more than 200 deep");
  }
}

/// Each value of what `tandem run` writes, put in place of each other kind of value.
TEST_F(OddFiles, ResultsJsonOfAnotherShapeIsRefusedWithASentence) {
  using Json = nlohmann::json;
  ASSERT_EQ(tandem(folder, run("o")).status, 0);
  const Json whole = Json::parse(read_text(folder.path() / "o/results.json"));
  const Json flat = whole.flatten();
  std::set<std::string> paths = {""};
  for (const auto& [path, value] : flat.items())
    for (std::size_t at = path.size(); at != std::string::npos && at > 0; at = path.rfind('/', at - 1))
      paths.insert(path.substr(0, at));
  for (const std::string& path : paths)
    for (const Json& other : {Json(3), Json("x"), Json::array({1}), Json::object(), Json()}) {
      Json changed = whole;
      changed[Json::json_pointer(path)] = other;
      folder.write("o/results.json", changed.dump());
      for (const Arguments& words : {Arguments{"view", "o"}, {"compare", "o", "o"}}) {
        const Said said = tandem(folder, words);
        ASSERT_GE(said.status, 0) << path << " " << other << " ended by a signal";
        ASSERT_FALSE(contains(said.err, "json.exception")) << path << " " << other << ": " << said.err;
      }
    }
}

/// Was quadratic in reading, in comparing and in choosing what to plot.
TEST_F(OddFiles, ATableOfManyColumnsIsComparedAndIsTooMuchForAPage) {
  std::string names = "time", row = "0";
  for (int k = 1; k < 300'000; ++k) names += ",c" + std::to_string(k), row += ",1";
  folder.write("wide.csv", names + "\n" + row + "\n");
  EXPECT_EQ(tandem(folder, {"compare", "wide.csv", "wide.csv", "--quiet"}).status, 0);
  says({"view", "wide.csv"}, "file 'wide.csv' has 299999 columns; a page can show up to 100000");
}

}  // namespace
}  // namespace tandem::test
