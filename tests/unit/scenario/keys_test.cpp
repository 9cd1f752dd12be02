// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The list of keys is what scenarios are read by, and what their page and schema are made from.
#include "scenario/keys.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "refusal.hpp"
#include "scenario/scenario.hpp"
#include "scenario/schema.hpp"
#include "scratch.hpp"
#include "tandem/coordinator/reconstruction.hpp"
#include "tandem/text/section.hpp"

namespace tandem::scenario {
namespace {

using test::refuses;
using test::Scratch;
using text::Key;

std::string text_of(const std::string& file) {
  std::ifstream in(std::string(TANDEM_SOURCE_DIR) + "/" + file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Keys, ThePageAndTheSchemaOfTheTreeAreThoseOfTheProgram) {
  EXPECT_NE(text_of("docs/scenarios.md").find(keys().page()), std::string::npos)
      << "docs/scenarios.md is stale: what `tandem help scenario` prints belongs at its end";
  EXPECT_EQ(text_of("scenarios/scenario.schema.json"), schema(keys(), "tandem scenario").dump(2) + "\n")
      << "scenarios/scenario.schema.json is stale: tandem schema scenario";
}

TEST(Keys, EachHasASentenceAndATableThatHoldsIt) {
  for (const Key& key : keys().all()) {
    EXPECT_FALSE(key.sentence.empty()) << key.path;
    const auto dot = key.path.rfind('.');
    if (dot == std::string::npos) continue;
    const Key* table = keys().find(key.path.substr(0, dot));
    ASSERT_NE(table, nullptr) << key.path;
    EXPECT_TRUE(table->type == Key::Type::table || table->type == Key::Type::tables) << key.path;
    EXPECT_EQ(key.type == Key::Type::word, !key.words.empty()) << key.path;
  }
}

/// A scenario in which each key of the list is left out, of the wrong type, or a word that is not allowed.
const std::string every_table = R"(
name = "scene"
[parameters]
k = 1
[subsystems.a]
source = "builtin:x"
land = "never"
parameters = { k = 2 }
inputs = { u = 1 }
[[connections]]
from = "a.y"
to = "a.u"
reconstruction = "lagrange1"
[coordination]
order = ["a"]
communication_step = 0.1
[span]
stop = 1
[record]
ports = ["a.y"]
[reference]
file = "r.csv"
tolerance = 0.1
[judge]
quantity = "a.y"
tolerance = 0.1
[view]
plots = ["a.y"]
[[ladder.judged]]
quantity = "a.y"
tolerance = 0.1
[[ladder.rungs]]
name = "one"
outputs = { "a.y" = 1.0 }
[[ladder.rungs]]
name = "two"
)";

/// The key as --set names it in that scenario.
std::string in_that_file(std::string path) {
  for (const auto& [from, to] :
       {std::pair{"subsystems.NAME", "subsystems.a"}, {"[]", "[0]"}, {".NAME", ".k"}})
    for (auto at = path.find(from); at != std::string::npos; at = path.find(from))
      path.replace(at, std::string(from).size(), to);
  return path;
}

TEST(Keys, AWrongTypeIsRefusedForEachKeyByItsName) {
  const Scratch folder;
  const auto file = folder.write("scene.toml", every_table);
  EXPECT_NO_THROW(read(file));
  for (const Key& key : keys().all()) {
    if (key.path.find("outputs.") != std::string::npos) continue;  // by the judged quantity
    const std::string path = in_that_file(key.path), wrong = key.type == Key::Type::texts ? "1" : "[[1]]";
    const auto last = path.substr(path.rfind('.') + 1);
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {last}, [&] { read(file, {path + "=" + wrong}); }))
        << path;
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"colour"}, [&] {
      if (key.type == Key::Type::table && keys().find(key.path + ".NAME"))
        throw Error(ErrorCode::invalid_argument, "colour: any name is allowed");
      read(file, {(key.type == Key::Type::table ? path + "." : "") + "colour=1"});
    })) << path;
  }
}

TEST(Keys, WordsAreThoseThatTheCoordinatorKnows) {
  const Key& how = *keys().find("connections[].reconstruction");
  for (const std::string& word : how.words) EXPECT_EQ(Reconstruction::parse(word).name(), word);
  for (const char* word : {"least_squares0_1", "least_squares4_16", "least_squares2_9"}) {
    EXPECT_TRUE(how.allows(word)) << word;
    EXPECT_EQ(Reconstruction::parse(word).name(), word);
  }
  for (const char* word :
       {"least_squares5_1", "least_squares1_17", "least_squares1_0", "lagrange5", "held", ""}) {
    EXPECT_FALSE(how.allows(word)) << word;
    EXPECT_TRUE(
        refuses(ErrorCode::invalid_argument, {"reconstruction"}, [&] { Reconstruction::parse(word); }));
  }
}

TEST(Keys, AreFoundAsAUserWritesThem) {
  EXPECT_EQ(keys().named("coordination.order").path, "coordination.order");
  EXPECT_EQ(keys().named("connections.gain").path, "connections[].gain");
  EXPECT_EQ(keys().named("connections[3].gain").path, "connections[].gain");
  EXPECT_EQ(keys().named("subsystems.motor.parameters.R").path, "subsystems.NAME.parameters.NAME");
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"[coordination] 'ordr'", "did you mean 'order'?"},
                      [] { keys().named("coordination.ordr"); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'spam'", "span"}, [] { keys().named("spam.stop"); }));
}

/// What the list and the reader do not agree on ends the read, whoever is wrong.
TEST(Keys, AReaderAndItsListAgree) {
  const text::Document document("x", "a = 1\n");
  const text::Keys list({{.path = "a", .type = Key::Type::number, .sentence = "A."},
                         {.path = "b", .type = Key::Type::flag, .sentence = "B."}});
  text::Section root(document, list);
  EXPECT_EQ(root.number("a"), 1.0);
  EXPECT_THROW(root.refuse_unknown(), std::logic_error);  // nobody has asked for b
  EXPECT_THROW(root.text("c"), std::logic_error);
  EXPECT_EQ(root.flag("b"), std::nullopt);
  EXPECT_NO_THROW(root.refuse_unknown());
}

}  // namespace
}  // namespace tandem::scenario
