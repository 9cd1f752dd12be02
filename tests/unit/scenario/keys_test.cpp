// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The list of keys is what scenarios are read by, and what their page and schema are made from.
#include "tandem/scenario/keys.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "languages/languages.hpp"
#include "languages/schema.hpp"
#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/coordinator/reconstruction.hpp"
#include "tandem/engine/compile.hpp"
#include "tandem/engine/keys.hpp"
#include "tandem/engine/make_integrator.hpp"
#include "tandem/engine/read.hpp"
#include "tandem/mbs/make_stepper.hpp"
#include "tandem/scenario/scenario.hpp"
#include "tandem/scenario/sources.hpp"
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

std::string page_of(const std::string& language) {
  if (language == "study") return "docs/studies.md";
  return "docs/" + std::string(language == "scenario" ? "" : "keys_of_") + language + "s.md";
}

TEST(Keys, ThePagesAndTheSchemasOfTheTreeAreThoseOfTheProgram) {
  for (const auto& [name, keys] : languages()) {
    EXPECT_TRUE(text_of(page_of(name)).ends_with(keys.page()))
        << "stale: what `tandem help " << name << "` prints belongs at the end of its page";
    EXPECT_TRUE(text_of("scenarios/" + name + ".schema.json") ==
                schema(keys, "tandem " + name).dump(2) + "\n")
        << "scenarios/" << name << ".schema.json is stale: tandem schema " << name;
  }
}

/// The words of these keys stand twice: what reads files need not know all integrators.
TEST(Keys, SettingsOfRunsHaveTheWordsOfTheirMakers) {
  const auto words = [](const char* language, const char* key) {
    return std::set<std::string>(languages().at(language).find(key)->words.begin(),
                                 languages().at(language).find(key)->words.end());
  };
  std::set<std::string> formulations, integrators;
  for (const mbs::StepperNames& one : mbs::stepper_names())
    formulations.insert(one.formulation), integrators.insert(one.integrator);
  EXPECT_EQ(words("mechanism", "run.formulation"), formulations);
  EXPECT_EQ(words("mechanism", "run.integrator"), integrators);
  const auto names = engine::integrator_names();
  EXPECT_EQ(words("diagram", "run.integrator"), std::set<std::string>(names.begin(), names.end()));
}

/// Each setting that a client or an operator may give stands in the table, and nothing else does.
TEST(Keys, EverySettingOfASourceStandsInTheTableRun) {
  const Builtins sources = scenario::sources();
  for (const char* kind : {"mechanism", "diagram"}) {
    std::set<std::string> settings, keys{"start", "stop", "NAME"};
    for (const Word& word : sources.schemes.at(kind).words)
      if (!word.name.ends_with("*")) settings.insert(word.name);
    settings.merge(std::set<std::string>(keys));
    std::set<std::string> listed;
    for (const Key& key : languages().at(kind).all())
      if (key.path.starts_with("run.") && key.path.find('.', 4) == std::string::npos &&
          key.path != "run.inputs")
        listed.insert(key.path.substr(4));
    EXPECT_EQ(listed, settings) << kind;
  }
}

TEST(Keys, EachHasASentenceAndATableThatHoldsIt) {
  for (const auto& [name, keys] : languages())
    for (const Key& key : keys.all()) {
      EXPECT_FALSE(key.sentence.empty()) << key.path;
      EXPECT_EQ(key.type == Key::Type::word, !key.words.empty()) << key.path;
      EXPECT_EQ(key.type == Key::Type::any, key.type == Key::Type::any && !key.allowed.empty()) << key.path;
      const auto dot = key.path.rfind('.');
      if (dot == std::string::npos) continue;
      const std::string table = key.path.substr(0, dot);
      EXPECT_TRUE(std::any_of(keys.all().begin(), keys.all().end(), [&](const Key& one) {
        return one.path == table && one.type >= Key::Type::table && one.type <= Key::Type::tables;
      })) << key.path;
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

std::string found(const text::Keys& keys, const std::string& path) {
  std::string all;
  for (const Key* key : keys.matching(path)) all += (all.empty() ? "" : " ") + key->path;
  return all;
}

TEST(Keys, AreFoundAsAUserWritesThem) {
  EXPECT_EQ(found(keys(), "coordination.order"), "coordination.order");
  EXPECT_EQ(found(keys(), "connections.gain"), "connections[].gain");
  EXPECT_EQ(found(keys(), "connections[3].gain"), "connections[].gain");
  EXPECT_EQ(found(keys(), "subsystems.motor.parameters.R"), "subsystems.NAME.parameters.NAME");
  EXPECT_EQ(found(keys(), "subsystems.land"), "subsystems.NAME.land");
  EXPECT_EQ(found(languages().at("mechanism"), "rods.mass"), "rods.NAME.mass");
  EXPECT_EQ(found(languages().at("mechanism"), "rods"), "rods");
  EXPECT_EQ(found(keys(), "coordination.ordr"), "");
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"[coordination] 'ordr'", "did you mean 'order'?"},
                      [] { keys().refuse("coordination.ordr"); }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'spam'", "span"}, [] { keys().refuse("spam.stop"); }));
}

TEST(Keys, OfKindsAreFoundByTheKind) {
  const text::Keys& diagram = languages().at("diagram");
  ASSERT_EQ(diagram.matching("blocks.pid.low").size(), 1u);
  EXPECT_EQ(diagram.matching("blocks.pid.low")[0]->otherwise, "-inf");
  EXPECT_GT(diagram.matching("blocks.my_block.low").size(), 4u);  // of some kind
  ASSERT_EQ(diagram.matching("blocks.my_block").size(), 1u);
  EXPECT_TRUE(diagram.matching("blocks.my_block")[0]->kinds.empty());
  EXPECT_EQ(diagram.find("blocks.NAME.low", "gain"), nullptr);
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"[blocks.NAME]", "'lowest'"},
                      [&] { diagram.refuse("blocks.pid.lowest"); }));
}

/// What blocks of some kinds need besides, or otherwise, that all of their keys are looked at.
const std::map<std::string, std::map<std::string, std::string>> given = {
    {"csv", {{"file", "'x'"}, {"column", "'y'"}}},
    {"integrator", {{"reset", "1"}}},
    {"sample", {{"period", "1"}}},
    {"state_space", {{"inputs", "[1]"}, {"a", "[1]"}, {"b", "[1]"}, {"c", "[1]"}}},
    {"transfer_function", {{"numerator", "[1]"}, {"denominator", "[1, 1]"}}},
    {"unit_delay", {{"period", "1"}}}};

std::string right_value(const std::string& kind, const Key& key) {
  const std::string name = text::name_of(key);
  if (const auto own = given.find(kind); own != given.end() && own->second.contains(name))
    return own->second.at(name);
  if (!key.required || name == "kind") return "";
  if (!key.words.empty()) return "'" + key.words[0] + "'";
  if (name == "low") return "0";
  return key.type == Key::Type::numbers || key.type == Key::Type::signals ? "[0, 1]" : "1";
}

/// A diagram with a block of that kind, of which one key is of a wrong type.
std::string with_wrong(const text::Keys& language, const std::string& kind, const Key& wrong) {
  std::string block = "b = { kind = '" + kind + "'";
  const bool trigger = text::name_of(wrong) == "trigger", of_two = wrong.path == "blocks.NAME.inputs";
  for (const Key* key : language.in("blocks.NAME", kind)) {
    std::string value = &wrong == key ? key->type == Key::Type::flag ? "1" : "true" : right_value(kind, *key);
    if (trigger && text::name_of(*key) == "period") value.clear();
    if (kind == "function" && of_two && text::name_of(*key) == "function") value = "'min'";
    if (!value.empty()) block += ", " + text::name_of(*key) + " = " + value;
  }
  return "[blocks]\n" + block + " }\n[outputs]\nb = { unit = '1' }\n";
}

TEST(Keys, ABlockReadsEachKeyOfItsKind) {
  const text::Keys language = engine::diagram_keys();
  for (const Key* kind : language.kinds("blocks.NAME")) {
    const std::string word = kind->kinds[0];
    if (word == "diagram" || word == "triggered" || word == "machine") continue;  // have tests of their own
    for (const Key* wrong : language.in("blocks.NAME", word)) {
      if (wrong->kinds.empty()) continue;
      const std::string text = with_wrong(language, word, *wrong);
      EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {text::name_of(*wrong) + " is "}, [&] {
        engine::compile(engine::read_diagram("d", text));
      })) << text;
    }
  }
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
