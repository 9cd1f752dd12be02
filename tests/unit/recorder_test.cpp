// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/coordinator/recorder.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "recorder_bench.hpp"
#include "recording.hpp"
#include "refusal.hpp"
#include "scratch.hpp"
#include "scripted.hpp"
#include "tandem/text/time_table.hpp"

namespace tandem {
namespace {

using test::cubic_of_time;
using test::line;
using test::read_text;
using test::RecorderBench;
using test::refuses;
using test::Scratch;
using test::Scripted;
using test::shapes;
using test::slope;
using text::TimeTable;

const std::vector<double>& column(const TimeTable& table, const std::string& name) {
  const auto it = std::find(table.names.begin(), table.names.end(), name);
  return table.columns.at(static_cast<std::size_t>(it - table.names.begin()));
}

TEST(Recorder, RowsStandAtTheOwnStepsOfTheSmallestStep) {
  const Scratch folder;
  RecorderBench({0.25, 0.1}).record({folder.path(), "", false, {}});
  const TimeTable table = TimeTable::read(folder.path());
  ASSERT_EQ(table.times.size(), 21U);
  for (std::size_t k = 0; k < table.times.size(); ++k)
    EXPECT_EQ(table.times[k], static_cast<double>(k) * 0.1);
  EXPECT_EQ(table.names,
            (std::vector<std::string>{"a.c", "a.l", "a.a[0]", "a.a[1]", "b.c", "b.l", "b.a[0]", "b.a[1]"}));
}

/// Hermite is exact for the cubic, linear interpolation for the line: errors are rounding, below
/// 1e-14 at values below 12.
TEST(Recorder, OtherOutputsAreInterpolatedByHermiteOrLinearly) {
  const Scratch folder;
  const auto recorder = RecorderBench({0.25, 0.1}).record({folder.path(), "", false, {}});
  const TimeTable table = TimeTable::read(folder.path());
  for (std::size_t k = 0; k < table.times.size(); ++k) {
    EXPECT_NEAR(column(table, "a.c")[k], cubic_of_time(table.times[k]), 1e-14);
    EXPECT_NEAR(column(table, "a.l")[k], line(table.times[k]), 1e-14);
  }
  EXPECT_EQ(recorder->columns()[0].fill, Recorder::Fill::hermite);
  EXPECT_EQ(recorder->columns()[1].fill, Recorder::Fill::linear);
  EXPECT_EQ(recorder->columns()[4].fill, Recorder::Fill::own);
  EXPECT_EQ(recorder->columns()[1].unit, "N");
  EXPECT_EQ(recorder->notes(), std::vector<std::string>{});
}

/// The derivative of a cubic is one of its Hermite polynomial, whose rounding is divided by the step.
TEST(Recorder, DerivativesStandBesideOutputsThatGiveThem) {
  for (const bool own : {false, true}) {
    const Scratch folder;
    Recording what{folder.path(), "", own, {}};
    what.derivatives = true;
    RecorderBench bench({0.25, 0.1});
    const auto recorder = bench.record(what);
    const TimeTable table = TimeTable::read(recorder->files()[0]);
    EXPECT_EQ(std::count(table.names.begin(), table.names.end(), "der(a.l)"), 0);
    for (std::size_t k = 0; k < table.times.size(); ++k)
      EXPECT_NEAR(column(table, "der(a.c)")[k], slope(table.times[k]), 1e-12);
    EXPECT_EQ(recorder->columns()[1].name, "der(a.c)");
    EXPECT_EQ(recorder->columns()[1].unit, recorder->columns()[0].unit + "/s");
  }
}

TEST(Recorder, NumbersReadBackTheSameToTheLastBit) {
  const Scratch folder;
  RecorderBench bench({0.1});
  bench.record({folder.path(), "", false, {}});
  const TimeTable table = TimeTable::read(folder.path());
  for (std::size_t k = 0; k < table.times.size(); ++k) {
    EXPECT_EQ(column(table, "a.a[1]")[k], std::sin(static_cast<double>(k) * 0.1));
    EXPECT_EQ(column(table, "a.c")[k], cubic_of_time(static_cast<double>(k) * 0.1));
  }
}

TEST(Recorder, AnyInstanceCanBeTheClock) {
  const Scratch folder;
  RecorderBench({0.25, 0.1}).record({folder.path(), "a", false, {}});
  const TimeTable table = TimeTable::read(folder.path());
  EXPECT_EQ(table.times.size(), 9U);
  EXPECT_EQ(column(table, "a.c")[3], cubic_of_time(0.75));
  EXPECT_NEAR(column(table, "b.c")[3], cubic_of_time(0.75), 1e-14);
}

TEST(Recorder, OwnModeWritesAFileForEachSubsystem) {
  const Scratch folder;
  RecorderBench bench({0.25, 0.1});
  const auto recorder = bench.record({folder.path(), "", true, {}});
  EXPECT_EQ(recorder->files().size(), 2U);
  const TimeTable a = TimeTable::read(folder.path() / "results.a.csv"),
                  b = TimeTable::read(folder.path() / "results.b.csv");
  EXPECT_EQ(a.times.size(), 9U);
  EXPECT_EQ(b.times.size(), 21U);
  EXPECT_EQ(a.names, (std::vector<std::string>{"a.c", "a.l", "a.a[0]", "a.a[1]"}));
  EXPECT_EQ(column(b, "b.c")[7], cubic_of_time(7.0 * 0.1));
  EXPECT_EQ(recorder->columns()[0].fill, Recorder::Fill::own);
}

TEST(Recorder, WritesOnlyThePortsThatAreNamed) {
  const Scratch folder;
  RecorderBench({0.25, 0.1}).record({folder.path(), "", false, {"b.a", "a.a[1]", "b.l"}});
  EXPECT_EQ(TimeTable::read(folder.path()).names,
            (std::vector<std::string>{"a.a[1]", "b.l", "b.a[0]", "b.a[1]"}));
}

TEST(Recorder, RefusesPortsAndClocksThatAreNotThere) {
  const RecorderBench bench({0.25, 0.1});
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'a.x'", "a.a[1]"}, [&] {
    Recorder(*bench.run, {".", "", false, {"a.x"}});
  }));
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"'c'", "a, b"}, [&] {
    Recorder(*bench.run, {".", "c", false, {}});
  }));
}

/// The slow side can't land: its last node is 1.8, so from 1.9 on it has no sample.
TEST(Recorder, LeavesCellsEmptyAfterASubsystemsLastSample) {
  const Scratch folder;
  const auto recorder = RecorderBench({0.6, 0.1}).record({folder.path(), "", false, {"a.c", "b.c"}});
  const TimeTable table = TimeTable::read(folder.path());
  ASSERT_EQ(table.times.size(), 21U);
  EXPECT_NEAR(column(table, "a.c")[18], cubic_of_time(1.8), 1e-14);
  EXPECT_TRUE(std::isnan(column(table, "a.c")[19]));
  EXPECT_EQ(column(table, "b.c")[20], cubic_of_time(2.0));
  ASSERT_EQ(recorder->notes().size(), 1U);
  EXPECT_NE(recorder->notes()[0].find("'a' are empty after t = 1.7999999999999998 s"), std::string::npos)
      << recorder->notes()[0];
}

/// A million numbers, far more than the memory that is reserved, and a clock that leads by up to 300 rows.
TEST(Recorder, LongRunsAreWrittenInPieces) {
  const Scratch folder;
  RecorderBench({0.3, 0.001}, 60.0).record({folder.path(), "", false, {}});
  const TimeTable table = TimeTable::read(folder.path());
  ASSERT_EQ(table.times.size(), 60001U);
  for (std::size_t k = 0; k < table.times.size(); k += 7) {
    ASSERT_EQ(column(table, "b.a[1]")[k], std::sin(static_cast<double>(k) * 0.001));
    ASSERT_NEAR(column(table, "a.l")[k], line(table.times[k]), 1e-12);
  }
}

TEST(Recorder, ARunThatFailsKeepsWhatWasRecorded) {
  const Scratch folder;
  RecorderBench bench({0.25, 0.1});
  Scripted& fast = *bench.subsystems[1];
  fast.instead_of_advance = [&](double, bool, std::span<const Signal> u, Samples& y) {
    if (!fast.grid().fits(1.0)) throw Error(ErrorCode::numerical, "it broke");
    for (; fast.grid().fits(1.0); fast.put(u, y)) fast.grid().step();
    return fast.clock(Stop::samples_full);
  };
  {
    Recorder recorder(*bench.run, {folder.path(), "", false, {}});
    bench.run->observe(&recorder);
    EXPECT_TRUE(refuses(ErrorCode::numerical, {"it broke"}, [&] { bench.run->run(); }));
  }  // closed by its destructor
  const TimeTable table = TimeTable::read(folder.path());
  EXPECT_EQ(table.times.back(), 1.0);
}

/// Own steps of 0.1 s before one that breaks, or has a value that is not finite, in one call with it.
TEST(Recorder, ACallThatFailsKeepsTheStepsThatItTook) {
  for (const bool throws : {true, false})
    for (const Schedule::Kind schedule :
         {Schedule::Kind::slowest_first, Schedule::Kind::fastest_first, Schedule::Kind::parallel}) {
      const Scratch folder;
      Coordination coordination;
      coordination.schedule = schedule;
      RecorderBench bench({1.0, 0.1}, 2.0, coordination);
      Scripted& fast = *bench.subsystems[1];
      fast.instead_of_advance = [&](double limit, bool, std::span<const Signal> u, Samples& y) {
        while (fast.grid().fits(limit)) {
          fast.grid().step();
          const bool breaks = fast.grid().time() > 1.35;
          if (breaks && throws) throw Error(ErrorCode::numerical, "it broke");
          fast.put(u, y);
          if (breaks) y.append(fast.grid().time() + 0.01)[0] = NAN;
        }
        return fast.clock(Stop::limit);
      };
      Recorder recorder(*bench.run, {folder.path(), "", true, {}});
      bench.run->observe(&recorder);
      EXPECT_THROW(bench.run->run(), Error);
      recorder.close();
      EXPECT_DOUBLE_EQ(TimeTable::read(folder.path() / "results.b.csv").times.back(), throws ? 1.3 : 1.4);
    }
}

TEST(Recorder, NamesAFolderThatCannotBeWrittenTo) {
  RecorderBench bench({0.25});
  Recorder recorder(*bench.run, {"/dev/null/folder", "", false, {}});
  bench.run->observe(&recorder);
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"'/dev/null/folder'", "Not a directory"},
                      [&] { bench.run->initialize(); }));
}

TEST(Recorder, ARunThatCannotBeginLeavesEarlierResults) {
  const Scratch folder;
  folder.write("results.csv", "earlier");
  RecorderBench bench({0.25});
  bench.subsystems[0]->instead_of_initialize = [](double, std::span<const double>, Samples&) -> Clock {
    throw Error(ErrorCode::numerical, "no start");
  };
  Recorder recorder(*bench.run, {folder.path(), "", false, {}});
  bench.run->observe(&recorder);
  EXPECT_TRUE(refuses(ErrorCode::numerical, {"no start"}, [&] { bench.run->initialize(); }));
  recorder.close();
  EXPECT_EQ(read_text(folder.path() / "results.csv"), "earlier");
}

TEST(Recorder, AFullDiskIsAnErrorOnceAndNotInTheDestructor) {
  const Scratch folder;
  std::filesystem::create_symlink("/dev/full", folder.path() / "results.csv");
  RecorderBench bench({0.25});
  Recorder recorder(*bench.run, {folder.path(), "", false, {}});
  bench.run->observe(&recorder);
  bench.run->run();
  EXPECT_TRUE(refuses(ErrorCode::input_output, {"results.csv", "No space left"}, [&] { recorder.close(); }));
  EXPECT_NO_THROW(recorder.close());
}

/// Rows of a subsystem with output "y": time, jump flag, value, derivative.
class Told {
 public:
  explicit Told(int derivatives)
      : info_{"told", {}, {{"y", "1", 1, derivatives}}, {}, {}}, history_("told", info_, 64) {}
  const SubsystemInfo& info() const { return info_; }
  void add(double t, double y, bool jump, double derivative = 0.0) {
    double* row = history_.room().append(t, jump);
    row[0] = y;
    if (info_.derivatives() > 0) row[1] = derivative;
    history_.commit(t, TimeTolerance());
  }
  void tell(Recorder& recorder, int who) {
    recorder.samples(who, history_, history_.oldest(), history_.newest());
  }

 private:
  SubsystemInfo info_;
  History history_;
};

/// The clock repeats t = 1; the other jumps at t = 1.5 with a repeated time and at t = 2 without.
TEST(Recorder, DoesNotInterpolateAcrossAJump) {
  const Scratch folder;
  Told clock(0), other(1);
  Topology topology;
  topology.add("clock", clock.info());
  topology.add("other", other.info());
  for (const double t : {0.0, 1.0}) clock.add(t, t, false);
  clock.add(1.0, 10.0, true);
  for (const double t : {1.5, 1.75, 2.0}) clock.add(t, t, false);
  other.add(0.0, 0.0, false, 1.0);
  other.add(1.5, 1.5, false, 1.0);
  other.add(1.5, 5.0, true, 0.0);
  other.add(2.0, 7.0, true, 0.0);
  const Coordinator run(topology, {nullptr, nullptr}, {}, {0.0, 2.0});
  Recorder recorder(run, {folder.path(), "clock", false, {}});
  clock.tell(recorder, 0);
  other.tell(recorder, 1);
  recorder.close();
  EXPECT_EQ(read_text(folder.path() / "results.csv"),
            "time,clock.y,other.y\n0,0,0\n1,1,1\n1,10,1\n1.5,1.5,1.5\n1.75,1.75,5\n2,2,7\n");
}

}  // namespace
}  // namespace tandem
