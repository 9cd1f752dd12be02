// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "mechanism/elements/own_elements.hpp"
#include "reader.hpp"
#include "tandem/nearest.hpp"

namespace tandem::mbs {

/// What an element reads its table by.
class Reader::Keys final : public ElementKeys {
 public:
  Keys(Reader& reader, Section& section, std::string name)
      : reader_(reader), section_(section), name_(std::move(name)) {}

  int dimension() const override { return reader_.to_.dimension; }
  bool has(const std::string& key) override { return section_.node(key) != nullptr; }
  double number(const std::string& key) override {
    const auto value = section_.number(key);
    if (!value) section_.missing(key);
    return *value;
  }
  double positive(const std::string& key) override {
    const auto value = section_.positive(key);
    if (!value) section_.missing(key);
    return *value;
  }
  bool flag(const std::string& key) override { return *section_.flag(key); }
  std::string text(const std::string& key) override {
    const auto value = section_.text(key);
    if (!value) section_.missing(key);
    return *value;
  }
  void leave_out(const std::string& key, const std::string& why) override { section_.leave_out(key, why); }
  void at(const std::string& key, const std::function<void()>& use) override {
    text::located(section_.place(key), use);
  }
  int point(const std::string& key) override {
    return reader_.point(section_, key, section_.required_text(key));
  }
  int vector(const std::string& key) override { return vector_of(key, section_.required_text(key)); }
  std::vector<int> vectors(const std::string& key) override {
    std::vector<int> all;
    for (const std::string& name : names(key)) all.push_back(vector_of(key, name));
    return all;
  }
  Coordinate coordinate(const std::string& key) override {
    return reader_.required_coordinate(section_, key);
  }
  std::vector<Coordinate> coordinates(const std::string& key) override {
    std::vector<Coordinate> all;
    for (const std::string& name : names(key)) all.push_back(reader_.coordinate(section_, key, name));
    return all;
  }
  int input(const std::string& key, const std::string& unit) override {
    const auto name = section_.text(key);
    if (!name) return -1;
    const int input = reader_.find(reader_.inputs_, section_, key, "input", *name);
    reader_.unit(section_, key, input, {unit});
    return input;
  }
  Eigen::Vector3d drawn(int entity) const override {
    return reader_.to_.entities[static_cast<std::size_t>(entity)].at;
  }
  Coordinate state(const std::string& name) override {
    Relative state{name_ + " " + name, Relative::Kind::state};
    state.where = section_.place().text();
    const Coordinate c{-1, 0, static_cast<int>(reader_.to_.relatives.size())};
    reader_.to_.relatives.push_back(std::move(state));
    add_inertia(c, 1.0);
    return c;
  }
  void add_inertia(const Coordinate& c, double value) override { reader_.to_.inertias.push_back({c, value}); }
  void add_mass(int point, double mass) override {
    reader_.to_.masses.push_back({name_, point, mass, section_.place().text()});
  }

 private:
  std::vector<std::string> names(const std::string& key) {
    auto all = section_.texts(key);
    if (all.empty()) section_.missing(key);
    return all;
  }
  int vector_of(const std::string& key, const std::string& name) {
    const int e = reader_.find(reader_.entities_, section_, key, "vector", name);
    if (reader_.to_.entities[static_cast<std::size_t>(e)].kind != Entity::Kind::vector)
      section_.wrong(key, "the point '" + name + "'", "the name of a vector");
    return e;
  }

  Reader& reader_;
  Section& section_;
  std::string name_;
};

void Reader::read_element(const std::string& name, Section& section) {
  const ElementKind& kind = kinds_.at(section.kind());
  Keys keys(*this, section, name);
  this->name(elements_, section, name, to_.elements.size());
  to_.elements.push_back({name, kind.make(keys), section.place().text()});
}

}  // namespace tandem::mbs
