// Copyright (c) 2026 The tandem authors. SPDX-License-Identifier: BSD-3-Clause
#include "view/drawing.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "refusal.hpp"
#include "tandem/mbs/mechanism/read.hpp"
#include "view/base64.hpp"
#include "view/place.hpp"

namespace tandem::view {
namespace {

using Json = nlohmann::ordered_json;
using test::refuses;

/// A mechanism with a bit of everything, and its table [view].
struct Example {
  text::Document document;
  mbs::Description description;
  explicit Example(const std::string& text)
      : document("m", text), description(mbs::read_mechanism("m", text)) {}
  Json drawn() const { return drawing(description, read_view(document, description)); }
};

const std::string plane = R"(dimension = 2
gravity = [0, -2]
[points]
O = { at = [0, 0], fixed = true }
A = { at = [1, 0] }
B = { at = [1, 1] }
C = { at = [2, 0] }
[vectors]
u = { at = [1, 0] }
[rods]
bar = { points = ["O", "A"], mass = 1 }
[bodies.plate]
points = ["A", "B", "C"]
mass = 1
centre = [1, 0.5]
inertia = 0.1
[bodies.disc]
points = ["C"]
vectors = ["u"]
mass = 2
centre = [2, 0]
inertia = 0.25
[distances]
link = { points = ["O", "B"] }
[lengths]
reach = { points = ["O", "C"] }
[springs]
coil = { points = ["O", "B"], stiffness = 1 }
pot = { coordinate = "reach", damping = 1 }
[outputs]
x = { position = "A.x" }
)";

TEST(Drawing, HasEachPartOfAMechanism) {
  const Json d = Example(plane).drawn();
  EXPECT_EQ(d["up"], (Json{0, 1, 0}));
  EXPECT_EQ(d["entities"].size(), 5U);
  EXPECT_EQ(d["rods"], (Json::array({{{"name", "bar"}, {"ends", {0, 1}}}})));
  EXPECT_EQ(d["plates"][0]["corners"], (Json{1, 2, 3}));
  EXPECT_EQ(d["links"][0]["ends"], (Json{0, 2}));
  EXPECT_EQ(d["springs"][0]["damper"], false);
  EXPECT_EQ(d["springs"][1]["ends"], (Json{0, 3}));
  EXPECT_EQ(d["springs"][1]["damper"], true);
  EXPECT_EQ(d["wheels"][0]["centre"], 3);
  EXPECT_EQ(d["wheels"][0]["radius"], 0.5);  // m r^2 / 2 = 0.25
}

TEST(Drawing, TakesWheelsGroundAndPathsFromTheTable) {
  const Json d = Example(plane +
                         "[view]\nwheels = [{ centre = 'C', radius = 0.3, spoke = 'u' }]\nground = -1\n"
                         "follow = 'A'\ntrace = ['B', 'C']\nplots = ['x']\n")
                     .drawn();
  ASSERT_EQ(d["wheels"].size(), 1U) << "the wheel stands for the body";
  EXPECT_EQ(d["wheels"][0], (Json{{"centre", 3}, {"radius", 0.3}, {"width", 0.15}, {"spoke", {4}}}));
  EXPECT_EQ(d["ground"], -1.0);
  EXPECT_EQ(d["follow"], 1);
  EXPECT_EQ(d["trace"], (Json{2, 3}));
}

TEST(Drawing, RefusesWhatIsWrongInTheTableWithItsLine) {
  const std::pair<std::string, std::vector<std::string>> wrong[] = {
      {"weels = []", {"view", "weels", "wheels"}},
      {"wheels = 3", {"m:33", "view.wheels is the number 3", "an array of tables"}},
      {"wheels = [{ radius = 1 }]", {"m:33", "view.wheels[0].centre is missing"}},
      {"wheels = [{ centre = 'C' }]", {"m:33", "view.wheels[0].radius is missing"}},
      {"wheels = [{ centre = 'C', radius = -1 }]", {"m:33", "radius", "above 0"}},
      {"wheels = [{ centre = 'D', radius = 1 }]", {"m:33", "point 'D' is not there", "There are"}},
      {"wheels = [{ centre = 'C', radius = 1, axis = 'u' }]", {"m:33", "axis"}},
      {"wheels = [{ centre = 'C', radius = 1, spoke = 'v' }]", {"m:33", "vector 'v' is not there"}},
      {"wheels = [{ centre = 'C', radius = 1, spoke = ['A', 'A'] }]", {"m:33", "'A' twice"}},
      {"wheels = [{ centre = 'C', radius = 1, spoke = ['A'] }]", {"m:33", "1 names"}},
      {"wheels = [{ centre = 'C', radius = 1, angle = 'y' }]", {"m:33", "output 'y' is not there"}},
      {"wheels = [{ centre = 'C', radius = 1, angle = 'x', spoke = 'u' }]", {"m:33", "one of them"}},
      {"ground = 'low'", {"m:33", "view.ground"}},
      {"follow = 'u'", {"m:33", "view.follow: point 'u' is not there"}},
      {"trace = ['A', 'Z']", {"m:33", "view.trace: point 'Z' is not there"}},
      {"plots = ['pitch']", {"m:33", "view.plots: output 'pitch' is not there", "There are: x"}}};
  for (const auto& [line, words] : wrong)
    EXPECT_TRUE(refuses(ErrorCode::invalid_argument, words, [&] {
      Example(plane + "[view]\n" + line + "\n").drawn();
    })) << line;
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"view", "table"},
                      [&] { Example("view = 3\n" + plane).drawn(); }));
}

const std::string space = R"(dimension = 3
[points]
O = { at = [0.1, 0.2, 0.3], fixed = true }
[vectors]
a = { at = [1, 0, 0] }
b = { at = [0, 1, 0] }
c = { at = [0, 0, 2] }
[bodies.top]
points = ["O"]
vectors = ["a", "b", "c"]
mass = 12
centre = [0.1, 0.2, 0.8]
inertia = [[5, 0, 0], [0, 4, 0], [0, 0, 3]]
)";

TEST(Drawing, AWheelInSpaceHasAnAxis) {
  const auto wheels = [](const std::string& wheel) {
    return Example(space + "[view]\nwheels = [" + wheel + "]\n").drawn();
  };
  EXPECT_TRUE(refuses(ErrorCode::invalid_argument, {"view.wheels[0].axis is missing"},
                      [&] { wheels("{ centre = 'O', radius = 1 }"); }));
  const Json d = wheels("{ centre = 'O', radius = 1, axis = 'c', width = 0.2, spoke = 'a' }");
  EXPECT_EQ(d["wheels"][0]["axis"], Json{3});
  EXPECT_TRUE(d["plates"].empty());
}

/// The place when each point is moved to R p + t, each vector to R v.
Eigen::Vector3d moved(const mbs::Description& in, const Json& place, const Eigen::Matrix3d& turn,
                      const Eigen::Vector3d& by) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  if (place.is_number()) return turn * in.entities[place.get<std::size_t>()].at + by;
  for (const Json& term : place["terms"]) {
    const mbs::Entity& e = in.entities[term[0].get<std::size_t>()];
    const Eigen::Vector3d at = turn * e.at + (e.kind == mbs::Entity::Kind::point ? by : by * 0.0);
    sum += term[1].get<double>() * at + term[2].get<double>() * Eigen::Vector3d(-at[1], at[0], 0.0);
  }
  return sum;
}

// A block of 12 kg with second moments 1, 2, 3 kg m^2 along x, y, z has edges of 1, sqrt 2, sqrt 3 m.
TEST(Drawing, ABodyOfOnePointIsABlockThatMovesWithIt) {
  const Example example(space);
  const Json corners = example.drawn()["plates"][0]["corners"];
  ASSERT_EQ(corners.size(), 8U);
  const Eigen::Vector3d centre(0.1, 0.2, 0.8), half(0.5, std::sqrt(0.5), std::sqrt(0.75));
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
  const Eigen::Vector3d by(3, -1, 2);
  for (const Json& corner : corners) {
    const Eigen::Vector3d drawn =
        moved(example.description, corner, Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero());
    EXPECT_LT(((drawn - centre).cwiseAbs() - half).norm(), 1e-14);
    EXPECT_LT((moved(example.description, corner, turn, by) - (turn * drawn + by)).norm(), 1e-14);
  }
}

TEST(Drawing, APlaceOnTwoPointsOfThePlaneTurnsWithThem) {
  const Example example(plane);
  const Eigen::Vector3d at(0.3, 0.8, 0), by(1, 2, 0);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d::UnitZ()).matrix();
  for (const std::vector<int>& entities : {std::vector<int>{1, 2}, std::vector<int>{3, 4}}) {
    const Json place = place_on(example.description, entities, at);
    EXPECT_LT((moved(example.description, place, turn, by) - (turn * at + by)).norm(), 1e-14);
  }
}

// RFC 4648, section 10.
TEST(Base64, HasTheVectorsOfItsStandard) {
  const std::pair<const char*, const char*> known[] = {
      {"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : known) EXPECT_EQ(base64(std::string_view(bytes)), text);
  EXPECT_EQ(base64(std::vector<double>{1.0}), "AAAAAAAA8D8=");
}

}  // namespace
}  // namespace tandem::view
