// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
// Small dense matrices by each BLAS of the distribution, in one process.
#define BOOST_DLL_USE_STD_FS
#include <fmt/format.h>

#include <Eigen/Dense>
#include <boost/dll/shared_library.hpp>
#include <cmath>
#include <filesystem>

#include "bench/bench.hpp"

namespace tandem::bench {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// By its Fortran names, without the hidden lengths of texts of one character.
extern "C" {
using Dgemm = void(const char*, const char*, const int*, const int*, const int*, const double*, const double*,
                   const int*, const double*, const int*, const double*, double*, const int*);
using Dtrsm = void(const char*, const char*, const char*, const char*, const int*, const int*, const double*,
                   const double*, const int*, double*, const int*);
using Dsyrk = void(const char*, const char*, const int*, const int*, const double*, const double*, const int*,
                   const double*, double*, const int*);
using Dpotrf = void(const char*, const int*, double*, const int*, int*);
}

struct Candidate {
  const char *name, *file, *package;
};
constexpr Candidate candidates[] = {{"reference BLAS", "blas/libblas.so.3", "libblas3"},
                                    {"OpenBLAS", "openblas-pthread/libopenblas.so.0", "libopenblas0-pthread"},
                                    {"BLIS", "blis-openmp/libblas.so.3", "libblis4-openmp"},
                                    {"ATLAS", "atlas/libblas.so.3", "libatlas3-base"}};

/// A BLAS loaded beside the one that the program is linked with; names are looked up within it first.
class Blas {
 public:
  explicit Blas(const std::filesystem::path& file)
      : library_(file, boost::dll::load_mode::rtld_deepbind | boost::dll::load_mode::rtld_now),
        dgemm_(library_.get<Dgemm>("dgemm_")),
        dtrsm_(library_.get<Dtrsm>("dtrsm_")),
        dsyrk_(library_.get<Dsyrk>("dsyrk_")) {
    for (const char* name : {"openblas_set_num_threads", "bli_thread_set_num_threads"})
      if (library_.has(name)) library_.get<void(std::int64_t)>(name)(1);
    if (library_.has("dpotrf_")) dpotrf_ = &library_.get<Dpotrf>("dpotrf_");
  }

  bool has_cholesky() const { return dpotrf_ != nullptr; }

  /// c = a b.
  void multiply(const MatrixXd& a, const MatrixXd& b, MatrixXd& c) const {
    const int n = static_cast<int>(a.rows());
    const double one = 1.0, zero = 0.0;
    dgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, b.data(), &n, &zero, c.data(), &n);
  }
  /// The lower triangle becomes L: by halves, as LAPACK's dpotrf2 does it (F. G. Gustavson, IBM J. Res. Dev.
  /// 41 (1997) 737).
  void cholesky(double* a, int n, int stride) const {
    if (n == 1) {
      *a = std::sqrt(*a);
      return;
    }
    const int first = n / 2, second = n - first;
    const double one = 1.0, minus_one = -1.0;
    double* const below = a + first;
    double* const corner = below + static_cast<std::ptrdiff_t>(first) * stride;
    cholesky(a, first, stride);
    dtrsm_("R", "L", "T", "N", &second, &first, &one, a, &stride, below, &stride);
    dsyrk_("L", "N", &second, &first, &minus_one, below, &stride, &one, corner, &stride);
    cholesky(corner, second, stride);
  }
  void own_cholesky(double* a, int n) const {
    int info = 0;
    dpotrf_("L", &n, a, &n, &info);
  }
  /// x becomes (L L^T)^-1 x.
  void solve(const double* l, int n, double* x) const {
    const double one = 1.0;
    const int columns = 1;
    dtrsm_("L", "L", "N", "N", &n, &columns, &one, l, &n, x, &n);
    dtrsm_("L", "L", "T", "N", &n, &columns, &one, l, &n, x, &n);
  }

 private:
  boost::dll::shared_library library_;
  Dgemm& dgemm_;
  Dtrsm& dtrsm_;
  Dsyrk& dsyrk_;
  Dpotrf* dpotrf_ = nullptr;
};

/// What is timed at one size.
struct DenseCase {
  explicit DenseCase(int size)
      : n(size), a(MatrixXd::Random(n, n)), spd(a * a.transpose()), c(n, n), x(VectorXd::Ones(n)) {
    spd.diagonal().array() += n;
  }
  int n;
  MatrixXd a, spd, c;
  VectorXd x;
};

using Work = std::function<void(DenseCase&)>;

struct Entry {
  std::string blas, operation;
  Work work;
};

std::vector<Entry> entries_of(const std::string& name, const std::shared_ptr<Blas>& blas) {
  std::vector<Entry> list = {{name, "product", [blas](DenseCase& k) { blas->multiply(k.a, k.spd, k.c); }},
                             {name, "cholesky", [blas](DenseCase& k) {
                                k.c = k.spd;
                                k.x.setOnes();
                                blas->cholesky(k.c.data(), k.n, k.n);
                                blas->solve(k.c.data(), k.n, k.x.data());
                              }}};
  if (blas->has_cholesky())
    list.push_back({name + " (its own dpotrf)", "cholesky", [blas](DenseCase& k) {
                      k.c = k.spd;
                      k.x.setOnes();
                      blas->own_cholesky(k.c.data(), k.n);
                      blas->solve(k.c.data(), k.n, k.x.data());
                    }});
  return list;
}

std::vector<Entry> eigen_entries() {
  const auto llt = std::make_shared<Eigen::LLT<MatrixXd>>();
  return {{"Eigen", "product", [](DenseCase& k) { k.c.noalias() = k.a * k.spd; }},
          {"Eigen", "cholesky", [llt](DenseCase& k) {
             k.x.setOnes();
             llt->compute(k.spd);
             llt->solveInPlace(k.x);
           }}};
}

std::vector<Entry> all_entries() {
  std::vector<Entry> all = eigen_entries();
  const std::filesystem::path folder = std::filesystem::path("/usr/lib") / TANDEM_LIBRARY_ARCHITECTURE;
  for (const Candidate& c : candidates) try {
      for (Entry& entry : entries_of(c.name, std::make_shared<Blas>(folder / c.file)))
        all.push_back(std::move(entry));
    } catch (const std::exception&) {
      fmt::print("{} is missing: no {} (package {})\n", c.name, (folder / c.file).string(), c.package);
    }
  return all;
}

}  // namespace

Table dense_algebra() {
  Table table({"library", "operation", "N", "ns", "mflops"});
  const auto entries = all_entries();
  std::vector<Timing> timings;
  for (int n = 4; n <= 42; n += 2)
    for (const Entry& e : entries) {
      const auto input = std::make_shared<DenseCase>(n);
      timings.push_back(
          {fmt::format("{}/{}/{}", e.blas, e.operation, n), [input, work = e.work](auto& state) {
             for ([[maybe_unused]] auto _ : state) work(*input);
           }});
    }
  auto seconds = measure(timings, 10, 0.001);
  for (const Entry& e : entries)
    for (int n = 4; n <= 42; n += 2) {
      const double s = seconds[fmt::format("{}/{}/{}", e.blas, e.operation, n)];
      const double operations = e.operation == "product" ? 2.0 * n * n * n : n * n * n / 3.0 + 2.0 * n * n;
      table.add({e.blas, e.operation, std::to_string(n), fmt::format("{:.1f}", 1e9 * s),
                 fmt::format("{:.0f}", 1e-6 * operations / s)});
    }
  return table;
}

}  // namespace tandem::bench
