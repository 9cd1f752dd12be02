// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// A controller that samples, in each language and over each transport: the same bits, and each promise kept.
#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <iterator>
#include <sstream>

#include "c_oscillator.h"
#include "child.hpp"
#include "peers.hpp"
#include "python.hpp"
#include "refusal.hpp"
#include "run_bench.hpp"
#include "same_bits.hpp"
#include "scratch.hpp"
#include "served.hpp"
#include "tandem/c_subsystem.hpp"
#include "tandem/check.hpp"
#include "tandem/peer.h"

namespace tandem::test {
namespace {

const std::string pi_words = "kp=0.7&ki=0.3&r=1.1&T=0.3&offset=0.05&latency=0.02";

std::string pi_library(const std::string& language) {
  return "lib:" TANDEM_EXAMPLES "/example_pi_" + language + ".so";
}

std::unique_ptr<Subsystem> in_cpp() { return open(pi_library("cpp") + "?" + pi_words, all_sources()); }

/// The position of an oscillator to the controller, its force back.
std::vector<Recording::Rows> controlled(const Opener& controller, const std::string& schedule) {
  CSubsystem plant(c_oscillator(), "");
  const auto sampled = controller();
  RunBench bench;
  bench.add("plant", plant).add("control", *sampled).schedule(schedule);
  bench.connect("plant.x", "control.y", "lagrange3").connect("control.u", "plant.F", "");
  return bench.run(5.0).all();
}

struct PiPlace {
  const char* name;
  std::function<std::unique_ptr<Subsystem>()> open;
};
std::ostream& operator<<(std::ostream& out, const PiPlace& place) { return out << place.name; }

class SampledPeers : public testing::TestWithParam<PiPlace> {};

TEST_P(SampledPeers, GiveTheSameBits) {
  for (const char* schedule : {"slowest-first", "fastest-first", "parallel"})
    EXPECT_TRUE(same_bits(controlled(GetParam().open, schedule), controlled(in_cpp, schedule))) << schedule;
}

TEST_P(SampledPeers, KeepWhatASampledSubsystemPromises) {
  for (const Finding& finding : check(GetParam().open))
    EXPECT_EQ(finding.kind, Finding::Kind::left_out) << finding.check << ": " << finding.sentence;
}

TEST_P(SampledPeers, RefuseAnAdvance) {
  const auto sampled = GetParam().open();
  double row[3], y0 = 0.0;
  Samples rows(row, 3, 1);
  sampled->initialize(0.0, 1.0, {&y0, 1}, rows);
  const Segment piece = {1.0, 0.0, {0.0}};
  const Signal y(&piece, 1, 0);
  Samples more(row, 3, 1);
  EXPECT_THROW(sampled->advance(1.0, false, {&y, 1}, more), Error);
}

/// Goes with the program.
const Scratch& pi_folder() {
  static const Scratch it;
  return it;
}

/// Of a server of the library that all tests share.
PiPlace pi_served(const char* name, const std::string& address) {
  return {name, [=] {
            static std::map<std::string, std::unique_ptr<Served>> servers;
            auto& server = servers[name];
            if (!server) {
#if TANDEM_HAS_ZEROMQ
              auto listener =
                  address.starts_with("zmq+") ? zmq_listen(address.substr(4), {}) : listen(address, {});
#else
              auto listener = listen(address, {});
#endif
              server = std::make_unique<Served>(std::move(listener), source(pi_library("cpp")));
            }
            return open(server->address() + "?" + pi_words, all_sources());
          }};
}

std::unique_ptr<Subsystem> from_c() {
  static const Served server(listen("tcp://127.0.0.1:0", {}), source(pi_library("cpp")));
  return std::make_unique<CSubsystem>(tandem_remote(), server.address() + "?" + pi_words);
}

std::unique_ptr<Subsystem> from_c_to_c() {
  return std::make_unique<CSubsystem>(tandem_remote(),
                                      "spawn:" TANDEM_EXAMPLES "/example_pi_server?" + pi_words);
}

std::vector<PiPlace> pi_places() {
  std::vector<PiPlace> all = {
      {"c", [] { return open(pi_library("c") + "?" + pi_words, all_sources()); }},
      pi_served("tcp", "tcp://127.0.0.1:0"),
      pi_served("unix", "unix:" + (pi_folder().path() / "socket").string()),
      {"driven_by_c", from_c},
      {"driven_and_served_by_c", from_c_to_c},
      {"served_by_c",
       [] { return open("spawn:" TANDEM_EXAMPLES "/example_pi_server?" + pi_words, all_sources()); }},
      {"python", [] { return open("spawn:" + python_program("pi.py") + "?" + pi_words, all_sources()); }}};
#if TANDEM_FORTRAN
  all.push_back({"fortran", [] { return open(pi_library("fortran") + "?" + pi_words, all_sources()); }});
#endif
#if TANDEM_HAS_ZEROMQ
  all.push_back(pi_served("zmq", "zmq+tcp://127.0.0.1:0"));
#endif
#ifdef TANDEM_MEX_FOLDER
  all.push_back({"octave", [] {
                   static const PeerServer server(octave_program("pi.m"),
                                                  "unix:" + (pi_folder().path() / "octave").string());
                   return open(server.address() + "?deadline=20&" + pi_words, all_sources());
                 }});
#endif
  return all;
}

INSTANTIATE_TEST_SUITE_P(Each, SampledPeers, testing::ValuesIn(pi_places()),
                         [](const auto& test) { return std::string(test.param.name); });

/// What sampler.py and sampler.m print, from a subsystem in this process.
std::vector<double> sampled_here() {
  const auto sampled = in_cpp();
  const Sampling& sampling = sampled->info().sampling;
  std::vector<double> numbers = {sampling.period, sampling.latency, 1.0};
  double row[3], u = 0.0, y = 0.0;
  Samples rows(row, 3, 1);
  Clock clock = sampled->initialize(0.0, 10.0, {&u, 1}, rows);
  for (int k = 1; k <= 6; ++k) {
    const double t = clock.next_time;
    u = 0.1 * k;
    clock = sampled->sample(t, SamplePart::both, {&u, 1}, {&y, 1});
    numbers.insert(numbers.end(), {t, clock.next_time, y});
  }
  return numbers;
}

std::vector<double> sampled_by(const std::vector<std::string>& master) {
  const Served server(listen("tcp://127.0.0.1:0", {}), source(pi_library("cpp")));
  std::string line;
  for (const std::string& word : master) line += "'" + word + "' ";
  line += "'" + server.address() + "?deadline=20&" + pi_words + "' > out.txt";
  EXPECT_EQ(std::system(("cd '" + pi_folder().path().string() + "' && " + line).c_str()), 0) << line;
  std::istringstream text(read_text(pi_folder().path() / "out.txt"));
  return {std::istream_iterator<double>(text), {}};
}

TEST(SampledMasters, InPythonGetTheSameNumbers) {
  EXPECT_EQ(
      sampled_by({"env", "PYTHONPATH=" TANDEM_SOURCE_DIR "/transports/python", "PYTHONDONTWRITEBYTECODE=1",
                  TANDEM_PYTHON, TANDEM_SOURCE_DIR "/tests/programs/sampler.py"}),
      sampled_here());
}

#ifdef TANDEM_MEX_FOLDER
TEST(SampledMasters, InOctaveGetTheSameNumbers) {
  auto words = octave_program("");
  words.back() = TANDEM_SOURCE_DIR "/tests/programs/sampler.m";
  EXPECT_EQ(sampled_by(words), sampled_here());
}
#endif

/// What a server answers to a hello with these capabilities.
wire::Type answer_to(const std::string& address, std::uint32_t capabilities, std::string& sentence) {
  const auto channel = connect(address, {});
  wire::Writer frame;
  wire::begin(frame, wire::Type::hello, 1);
  wire::put_hello(frame, {.capabilities = capabilities, .text = pi_words});
  wire::finish(frame);
  channel->send(frame.bytes(), wire::in_seconds(5.0));
  const auto bytes = channel->receive(wire::in_seconds(20.0));
  const wire::Frame reply = wire::Frame::read(bytes, wire::usual_longest);
  if (reply.header.type == wire::Type::error) sentence = wire::read_error(reply.payload, nullptr).what();
  return reply.header.type;
}

/// A peer that was written before held outputs would take them for continuous ones.
TEST(SampledServers, RefuseAPeerThatDoesNotSpeakOfThem) {
  const Served cpp(listen("tcp://127.0.0.1:0", {}), source(pi_library("cpp")));
  const PeerServer c({TANDEM_EXAMPLES "/example_pi_server"}, "tcp://127.0.0.1:0");
  const PeerServer python(
      {"env", "PYTHONPATH=" TANDEM_SOURCE_DIR "/transports/python", "PYTHONDONTWRITEBYTECODE=1",
       TANDEM_PYTHON, TANDEM_SOURCE_DIR "/transports/examples/pi.py"},
      "tcp://127.0.0.1:0");
  for (const std::string& address : {cpp.address(), c.address(), python.address()}) {
    std::string sentence;
    EXPECT_EQ(answer_to(address, wire::carries_held, sentence), wire::Type::hello) << sentence;
    EXPECT_EQ(answer_to(address, 0xfffffffe, sentence), wire::Type::error);
    EXPECT_NE(
        sentence.find("subsystem 'pi' has held outputs or is sampled, of which the peer does not speak"),
        std::string::npos)
        << sentence;
  }
}

}  // namespace
}  // namespace tandem::test
