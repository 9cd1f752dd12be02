// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Models in each language say which parameters they take; what is not among them is refused from the command
// line on.
#include <gtest/gtest.h>

#include "by_hand.hpp"
#include "command.hpp"
#include "peers.hpp"
#include "python.hpp"
#include "refusal.hpp"
#include "served.hpp"
#include "tandem/c_subsystem.hpp"
#include "tandem/peer.h"

namespace tandem::test {
namespace {

/// Mass 2 in a language, as a source to which "?key=value" is added.
struct Language {
  const char* name;
  std::string source;
};
std::ostream& operator<<(std::ostream& out, const Language& language) { return out << language.name; }

std::vector<Language> languages() {
  const std::string examples = TANDEM_EXAMPLES;
  std::vector<Language> all = {
      {"c", "lib:" + examples + "/example_mass2_c.so"},
      {"cpp", "lib:" + examples + "/example_mass2_cpp.so"},
      {"served", "spawn:" TANDEM_COMMAND " serve lib:" + examples + "/example_mass2_c.so"},
      {"c_server", "spawn:" + c_mass2()},
      {"python", "spawn:" + python_program("mass2.py")}};
#if TANDEM_FORTRAN
  all.push_back({"fortran", "lib:" + examples + "/example_mass2_fortran.so"});
  all.push_back({"fortran_server", "spawn:" + examples + "/example_mass2_server_fortran"});
#endif
#ifdef TANDEM_MEX_FOLDER
  std::string octave = "spawn:";
  for (const std::string& word : octave_program("mass2.m")) octave += word + " ";
  all.push_back({"octave", octave});
#endif
  return all;
}

class DeclaredParametersIn : public testing::TestWithParam<Language> {
 protected:
  /// `tandem info SOURCE?parameters`, with a deadline for the start of Octave on a busy machine.
  Said info(const std::string& parameters) const {
    const bool elsewhere = GetParam().source.starts_with("spawn:");
    return test::tandem(folder_,
                        {"info", GetParam().source + (elsewhere ? "?deadline=30&" : "?") + parameters});
  }
  static bool lists_them(const Said& said) {
    return contains(said.out, "  parameter m [kg], needed: mass\n") &&
           contains(said.out, "  parameter s [N/m], needed: stiffness of both springs together\n") &&
           contains(said.out, "  parameter h [s], needed: own step\n");
  }

 private:
  Scratch folder_;
};

TEST_P(DeclaredParametersIn, AreListedByInfo) {
  const Said said = info("m=1&k=2&s=3&x=0&v=1&h=0.1");
  EXPECT_EQ(said.status, 0) << said.err;
  EXPECT_TRUE(lists_them(said)) << said.out;
  EXPECT_TRUE(contains(said.out, "x2  unit m")) << said.out;
}

TEST_P(DeclaredParametersIn, AreListedByInfoAlsoWhereOneIsMissing) {
  const Said said = info("m=1");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "parameter 'k' is needed")) << said.err;
  EXPECT_TRUE(lists_them(said)) << said.out;
}

TEST_P(DeclaredParametersIn, AMisspeltOneIsRefusedWithTheNearest) {
  const Said said = info("m=1&k=2&s=3&x=0&v=1&hh=0.1");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "mass2")) << said.err;  // of the source
  EXPECT_TRUE(
      contains(said.err, "parameter 'hh' is not there; did you mean 'h'? There are: m, k, s, x, v, h\n"))
      << said.err;
  EXPECT_TRUE(lists_them(said)) << said.out;
}

TEST_P(DeclaredParametersIn, ATextIsRefusedWhereANumberIsDeclared) {
  for (const std::string text : {"big", "1e", "nan", "inf", "0x10", ""}) {
    if (text != "big" && GetParam().source.starts_with("spawn:"))
      continue;  // the same check; a program takes a second
    const Said said = info("m=1&s=3&x=0&v=1&h=0.1&k=" + text);
    EXPECT_EQ(said.status, 2);
    EXPECT_TRUE(contains(said.err, "parameter 'k' is '" + text + "'; allowed is a finite number in N/m\n"))
        << said.err;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, DeclaredParametersIn, testing::ValuesIn(languages()),
                         [](const auto& test) { return std::string(test.param.name); });

/// In a scenario the sentence has file, line and subsystem, too.
TEST(DeclaredParameters, OfAScenarioAreRefusedWithItsPlaceAndSubsystem) {
  const Scratch folder;
  folder.write("scene.toml",
               "name = \"scene\"\n[subsystems.slow]\nsource = \"lib:" TANDEM_EXAMPLES
               "/example_mass2_c.so\"\n"
               "parameters = { m = 1, k = 2, s = 3, x = 0, v = 1, hh = 0.1 }\n[span]\nstop = 1.0\n");
  const Said said = test::tandem(folder, {"run", "scene.toml"});
  EXPECT_EQ(said.status, 2);
  for (const char* part : {"scene.toml:", "subsystem 'slow'", "example_mass2_c.so'", "did you mean 'h'?"})
    EXPECT_TRUE(contains(said.err, part)) << said.err;
}

/// A library that is isolated tells from its process what it takes.
TEST(DeclaredParameters, OfAnIsolatedLibraryAreRefusedToo) {
  const Scratch folder;
  folder.write("scene.toml", "name = \"scene\"\n[subsystems.slow]\nsource = \"lib:" TANDEM_EXAMPLES
                             "/example_mass2_c.so\"\n"
                             "isolate = true\nparameters = { hh = 0.1 }\n[span]\nstop = 1.0\n");
  const Said said = test::tandem(folder, {"run", "scene.toml"});
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said.err, "parameter 'hh' is not there; did you mean 'h'?")) << said.err;
}

/// What a server was told by its operator, a client needs not give.
TEST(DeclaredParameters, OfAServerMayBeTheOperators) {
  const Served server(listen("tcp://127.0.0.1:0", {}),
                      source("lib:" TANDEM_EXAMPLES "/example_mass2_c.so?m=2&k=1"));
  EXPECT_NO_THROW(open(server.address() + "?s=1&x=0&v=0&h=0.1", all_sources()));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"gives 'm' twice"},
                      [&] { open(server.address() + "?m=3&s=1&x=0&v=0&h=0.1", all_sources()); }));
}

TEST(DeclaredParameters, AServerOfBeforeTellsNoneAndTakesAny) {
  const SubsystemInfo info{"by hand", {}, {{"x", "m"}}, {}, {}};
  const ByHand server(
      {{wire::Type::hello,
        [](wire::Writer& w) { wire::put_hello(w, {.capabilities = wire::carries_held, .text = "before"}); }},
       {wire::Type::info, [&](wire::Writer& w) { wire::put_info(w, info, wire::carries_held); }}});
  const auto far = open(server.address() + "?colour=blue", all_sources());
  EXPECT_TRUE(far->info().parameters.empty());
  EXPECT_EQ(far->info().outputs[0].nominal, 1.0);
}

/// A peer that declares and takes any all the same: it is the client who refuses.
TEST(DeclaredParameters, AreCheckedWhateverThePeerDoes) {
  const auto hello = [](wire::Writer& w) {
    wire::put_hello(w, {.text = "lax", .declared = DeclaredParameters{{"mass", "kg", "1", "its mass"}}});
  };
  const ByHand server({{wire::Type::hello, hello}});
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {server.address(), "hello", "did you mean 'mass'?"},
                      [&] { open(server.address() + "?mas=2", all_sources()); }));
}

/// What a server answers to a hello with these capabilities and parameters.
std::vector<std::byte> answer(const std::string& address, std::uint32_t capabilities,
                              const std::string& parameters) {
  const auto channel = connect(address, {});
  wire::Writer frame;
  wire::begin(frame, wire::Type::hello, 1);
  wire::put_hello(frame, {.capabilities = capabilities, .text = parameters});
  wire::finish(frame);
  channel->send(frame.bytes(), wire::in_seconds(5.0));
  const auto bytes = channel->receive(wire::in_seconds(20.0));
  return {bytes.begin(), bytes.end()};
}

/// A client of before is told of the error, or that it is there, and of nothing more.
TEST(DeclaredParameters, AClientOfBeforeIsToldOfNone) {
  const Served cpp(listen("tcp://127.0.0.1:0", {}), source("lib:" TANDEM_EXAMPLES "/example_mass2_cpp.so"));
  const PeerServer c({c_mass2()}, "tcp://127.0.0.1:0");
  const PeerServer python({"sh", "-c", "exec " + python_program("mass2.py") + " \"$@\"", "sh"},
                          "tcp://127.0.0.1:0");
  for (const std::string& address : {cpp.address(), c.address(), python.address()}) {
    for (const bool speaks : {false, true}) {
      const std::uint32_t capabilities = speaks ? wire::all_capabilities : wire::carries_held;
      const auto bad = answer(address, capabilities, "m=1"),
                 good = answer(address, capabilities, "m=1&k=2&s=3&x=0&v=1&h=0.1");
      const wire::Frame error = wire::Frame::read(bad, wire::usual_longest);
      ASSERT_EQ(error.header.type, wire::Type::error);
      DeclaredParameters declared;
      EXPECT_TRUE(contains(wire::read_error(error.payload, declared).what(), "'k' is needed"));
      EXPECT_EQ(declared.size(), speaks ? 6U : 0U) << address;
      const auto hello = wire::read_hello(wire::Frame::read(good, wire::usual_longest).payload, capabilities);
      EXPECT_EQ(hello.declared.has_value(), speaks) << address;
    }
  }
}

/// By its table, which has no instance, a subsystem elsewhere declares none; its server refuses.
TEST(DeclaredParameters, OfAServerAreRefusedToAMasterInC) {
  const Served server(listen("tcp://127.0.0.1:0", {}), source("lib:" TANDEM_EXAMPLES "/example_mass2_c.so"));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"parameter 'hh' is not there; did you mean 'h'?"},
                      [&] { CSubsystem(tandem_remote(), server.address() + "?hh=1"); }));
}

}  // namespace
}  // namespace tandem::test
