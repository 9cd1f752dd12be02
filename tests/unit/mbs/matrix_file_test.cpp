// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/mbs/sparse/matrix_file.hpp"

#include <gtest/gtest.h>

#include "tandem/charts/program.hpp"
#include "refusal.hpp"
#include "scratch.hpp"

namespace tandem::mbs {
namespace {

using test::refuses;
using test::Scratch;

/// Not square, an empty column, and numbers that need all digits.
Matrix example() {
  return {Pattern(4, 3, {{0, 0}, {2, 0}, {1, 2}, {3, 2}}), {1.0 / 3.0, -1e-300, 6.02214076e23, 0.1}};
}

TEST(MatrixFile, GivesBackTheSameBits) {
  const Scratch folder;
  const Matrix a = example();
  write_matrix_market(folder.path() / "a.mtx", a);
  write_compressed_columns(folder.path() / "a.ccs", a);
  for (const Matrix& b :
       {read_matrix_market(folder.path() / "a.mtx"), read_compressed_columns(folder.path() / "a.ccs")}) {
    EXPECT_EQ(b.pattern, a.pattern);
    EXPECT_EQ(b.values, a.values);
  }
}

TEST(MatrixFile, ReadsASymmetricMatrixAndSumsWhatIsThereTwice) {
  const Scratch folder;
  const Matrix a = read_matrix_market(folder.write("a.mtx",
                                                   "%%MatrixMarket matrix coordinate integer symmetric\n"
                                                   "% a comment\n\n2 2 3\n1 1 4\n2 1 -1\n2 1 +3\n"));
  EXPECT_EQ(a.pattern, Pattern(2, 2, {{0, 0}, {1, 0}, {0, 1}}));
  EXPECT_EQ(a.values, (std::vector<double>{4.0, 2.0, 2.0}));
}

TEST(MatrixFile, TellsFileLineAndWhatIsAllowed) {
  const Scratch folder;
  const auto market = [&](const std::string& text) {
    return [&folder, text] { read_matrix_market(folder.write("bad.mtx", text)); };
  };
  const auto columns = [&](const std::string& text) {
    return [&folder, text] { read_compressed_columns(folder.write("bad.ccs", text)); };
  };
  const std::string head = "%%MatrixMarket matrix coordinate real general\n";
  const auto code = ErrorCode::input_output;
  EXPECT_TRUE(
      refuses(code, {"none.mtx", "is not there"}, [&] { read_matrix_market(folder.path() / "none.mtx"); }));
  EXPECT_TRUE(
      refuses(code, {"bad.mtx:1", "coordinate"}, market("%%MatrixMarket matrix array real general\n")));
  EXPECT_TRUE(refuses(code, {"bad.mtx:3", "a row is 3", "1 to 2"}, market(head + "2 2 1\n3 1 1\n")));
  EXPECT_TRUE(refuses(code, {"bad.mtx:3", "a value"}, market(head + "2 2 1\n1 1 x\n")));
  EXPECT_TRUE(refuses(code, {"finite"}, market(head + "2 2 1\n1 1 nan\n")));
  EXPECT_TRUE(refuses(code, {"ends where a row"}, market(head + "2 2 2\n1 1 1\n")));
  EXPECT_TRUE(refuses(code, {"bad.mtx:4", "more"}, market(head + "2 2 1\n1 1 1\n2 2 2\n")));
  EXPECT_TRUE(refuses(code, {"bad.ccs:2", "start"}, columns("2 2 2\n0 3 2\n0 1\n1 1\n")));
  EXPECT_TRUE(refuses(code, {"bad.ccs:3", "a row is 0", "1 to 1"}, columns("2 1 2\n0 2\n0 0\n1 1\n")));
  EXPECT_TRUE(refuses(code, {"can't be written"},
                      [&] { write_matrix_market(folder.path() / "none" / "a.mtx", example()); }));
}

/// Both files of the example and a script, for a program that knows nothing of ours.
[[maybe_unused]] void read_by(const std::vector<std::string>& program, const std::string& script) {
  const Scratch folder;
  write_matrix_market(folder.path() / "a.mtx", example());
  write_compressed_columns(folder.path() / "a.ccs", example());
  auto words = program;
  words.push_back(script);
  EXPECT_NO_THROW(charts::run_program(words, folder.path(), "matrix_file_test"));
}

#ifdef TANDEM_SCIPY
TEST(MatrixFile, IsReadByScipy) {
  read_by({TANDEM_SCIPY, "-c"}, R"(
import numpy, scipy.io, scipy.sparse
a = scipy.io.mmread('a.mtx').tocsc()
lines = [line.split() for line in open('a.ccs') if not line.startswith('%')]
b = scipy.sparse.csc_matrix((numpy.array(lines[3], float), numpy.array(lines[2], int), numpy.array(lines[1], int)),
                            shape=[int(n) for n in lines[0][:2]])
assert a.shape == b.shape == (4, 3) and a.nnz == b.nnz == 4 and abs(a - b).max() == 0
assert a[0, 0] == 1 / 3 and a[2, 0] == -1e-300 and a[1, 2] == 6.02214076e23 and a[3, 2] == 0.1
)");
}
#endif

#ifdef TANDEM_OCTAVE
TEST(MatrixFile, IsReadByOctave) {
  read_by({TANDEM_OCTAVE, "--eval"}, R"(
lines = strsplit(fileread('a.mtx'), "\n");
t = sscanf(strjoin(lines(3:end), "\n"), '%f', [3 Inf])';
s = sscanf(lines{2}, '%d');
a = sparse(t(:, 1), t(:, 2), t(:, 3), s(1), s(2));
assert(full(a), [1/3 0 0; 0 0 6.02214076e23; -1e-300 0 0; 0 0 0.1]);
)");
}
#endif

}  // namespace
}  // namespace tandem::mbs
