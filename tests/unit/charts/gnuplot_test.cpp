// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/charts/gnuplot.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>

#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::charts {
namespace {

using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

AssertionResult holds(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return AssertionSuccess();
  return AssertionFailure() << "no '" << part << "' in:\n" << text;
}

/// A program `gnuplot` that writes down its arguments, first in PATH as long as this lives.
class StandIn {
 public:
  explicit StandIn(const std::string& commands) : path_(std::getenv("PATH")) {
    const auto program = folder_.write("gnuplot", "#!/bin/sh\n" + commands + "\n");
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    setenv("PATH", (folder_.path().string() + ":" + path_).c_str(), 1);
  }
  ~StandIn() { setenv("PATH", path_.c_str(), 1); }
  StandIn(const StandIn&) = delete;
  StandIn& operator=(const StandIn&) = delete;

 private:
  test::Scratch folder_;
  std::string path_;
};

TEST(Gnuplot, TextsAreQuotedSoThatNothingInThemIsACommand) {
  EXPECT_EQ(quote("it's"), "'it’s'");
  EXPECT_EQ(quote("'a"), "'’a'");
  EXPECT_EQ(quote("a\n`system`\t\"b\""), "'a `system` \"b\"'");
}

TEST(Gnuplot, TheScriptHoldsItsData) {
  Picture picture("p", 300, 200);
  const std::string block = picture.data({{1.0, 0.1}, {2.0, std::numeric_limits<double>::quiet_NaN()}});
  picture.plot({{block, "with lines", "it's"}, {"0", "with lines"}});
  const std::string script = picture.script();
  EXPECT_TRUE(holds(script, "$d1 << END\n1 0.1\n2 nan\nEND\n"));
  EXPECT_TRUE(holds(script, "plot $d1 with lines title 'it’s' noenhanced, \\\n     0 with lines notitle\n"));
  EXPECT_LT(script.find("$d1 <<"), script.find("\nplot "));
}

TEST(Gnuplot, CaptionsAreDrawnOnce) {
  Picture picture("p", 300, 200);
  picture.caption({"one", "two"});
  picture.plot({{"0", ""}});
  EXPECT_TRUE(holds(picture.script(), "plot 0  notitle\nunset label 2\nunset label 1\n"));
}

TEST(Gnuplot, DrawsTheFormatThatIsAskedForInTheFolder) {
  const test::Scratch scratch;
  const auto folder = scratch.path() / "it's here";
  std::filesystem::create_directory(folder);
  Picture picture("p", 300, 200);
  picture.plot({{"sin(x)", "with lines"}});
  EXPECT_EQ(picture.draw(folder, Format::svg), folder / "p.svg");
  EXPECT_EQ(picture.draw(folder, Format::png), folder / "p.png");
  EXPECT_TRUE(holds(test::read_text(folder / "p.svg"), "<svg"));
  EXPECT_EQ(test::read_text(folder / "p.png").substr(1, 3), "PNG");
  EXPECT_EQ(test::read_text(folder / "p.gp"), picture.script());
}

TEST(Gnuplot, APictureThatIsNotWrittenToItsEndIsAnError) {  // gnuplot itself does not tell a full disk
  const test::Scratch scratch;
  Picture picture("p", 300, 200);
  picture.plot({{"sin(x)", "with lines"}});
  std::filesystem::create_symlink("/dev/full", scratch.path() / "p.svg");
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"p.svg' was not written to its end"},
                            [&] { picture.draw(scratch.path(), Format::svg); }));
}

TEST(Gnuplot, ItsComplaintIsPassedOn) {
  const StandIn stand_in("echo 'unknown terminal' >&2; exit 1");
  const test::Scratch scratch;
  EXPECT_TRUE(test::refuses(ErrorCode::internal, {"program 'gnuplot' failed: unknown terminal"},
                            [&] { Picture("p", 300, 200).draw(scratch.path(), Format::png); }));
}

TEST(Gnuplot, AFolderThatIsNotThereIsNamed) {
  EXPECT_TRUE(test::refuses(ErrorCode::input_output, {"/no/such/folder/p.gp"},
                            [&] { Picture("p", 300, 200).draw("/no/such/folder", Format::svg); }));
}

}  // namespace
}  // namespace tandem::charts
