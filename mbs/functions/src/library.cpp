// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#define BOOST_DLL_USE_STD_FS
#include "tandem/mbs/functions/library.hpp"

#include <fmt/format.h>

#include <boost/dll/shared_library.hpp>

#include "tandem/error.hpp"
#include "tandem/library_file.hpp"
#include "tandem/mbs/functions/model_functions.h"

namespace tandem::mbs {
namespace {

constexpr tandem_model_term tandem_model_api::*members[] = {
    &tandem_model_api::mass,      &tandem_model_api::constraints,
    &tandem_model_api::jacobian,  &tandem_model_api::constraint_accelerations,
    &tandem_model_api::forces,    &tandem_model_api::constraint_rates,
    &tandem_model_api::stiffness, &tandem_model_api::damping,
    &tandem_model_api::energy};
static_assert(std::size(members) == terms.size(), "in the order of Term");

tandem_model_term function(const tandem_model_api& api, Term term) {
  return api.*members[static_cast<std::size_t>(term)];
}

class Library final : public Functions {
 public:
  explicit Library(const std::filesystem::path& file)
      : file_(file.string()), name_("model library '" + file_ + "'") {
    LibraryCall::guard_exit();
    const LibraryCall in_library(name_.c_str());
    load(file);
    check_table();
    try {
      check(api_->create(&self_), "create");
      if (!self_) refuse(ErrorCode::invalid_argument, "create gave no instance and no error");
      take_info();
    } catch (...) {
      if (self_) api_->destroy(self_);
      throw;
    }
  }
  ~Library() override {
    const LibraryCall in_library(name_.c_str());
    api_->destroy(self_);
  }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;

  const FunctionsInfo& info() const override { return info_; }
  void evaluate(Term term, double t, const double* q, const double* v, std::span<double> values) override {
    const LibraryCall in_library(name_.c_str());
    if (function(*api_, term)(self_, t, q, v, values.data()) != 0)
      refuse(ErrorCode::numerical, fmt::format("{} at t = {} s: {}", name(term), t, last_error()));
  }

 private:
  [[noreturn]] void refuse(ErrorCode code, const std::string& what) const {
    throw Error(code, "model library " + file_ + ": " + what);
  }

  void load(const std::filesystem::path& file) {
    check_library_file(file, "model library");
    try {
      library_.load(file, boost::dll::load_mode::rtld_now);
      auto& give = library_.get<const tandem_model_api*()>("tandem_model");
      check_function(reinterpret_cast<const void*>(&give), name_, "tandem_model");
      api_ = give();
    } catch (const Error&) {
      throw;
    } catch (const std::exception& error) {
      refuse(ErrorCode::invalid_argument, error.what());
    }
  }

  void check_table() const {
    if (!api_) refuse(ErrorCode::invalid_argument, "tandem_model gave no table of functions");
    if (api_->abi_version != TANDEM_MODEL_ABI_VERSION)
      refuse(ErrorCode::not_supported, fmt::format("its version of the interface is {}; allowed is {}",
                                                   api_->abi_version, TANDEM_MODEL_ABI_VERSION));
    if (api_->table_size < sizeof(tandem_model_api))
      refuse(ErrorCode::not_supported,
             fmt::format("its table of functions has {} bytes; allowed is {} or more", api_->table_size,
                         sizeof(tandem_model_api)));
    if (!api_->create || !api_->destroy || !api_->info || !api_->last_error)
      refuse(ErrorCode::invalid_argument, "its table lacks create, destroy, info or last_error");
    for (const Term term : terms)
      if (!may_be_absent(term) && !function(*api_, term))
        refuse(ErrorCode::invalid_argument, fmt::format("its table lacks {}", name(term)));
  }

  void take_info() {
    const tandem_model_info* c = api_->info(self_);
    if (!c || !c->name || !c->variable_names || !c->q || !c->v || c->variables < 1 || c->constraints < 0)
      refuse(ErrorCode::invalid_argument,
             "its info lacks the name, names of variables, q or v, has no variable or a negative count");
    info_.name = c->name;
    info_.constraints = c->constraints;
    for (int i = 0; i < c->variables; ++i) {
      const char* unit = c->variable_units ? c->variable_units[i] : "m";
      if (!c->variable_names[i] || !unit)
        refuse(ErrorCode::invalid_argument, fmt::format("its variable {} has no name or no unit", i + 1));
      info_.variables.emplace_back(c->variable_names[i]);
      info_.units.emplace_back(unit);
    }
    info_.q = Eigen::Map<const Eigen::VectorXd>(c->q, c->variables);
    info_.v = Eigen::Map<const Eigen::VectorXd>(c->v, c->variables);
    for (const Term term : terms)
      info_.present[static_cast<std::size_t>(term)] = function(*api_, term) != nullptr;
  }

  std::string last_error() const {
    const char* sentence = self_ ? api_->last_error(self_) : nullptr;
    return sentence && *sentence ? sentence : "it failed without a sentence";
  }
  void check(int32_t status, const char* call) const {
    if (status != 0) refuse(ErrorCode::invalid_argument, fmt::format("{}: {}", call, last_error()));
  }

  std::string file_, name_;
  boost::dll::shared_library library_;
  const tandem_model_api* api_ = nullptr;
  void* self_ = nullptr;
  FunctionsInfo info_;
};

}  // namespace

std::unique_ptr<Functions> open_library(const std::filesystem::path& file) {
  return std::make_unique<Library>(file);
}

}  // namespace tandem::mbs
