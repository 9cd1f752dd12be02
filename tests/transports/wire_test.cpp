// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// The codec, against the bytes that docs/wire_protocol.md shows, and against bytes that are not right. (One file, as all of it
// goes by the page's frames.)
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "refusal.hpp"
#include "scratch.hpp"
#include "tandem/wire/messages.hpp"

namespace tandem::wire {
namespace {

constexpr Scalars one_input{1, 1, false};

using test::refuses;
using Bytes = std::vector<std::byte>;

Bytes bytes_of(const Writer& w) { return {w.bytes().begin(), w.bytes().end()}; }

/// The frames of the page, in its order.
std::vector<Bytes> frames_of_the_page() {
  std::istringstream page(test::read_text(TANDEM_SOURCE_DIR "/docs/wire_protocol.md"));
  std::vector<Bytes> frames;
  bool inside = false;
  for (std::string line; std::getline(page, line);) {
    if (line == "```hex") frames.emplace_back();
    if (line.starts_with("```")) {
      inside = line == "```hex";
      continue;
    }
    if (!inside) continue;
    std::istringstream numbers(line.substr(0, line.find('#')));
    for (unsigned byte; numbers >> std::hex >> byte;) frames.back().push_back(static_cast<std::byte>(byte));
  }
  return frames;
}

SubsystemInfo mass2() {
  return {"mass2",
          {{"x1", "m"}},
          {{"x2", "m", 1, 2}, {"v2", "m/s", 1, 1}},
          {},
          {.lands = true, .restarts = true}};
}

DeclaredParameters mass() { return {{"m", "kg", {}, "mass"}}; }

/// A sampled one.
SubsystemInfo pi() {
  SubsystemInfo info{"pi",     {{"w", "rad/s"}},  {{"u", "V"}},
                     {{0, 0}}, {.sampled = true}, {1.0 / 128, 1.0 / 512}};
  info.outputs[0].held = true;
  return info;
}

/// Frames put one after another.
class Talk {
 public:
  template <class Put>
  Talk& say(Type type, std::uint32_t number, const Put& put) {
    begin(frame_, type, number);
    put(frame_);
    finish(frame_);
    frames.push_back(bytes_of(frame_));
    return *this;
  }
  Talk& say(Type type, std::uint32_t number) {
    return say(type, number, [](Writer&) {});
  }
  std::vector<Bytes> frames;

 private:
  Writer frame_;
};

void put_row(Samples& y, double t, std::initializer_list<double> values) {
  std::copy(values.begin(), values.end(), y.append(t));
}

std::vector<Bytes> frames_of_the_codec() {
  double memory[16];
  Samples start(memory, 8, 2);
  put_row(start, 0.0, {1, 0, 0, -1.5, -1.5, 0});
  Talk talk;
  talk.say(Type::hello, 1, [](Writer& w) { put_hello(w, {.text = "m=2"}); });
  talk.say(Type::hello, 1, [](Writer& w) { put_hello(w, {.text = "tandem", .declared = mass()}); });
  talk.say(Type::info, 2);
  talk.say(Type::info, 2, [](Writer& w) { put_info(w, mass2()); });
  talk.say(Type::initialize, 3, [](Writer& w) { put_initialize(w, {0.0, 10.0, 4, {0.5}}); });
  talk.say(Type::samples, 3, [&](Writer& w) { put_samples(w, {0.0, 0.25, Stop::limit}, start); });
  const Segment pieces[] = {{0.25, 0.25, {0.5, -1.0}}, {0.5, 0.5, {0.25, -1.0}}};
  const Signal u(pieces, 2, 1);
  talk.say(Type::advance, 4, [&](Writer& w) { put_advance(w, {0.5, false, 4}, {&u, 1}); });
  Samples y(memory, 8, 2);
  put_row(y, 0.25, {0.96875, -0.25, -0.25, -1, -1, 0});
  put_row(y, 0.5, {0.875, -0.5, -0.5, -0.75, -0.75, 0});
  talk.say(Type::samples, 4, [&](Writer& w) { put_samples(w, {0.5, 0.75, Stop::limit}, y); });
  const auto state = [](Writer& w) { put_id(w, 1); };
  talk.say(Type::save, 5).say(Type::save, 5, state).say(Type::restore, 6, state);
  talk.say(Type::restore, 6, [](Writer& w) { put_clock(w, {0.5, 0.75, Stop::limit}); });
  talk.say(Type::release, 7, state).say(Type::release, 7);
  const auto second = [](Writer& w) { put_id(w, 2); };
  const auto third = [](Writer& w) { put_id(w, 3); };
  const auto bytes = [](Writer& w) { w.put_bytes(std::as_bytes(std::span("\1\2\3", 3))); };
  talk.say(Type::serialize, 8, second).say(Type::serialize, 8, bytes);
  talk.say(Type::deserialize, 9, bytes).say(Type::deserialize, 9, third);
  const auto beat = [](Writer& w) { w.put_bytes(std::as_bytes(std::span("beat", 4))); };
  talk.say(Type::ping, 10, beat).say(Type::ping, 10, beat);
  talk.say(Type::error, 11, [](Writer& w) { put_error(w, ErrorCode::invalid_argument, "no saved state 7"); });
  talk.say(Type::bye, 12).say(Type::bye, 12);
  talk.say(Type::info, 2, [](Writer& w) { put_info(w, pi()); });
  talk.say(Type::initialize, 3, [](Writer& w) { put_initialize(w, {0.0, 10.0, 1, {0.5}}); });
  Samples before(memory, 3, 1);
  put_row(before, 0.0, {1.0});
  talk.say(Type::samples, 3, [&](Writer& w) { put_samples(w, {0.0, 0.25, Stop::limit}, before); });
  const double w_now = 0.5, u_now = -2.0;
  talk.say(Type::sample, 4, [&](Writer& w) { put_sample(w, 0.25, SamplePart::both, {&w_now, 1}); });
  talk.say(Type::sample, 4, [&](Writer& w) { put_sampled(w, {0.25, 0.2578125, Stop::limit}, {&u_now, 1}); });
  return talk.frames;
}

TEST(Wire, TheCodecWritesTheBytesOfThePage) {
  const auto page = frames_of_the_page(), codec = frames_of_the_codec();
  ASSERT_EQ(page.size(), codec.size());
  for (std::size_t k = 0; k < page.size(); ++k) EXPECT_EQ(page[k], codec[k]) << "frame " << k;
}

std::span<const std::byte> payload(const Bytes& frame) { return Frame::read(frame, usual_longest).payload; }

TEST(Wire, TheCodecReadsTheBytesOfThePage) {
  const auto page = frames_of_the_page();
  EXPECT_EQ(read_hello(payload(page[0])).text, "m=2");
  const Hello reply = read_hello(payload(page[1]), all_capabilities);
  ASSERT_TRUE(reply.declared && reply.declared->size() == 1);
  EXPECT_EQ(reply.declared->front().unit, "kg");
  EXPECT_EQ(reply.declared->front().otherwise, std::nullopt);
  const SubsystemInfo info = read_info(payload(page[3]));
  EXPECT_EQ(info.name, "mass2");
  EXPECT_TRUE(info.abilities.lands && info.abilities.restarts && !info.abilities.saves_state);
  EXPECT_EQ(info.row_size(), mass2().row_size());
  EXPECT_TRUE(std::isnan(info.inputs[0].start));
  Initialize start;
  read_initialize(payload(page[4]), 1, start);
  EXPECT_EQ(start.u0, std::vector<double>{0.5});
  Advance advance;
  read_advance(payload(page[6]), one_input, advance);
  EXPECT_EQ(advance.t_limit, 0.5);
  EXPECT_EQ(advance.signals[0].value(0.125), 0.625);
  EXPECT_EQ(advance.signals[0].value(0.5), 0.25);
  double memory[16];
  Samples y(memory, 8, 2);
  EXPECT_EQ(read_samples(payload(page[7]), y).next_time, 0.75);
  EXPECT_EQ(y.size(), 2);
  EXPECT_EQ(y.values(1)[0], 0.875);
  EXPECT_EQ(read_error(payload(page[20]), nullptr).what(), std::string("no saved state 7"));
}

TEST(Wire, TheCodecReadsASampledSubsystemOfThePage) {
  const auto page = frames_of_the_page();
  const SubsystemInfo info = read_info(payload(page[23]));
  EXPECT_TRUE(info.abilities.sampled && info.outputs[0].held);
  EXPECT_EQ(info.sampling.period, 1.0 / 128);
  EXPECT_EQ(info.sampling.latency, 1.0 / 512);
  Sample request;
  read_sample(payload(page[26]), 1, request);
  EXPECT_EQ(request.t, 0.25);
  EXPECT_EQ(request.part, SamplePart::both);
  EXPECT_EQ(request.u, std::vector<double>{0.5});
  double u = 0.0;
  EXPECT_EQ(read_sampled(payload(page[27]), {&u, 1}).next_time, 0.2578125);
  EXPECT_EQ(u, -2.0);
}

/// A copy with a number overwritten.
template <class T>
Bytes with(Bytes bytes, std::size_t place, T value) {
  const auto number = to_wire(value);
  std::copy(number.begin(), number.end(), bytes.begin() + static_cast<std::ptrdiff_t>(place));
  return bytes;
}

TEST(Wire, AHeaderThatIsNotRightIsRefused) {
  const Bytes hello = frames_of_the_page()[0];
  const auto reading = [](const Bytes& b) { return [b] { Frame::read(b, 1000); }; };
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"5 bytes", "16 or more"},
                      reading({hello.begin(), hello.begin() + 5})));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"type 15", "1 to 14"}, reading(with(hello, 8, 15U))));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"type 0"}, reading(with(hello, 8, 0U))));
  for (const std::uint64_t length : {std::uint64_t{1001}, std::numeric_limits<std::uint64_t>::max()})
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'hello'", std::to_string(length), "up to 1000"},
                        reading(with(hello, 0, length))));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"announces 34", "35 follow"},
                      reading(with(hello, 0, std::uint64_t{34}))));
}

template <class Read>
void refuses_each_cut(const Bytes& frame, const Read& read) {
  const auto whole = payload(frame);
  EXPECT_NO_THROW(read(whole));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"the message"}, [&] { read(whole.first(size)); }))
        << size;
  Bytes longer(whole.begin(), whole.end());
  longer.push_back(std::byte{0});
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"1 bytes more"}, [&] { read(longer); }));
}

TEST(Wire, APayloadThatIsCutAnywhereOrGoesOnIsRefused) {
  const auto page = frames_of_the_page();
  refuses_each_cut(page[0], [](auto p) { read_hello(p); });
  refuses_each_cut(page[1], [](auto p) { read_hello(p, all_capabilities); });
  refuses_each_cut(page[3], [](auto p) { read_info(p); });
  refuses_each_cut(page[4], [](auto p) {
    Initialize request;
    read_initialize(p, 1, request);
  });
  refuses_each_cut(page[6], [](auto p) {
    Advance request;
    read_advance(p, one_input, request);
  });
  refuses_each_cut(page[7], [](auto p) {
    double memory[32];
    Samples y(memory, 8, 4);
    read_samples(p, y);
  });
  refuses_each_cut(page[11], [](auto p) { read_clock(p); });
  refuses_each_cut(page[10], [](auto p) { read_id(p); });
  refuses_each_cut(page[23], [](auto p) { read_info(p); });
  refuses_each_cut(page[26], [](auto p) {
    Sample request;
    read_sample(p, 1, request);
  });
  refuses_each_cut(page[27], [](auto p) {
    double y = 0.0;
    read_sampled(p, {&y, 1});
  });
}

TEST(Wire, NumbersThatMakeNoSenseAreRefusedBeforeAnythingIsAllocatedForThem) {
  const auto page = frames_of_the_page();
  const auto reading = [](const Bytes& b) {
    return [b] {
      Advance request;
      read_advance(payload(b), one_input, request);
    };
  };
  const std::size_t at = header_size;
  const Bytes& advance = page[6];
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  const auto code = ErrorCode::invalid_argument;
  EXPECT_TRUE(refuses(code, {"t_limit"}, reading(with(advance, at, nan))));
  EXPECT_TRUE(refuses(code, {"2 for land"}, reading(with(advance, at + 8, 2U))));
  EXPECT_TRUE(refuses(code, {"2 inputs; allowed are 1"}, reading(with(advance, at + 12, 2U))));
  EXPECT_TRUE(refuses(code, {"announces 4294967295"}, reading(with(advance, at + 12, 0xffffffffU))));
  EXPECT_TRUE(refuses(code, {"0 segments"}, reading(with(advance, at + 24, 0U))));
  EXPECT_TRUE(refuses(code, {"4294967295 segments"}, reading(with(advance, at + 24, 0xffffffffU))));
  EXPECT_TRUE(refuses(code, {"degree 6"}, reading(with(advance, at + 28, 6U))));
  EXPECT_TRUE(refuses(code, {"not finite"}, reading(with(advance, at + 32, nan))));
  EXPECT_TRUE(refuses(code, {"not finite"}, reading(with(advance, at + 48, infinite))));
  double memory[16];
  Samples y(memory, 8, 2), one(memory, 8, 1), other(memory, 4, 4);
  const auto rows = [&](const Bytes& b, Samples& to) { return [&to, b] { read_samples(payload(b), to); }; };
  EXPECT_TRUE(refuses(code, {"4 as the reason"}, rows(with(page[7], at + 16, 4U), y)));
  EXPECT_TRUE(refuses(code, {"2 rows", "up to 1"}, rows(page[7], one)));
  EXPECT_TRUE(refuses(code, {"rows of 8", "allowed are 4"}, rows(page[7], other)));
  EXPECT_TRUE(refuses(code, {"18446744073709551615 rows"},
                      rows(with(page[7], at + 24, std::numeric_limits<std::uint64_t>::max()), y)));
  EXPECT_TRUE(refuses(code, {"TANDEM"}, [&] { read_hello(payload(with(page[0], at, 'H'))); }));
  EXPECT_TRUE(
      refuses(code, {"text of 1048577"}, [&] { read_hello(payload(with(page[0], at + 28, 1048577U))); }));
  EXPECT_TRUE(refuses(code, {"announces 100000000"},
                      [&] { read_info(payload(with(page[3], at + 13, 100000000U))); }));
}

TEST(Wire, SamplesThatMakeNoSenseAreRefused) {
  const auto page = frames_of_the_page();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto code = ErrorCode::invalid_argument;
  const std::size_t at = header_size, held = page[23].size() - 28;
  const auto asking = [](const Bytes& b) {
    return [b] {
      Sample request;
      read_sample(payload(b), 1, request);
    };
  };
  const Bytes& request = page[26];
  EXPECT_TRUE(refuses(code, {"a t that is not finite"}, asking(with(request, at, nan))));
  for (const std::uint32_t parts : {0U, 4U, 0xffffffffU})
    EXPECT_TRUE(refuses(code, {"the parts " + std::to_string(parts), "1 to 3"},
                        asking(with(request, at + 8, parts))));
  EXPECT_TRUE(refuses(code, {"0 inputs; allowed are 1"}, asking(with(request, at + 12, 0U))));
  EXPECT_TRUE(refuses(code, {"an input that is not finite"}, asking(with(request, at + 16, nan))));
  const auto told = [&](const Bytes& b) { return [b] { read_info(payload(b)); }; };
  EXPECT_TRUE(refuses(code, {"2 for whether output 'u' is held"}, told(with(page[23], held, 2U))));
  EXPECT_TRUE(refuses(code, {"not all of its outputs are held"}, told(with(page[23], held, 0U))));
  EXPECT_TRUE(refuses(code, {"period of nan s"}, told(with(page[23], held + 4, nan))));
  EXPECT_TRUE(refuses(code, {"latency of -1 s"}, told(with(page[23], held + 12, -1.0))));
  double y[2];
  EXPECT_TRUE(refuses(code, {"1 numbers", "allowed are 2"}, [&] { read_sampled(payload(page[27]), y); }));
  EXPECT_TRUE(refuses(code, {"announces 1000000"},
                      [&] { read_sampled(payload(with(page[27], at + 20, 1000000U)), y); }));
}

TEST(Wire, RowsBeforeAnErrorComeWithIt) {
  double memory[6] = {}, there[6] = {};
  Samples y(memory, 3, 2), got(there, 3, 2);
  y.append(0.1)[0] = 7.0;
  Writer frame;
  begin(frame, Type::error, 1);
  put_error(frame, Error(ErrorCode::numerical, "no convergence"), y);
  finish(frame);
  const Error error = read_error(payload(bytes_of(frame)), &got);
  EXPECT_EQ(error.code(), ErrorCode::numerical);
  ASSERT_EQ(got.size(), 1);
  EXPECT_EQ(got.values(0)[0], 7.0);
}

}  // namespace
}  // namespace tandem::wire
