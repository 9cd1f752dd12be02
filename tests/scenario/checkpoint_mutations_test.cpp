// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Checkpoints that are crafted: bytes changed, and the checksum put right again. Whatever they hold, a run
// that is resumed from them ends with an error or goes on; it never ends in a fault, changes no file before
// it is refused, and takes no more memory than the file is worth.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <random>

#include "resumable.hpp"

namespace tandem::test::crafted {
namespace {

/// Largest memory that this process ever took [bytes].
double peak() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

/// Changes of any kind, mostly behind the text, the same in each run of the tests.
class Mutations {
 public:
  explicit Mutations(std::uint64_t seed) : random_(seed) {}

  std::string one(const Resumable& of) {
    std::string bytes = of.bytes();
    for (auto count = 1 + random_() % 3; count > 0; --count) change(bytes, of.states());
    return put_right(bytes);
  }

 private:
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }

  void change(std::string& bytes, std::size_t states) {
    const std::size_t from = below(20) == 0 || bytes.size() < states + 16 ? head : states;
    const std::size_t place = from + below(bytes.size() - 8 - from);
    switch (below(8)) {
      case 0:
        return bytes.resize(place);
      case 1:
        return void(bytes.insert(place, std::string(1 + below(16), static_cast<char>(random_()))));
      case 2:
        return void(bytes.erase(place, 1 + below(16)));
      case 3:
      case 4:
        return put(bytes, place, static_cast<char>(random_()));
      case 5:
        return put(bytes, place, std::int64_t{1} << below(64));
      case 6:
        return put(bytes, place, static_cast<std::int32_t>(random_()));
      default:
        return put(bytes, place, odd_[below(std::size(odd_))]);
    }
  }

  std::mt19937_64 random_;
  static constexpr double odd_[] = {0.0,
                                    -1.0,
                                    1e300,
                                    -1e300,
                                    NAN,
                                    INFINITY,
                                    -INFINITY,
                                    0.5,
                                    1e-9,
                                    7.0,
                                    5e-324,
                                    1e9,
                                    std::numeric_limits<double>::max()};
};

struct Case {
  const char* name;
  const char* file;
  std::vector<std::string> overrides;
  int rounds;
};

const Case cases[] = {
    {"TwoMasses", "two_mass/two_mass.toml", {"span.stop=2"}, 17},
    {"TwoMassesAtOwnSteps", "two_mass/two_mass.toml", {"span.stop=2", "record.clock=own"}, 30},
    {"MeanAndHold",
     "two_mass/two_mass.toml",
     {"span.stop=2", "connections.reconstruction=lagrange0", "connections[0].reconstruction=mean"},
     21},
    {"LeastSquares",
     "two_mass/two_mass.toml",
     {"span.stop=2", "connections.reconstruction=least_squares2_3"},
     25},
    {"Parallel", "two_mass/two_mass.toml", {"span.stop=2", "coordination.schedule=parallel"}, 15},
    {"Mechanisms", "split_pendulum/split_pendulum.toml", {"span.stop=0.05"}, 12},
    {"Engine", "engine_linkage/engine_linkage.toml", {"span.stop=0.01"}, 9}};

class CraftedCheckpoints : public testing::TestWithParam<Case> {
 protected:
  Resumable run_{GetParam().file, GetParam().overrides, GetParam().rounds};
};
INSTANTIATE_TEST_SUITE_P(Runs, CraftedCheckpoints, testing::ValuesIn(cases),
                         [](const auto& one) { return one.param.name; });

/// How many; the environment may ask for more.
int mutations() {
  const char* more = std::getenv("TANDEM_MUTATIONS");
  return more ? std::atoi(more) : 400;
}

TEST_P(CraftedCheckpoints, NeverEndInAFaultNorChangeResultsBeforeTheyAreRefused) {
  EXPECT_EQ(run_.resumed(run_.bytes()), "");
  EXPECT_EQ(run_.same, 1) << "the one that was written gives the whole run";
  Mutations mutations_of(11);
  const double before = peak();
  for (int k = 0; k < mutations() && !HasFailure(); ++k) {
    SCOPED_TRACE(k);
    run_.resumed(mutations_of.one(run_));
  }
  RecordProperty("refused", run_.refused);
  EXPECT_GT(run_.refused, mutations() / 2);
  EXPECT_LT(peak() - before, 64e6);
}

/// Each number in turn, as one of 4 and as one of 8 bytes.
TEST_P(CraftedCheckpoints, WithAnyNumberMadeHugeTakeNoMemory) {
  const double before = peak();
  const std::size_t states = run_.states(), step = 1 + (run_.bytes().size() - states) / 150;
  for (std::size_t place = states; place + 8 <= run_.bytes().size() && !HasFailure(); place += step) {
    SCOPED_TRACE(place);
    std::string four = run_.bytes(), eight = four;
    put(four, place, std::uint32_t{0xffffffff});
    put(eight, place, std::int64_t{1} << 40);
    run_.resumed(put_right(four));
    run_.resumed(put_right(eight));
  }
  EXPECT_LT(peak() - before, 64e6);
}

/// What the recorder saved: time, size and checksum of its file, then of each subsystem a list of rows, the
/// row that it is at, and a flag.
class CraftedRecorder : public testing::Test {
 protected:
  void refused(std::string bytes, const std::string& sentence) {
    const std::string said = run_.resumed(put_right(std::move(bytes)));
    EXPECT_TRUE(contains(said, sentence)) << said;
  }
  /// The checkpoint with a number at this place of the recorder's.
  template <class T>
  std::string with(std::size_t place, T value) const {
    std::string bytes = run_.bytes();
    put(bytes, run_.recorder() + place, value);
    return bytes;
  }

  Resumable run_{"two_mass/two_mass.toml", {"span.stop=2"}, 17};
};

TEST_F(CraftedRecorder, ABeginningOfTheResultsThatIsNoneIsRefused) {
  const auto size = number_at<std::uint64_t>(run_.bytes(), run_.recorder() + 8);
  refused(with(8, std::uint64_t{0}), "has 0 bytes of results.csv; allowed are 1 or more");
  refused(with(8, std::uint64_t{1} << 62), "it is shorter than");
  refused(with(16, std::uint64_t{0}), "bytes are others than those of the run at the checkpoint");
  refused(with(0, std::numeric_limits<double>::quiet_NaN()), "begins at no time");
  std::string in_a_row = with(8, size - 3);
  const std::string part = run_.results_text().substr(0, size - 3);
  put(in_a_row, run_.recorder() + 16, checksum(std::as_bytes(std::span(part))));
  refused(in_a_row, "bytes are others than those of the run at the checkpoint");
}

TEST_F(CraftedRecorder, ARowThatItIsAtIsOneOfThoseThatWait) {
  const auto numbers_at = [&](std::size_t place) {
    return number_at<std::uint32_t>(run_.bytes(), run_.recorder() + place);
  };
  std::size_t track = 24;
  while (numbers_at(track) == 0) track += 4 + 8 + 1;
  const std::size_t rows = track + 4, cursor = rows + 8 * numbers_at(track);
  for (const std::uint64_t wrong :
       {std::uint64_t{numbers_at(track)}, std::uint64_t{1} << 60, ~std::uint64_t{0}})
    refused(with(cursor, wrong), " recorded numbers and is at row ");
  refused(with(rows, std::numeric_limits<double>::infinity()), "recorded rows that are not finite");
}

TEST_F(CraftedRecorder, TextsAndLengthsThatAreNoneAreRefused) {
  std::string bytes = run_.bytes();
  refused(bytes.substr(0, bytes.size() - 1), "ends after");
  refused(bytes + '\0', "has 1 bytes more than it should");
  for (const std::string& text : std::vector<std::string>{
           std::string("5"), std::string("null"), std::string("[]"), std::string("{}"),
           std::string(100'000, '['),
           std::string("{\"tandem\":") + std::string(300, '[') + std::string(300, ']') + "}"}) {
    std::string other = bytes.substr(0, head) + std::string(4, '\0') + text + bytes.substr(run_.states());
    put(other, head, static_cast<std::uint32_t>(text.size()));
    const std::string said = run_.resumed(put_right(other));
    EXPECT_TRUE(contains(said, "checkpoint '")) << said;
    EXPECT_LT(said.size(), 2000U);
  }
}

}  // namespace
}  // namespace tandem::test::crafted
