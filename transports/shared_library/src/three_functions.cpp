// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "tandem/shared_library/three_functions.hpp"

#include <stdlib.h>  // mkstemp
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <sstream>
#include <system_error>
#include <utility>

#include "loading.hpp"
#include "tandem/error.hpp"
#include "tandem/library_file.hpp"
#include "tandem/time_grid.hpp"
#include "tandem/transports/parameters.hpp"

namespace tandem {
namespace {

namespace fs = std::filesystem;

/// A copy of a file that goes with its owner.
class Copy {
 public:
  explicit Copy(const fs::path& file) {
    std::string name = (fs::temp_directory_path() / "tandem_library_XXXXXX").string();
    const int descriptor = ::mkstemp(name.data());
    if (descriptor < 0) fail(file, std::generic_category().message(errno));
    ::close(descriptor);
    path_ = name;
    std::error_code failed;
    fs::copy_file(file, path_, fs::copy_options::overwrite_existing, failed);
    if (!failed) return;
    fs::remove(path_);
    fail(file, failed.message());
  }
  ~Copy() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  Copy(const Copy&) = delete;
  Copy& operator=(const Copy&) = delete;
  const fs::path& path() const { return path_; }

 private:
  [[noreturn]] static void fail(const fs::path& file, const std::string& why) {
    throw Error(ErrorCode::input_output, library_named(file) + " can't be copied: " + why);
  }
  fs::path path_;
};

boost::dll::shared_library load_copy(const fs::path& file) {
  check_library_file(file, library_named(file));
  const Copy copy(file);
  return load_library(file, copy.path());
}

template <class Function>
Function* function(const boost::dll::shared_library& library, const fs::path& file, const std::string& name) {
  if (!library.has(name))
    throw Error(ErrorCode::invalid_argument,
                library_named(file) + " has no symbol '" + name +
                    "'; name its three functions by initiate, advance, clean_up");
  Function* const found = &library.get<Function>(name);
  check_function(reinterpret_cast<const void*>(found), library_named(file), name);
  return found;
}

class ThreeFunctionLibrary final : public Subsystem {
 public:
  ThreeFunctionLibrary(const fs::path& file, ThreeFunctions what)
      : name_(library_named(file)),
        what_(std::move(what)),
        library_(load_copy(file)),
        initiate_(function<void()>(library_.get(), file, what_.initiate)),
        step_(function<void(const double*, double*)>(library_.get(), file, what_.step)),
        clean_up_(function<void()>(library_.get(), file, what_.clean_up)) {
    info_.name = file.stem().string();
    info_.inputs = what_.inputs;
    info_.outputs = what_.outputs;
    info_.abilities.restarts = true;
    TimeGrid(0.0, what_.own_step);  // refuses a step that is none
  }
  ~ThreeFunctionLibrary() override {
    const LibraryCall in_library(name_.c_str());
    if (initiated_ && !LibraryCall::has_faulted()) clean_up_();
  }

  const SubsystemInfo& info() const override { return info_; }
  bool one_thread() const override { return true; }  // their state is anybody's guess

  Clock initialize(double t_start, double, std::span<const double>, Samples& y) override {
    LibraryCall(name_.c_str()).make([this] {
      if (std::exchange(initiated_, true)) clean_up_();
      initiate_();
    });
    grid_ = TimeGrid(t_start, what_.own_step);
    std::copy(what_.start.begin(), what_.start.end(), y.append(t_start));
    return clock(Stop::limit);
  }

  Clock advance(double t_limit, bool, std::span<const Signal> u, Samples& y) override {
    values_.resize(u.size());
    LibraryCall(name_.c_str()).make([&] {
      while (grid_.fits(t_limit) && !y.full()) {
        for (std::size_t k = 0; k < u.size(); ++k) values_[k] = u[k].value(grid_.time());
        grid_.step();
        step_(values_.data(), y.append(grid_.time()));
      }
    });
    return clock(y.full() ? Stop::samples_full : Stop::limit);
  }

 private:
  Clock clock(Stop stop) const { return {grid_.time(), grid_.next(), stop}; }

  std::string name_;
  ThreeFunctions what_;
  LoadedLibrary library_;
  void (*initiate_)();
  void (*step_)(const double*, double*);
  void (*clean_up_)();
  SubsystemInfo info_;
  TimeGrid grid_;
  std::vector<double> values_;
  bool initiated_ = false;
};

}  // namespace

std::vector<Port> ports_of_text(const std::string& what, const std::string& text,
                                std::vector<double>* values) {
  std::vector<Port> ports;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, ',');) {
    const auto colon = word.find(':'), equals = values ? word.find('=') : word.size();
    if (colon == 0 || colon == std::string::npos || equals == std::string::npos || equals < colon + 2)
      throw Error(ErrorCode::invalid_argument, what + " holds '" + word + "'; allowed is name:unit" +
                                                   (values ? "=value" : "") + ", several with commas");
    ports.push_back({word.substr(0, colon), word.substr(colon + 1, equals - colon - 1)});
    if (!values) continue;
    Parameters one;
    one.set(what, word.substr(equals + 1));
    values->push_back(one.number(what, 0.0));
  }
  return ports;
}

std::unique_ptr<Subsystem> load_three_functions(const fs::path& file, ThreeFunctions functions) {
  return std::make_unique<ThreeFunctionLibrary>(file, std::move(functions));
}

}  // namespace tandem
