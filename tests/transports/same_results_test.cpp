// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The file results.csv of a run is the same, byte for byte, wherever its subsystems live.
#include <gtest/gtest.h>

#include "child.hpp"
#include "command.hpp"
#include "curve_pair.hpp"
#include "examples.hpp"
#include "mass2_library.hpp"
#include "peers.hpp"
#include "python.hpp"
#include "tls_pair.hpp"

namespace tandem::test {
namespace {

/// The results of a scenario of that text, or the sentence of its error.
std::string results_of(const Scratch& folder, const std::string& text) {
  folder.write("scene.toml", text);
  const Said said = tandem(folder, {"run", "scene.toml", "--output", "results"});
  return said.status == 0 ? read_text(folder.path() / "results/results.csv") : said.err;
}

/// A case of the two-mass sweep.
struct Masses {
  double frequency_ratio;
  const char *schedule, *to_fast, *to_slow;
};
const Masses sweep[] = {{30.7, "slowest-first", "lagrange3", "lagrange3"},
                        {10.0, "fastest-first", "lagrange2", "mean"},
                        {2.5, "parallel", "lagrange1", "lagrange1"}};

std::string scene_of(const Masses& m, const std::string& fast, const std::string& slow) {
  return "[subsystems]\nfast.source = \"" + fast + "\"\nslow.source = \"" + slow +
         "\"\n[[connections]]\nfrom = \"slow.x2\"\nto = \"fast.x2\"\nreconstruction = \"" + m.to_fast +
         "\"\n[[connections]]\nfrom = \"fast.x1\"\nto = \"slow.x1\"\nreconstruction = \"" + m.to_slow +
         "\"\n[coordination]\nschedule = \"" + m.schedule + "\"\n[span]\nstop = 20.0\n";
}

const std::string fast_mass = "builtin:two_mass.fast", slow_mass = "builtin:two_mass.slow";
std::string with_ratio(const Masses& m) { return "?frequency_ratio=" + std::to_string(m.frequency_ratio); }
std::string masses_here(const Masses& m) {
  return scene_of(m, fast_mass + with_ratio(m), slow_mass + with_ratio(m));
}

/// Mass 2 from that source, whose URI its parameters follow.
void gives_the_same_results(const std::string& mass2) {
  for (const Masses& m : sweep) {
    const Scratch folder;
    const std::string expected = results_of(folder, masses_here(m));
    ASSERT_TRUE(contains(expected, "time,fast.x1")) << expected;
    const auto there = scene_of(m, fast_mass + with_ratio(m), mass2 + mass2_parameters(m.frequency_ratio));
    EXPECT_EQ(results_of(folder, there), expected) << mass2 << ", " << m.schedule;
  }
}

TEST(SameResults, OfMass2InAnyLanguageInAnyPlace) {
  const Scratch folder;
  for (const std::string& language : library_languages()) gives_the_same_results(mass2_library(language));
  gives_the_same_results("spawn:" + c_mass2() + "?");
  gives_the_same_results("spawn:" + python_program("mass2.py") + "?");
  const std::string address = "unix:" + (folder.path() / "socket").string();
  for (const std::string& at : {std::string("tcp://127.0.0.1:0"), address})
    gives_the_same_results(PeerServer({c_mass2()}, at).address() + "?");
}

/// `tandem serve SOURCE` over the transport of that name, each with keys of its own.
class ServedOver {
 public:
  ServedOver(const std::string& transport, const std::string& source) {
    if (transport == "spawn") {
      uri_ = "spawn:" TANDEM_COMMAND " serve " + source + "?";
      return;
    }
    const auto keys = keys_of(transport);
    std::vector<std::string> words = {TANDEM_COMMAND, "serve", source};
    words.insert(words.end(), keys.server_words.begin(), keys.server_words.end());
    server_.emplace(words, address_of(transport));
    uri_ = server_->address() + "?" + keys.query;
  }
  /// To be followed by parameters.
  const std::string& uri() const { return uri_; }

 private:
  struct Keys {
    std::vector<std::string> server_words;
    std::string query;
  };
  Keys keys_of(const std::string& transport) {
    if (transport == "tls") {
      const TlsFolder& f = tls_.emplace();
      return {{"--key", f.file("server.key"), "--authority", f.file("authority.crt")}, f.query() + "&"};
    }
#if TANDEM_HAS_ZEROMQ
    if (transport == "zmq:curve") {
      const CurveFolder& f = curve_.emplace();
      return {{"--key", f.file("server"), "--client-key", f.file("client.pub")}, f.query() + "&"};
    }
#endif
    return {};
  }
  std::string address_of(const std::string& transport) const {
    const std::string file = (folder_.path() / "socket").string(), port = "127.0.0.1:0";
    if (transport == "unix") return "unix:" + file;
    if (transport == "zmq:ipc") return "zmq:ipc://" + file;
    return (transport.starts_with("zmq:") ? "zmq:tcp" : transport) + "://" + port;
  }

  Scratch folder_;
  std::optional<TlsFolder> tls_;
#if TANDEM_HAS_ZEROMQ
  std::optional<CurveFolder> curve_;
#endif
  std::optional<PeerServer> server_;
  std::string uri_;
};

class SameResultsOver : public testing::TestWithParam<const char*> {};

TEST_P(SameResultsOver, OfTwoMasses) {
  const ServedOver fast(GetParam(), fast_mass), slow(GetParam(), slow_mass);
  for (const Masses& m : sweep) {
    const Scratch folder;
    const std::string expected = results_of(folder, masses_here(m)), ratio = with_ratio(m).substr(1);
    ASSERT_TRUE(contains(expected, "time,fast.x1")) << expected;
    EXPECT_EQ(results_of(folder, scene_of(m, fast.uri() + ratio, slow.uri() + ratio)), expected)
        << m.schedule;
  }
}

/// Half a second of it, with that source where it is not its own file.
std::string engine_linkage(const std::string& engine = "", const std::string& linkage = "") {
  const Scratch folder;
  std::vector<std::string> words = {"run",
                                    TANDEM_SOURCE_DIR "/scenarios/engine_linkage/engine_linkage.toml",
                                    "--no-reference",
                                    "--set",
                                    "span.stop=0.5",
                                    "--output",
                                    "results"};
  for (const auto& [name, uri] : {std::pair("engine", engine), {"linkage", linkage}})
    if (!uri.empty())
      words.insert(words.end(), {"--set", "subsystems." + std::string(name) + ".source=" + uri});
  const Said said = tandem(folder, words);
  return said.status == 0 ? read_text(folder.path() / "results/results.csv") : said.err;
}

TEST_P(SameResultsOver, OfTheEngineAndTheLinkage) {
  const std::string files = TANDEM_SOURCE_DIR "/scenarios/engine_linkage/";
  const ServedOver engine(GetParam(), "diagram:" + files + "engine.toml");
  const ServedOver linkage(GetParam(), "mechanism:" + files + "linkage.toml");
  const std::string expected = engine_linkage();
  ASSERT_TRUE(contains(expected, "time,linkage.speed")) << expected;
  const std::string deadline = "deadline=20";
  EXPECT_EQ(engine_linkage(engine.uri() + deadline), expected);
  EXPECT_EQ(engine_linkage("", linkage.uri() + deadline), expected);
  EXPECT_EQ(engine_linkage(engine.uri() + deadline, linkage.uri() + deadline), expected);
}

std::vector<const char*> transports_here() {
  return {
    "spawn", "tcp", "unix",
#if TANDEM_HAS_TLS
        "tls",
#endif
#if TANDEM_HAS_ZEROMQ
        "zmq:tcp", "zmq:ipc", "zmq:curve",
#endif
  };
}
INSTANTIATE_TEST_SUITE_P(Each, SameResultsOver, testing::ValuesIn(transports_here()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), ':', '_');
  return name;
});

}  // namespace
}  // namespace tandem::test
