#include "openr/render/robot_scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "cli/install_paths.h"
#include "openr/render/mesh.h"
#include "openr/render/robot_shapes.h"
#include "virtualrobot/body/kinematics.h"

namespace openr_host {
namespace {

class RobotSceneTest : public testing::Test {
 protected:
  explicit RobotSceneTest(const std::string& model = "ers210")
      : model_(LoadRobotModel(ModelFile(model))) {
    const std::vector<double>& angles = model_.PostureAngles("stand");
    look_.X_WB = PlaceOnFloor(model_, angles).X_WB;
    for (const Eigen::Isometry3d& X_BL : LinkPoses(model_, angles)) {
      look_.X_WL.push_back(look_.X_WB * X_BL);
    }
  }

  int Glowing() const {
    const render::Scene scene = MakeRobotScene(model_, {look_}, World(), View::kIso);
    return static_cast<int>(std::count_if(scene.shapes.begin(), scene.shapes.end(),
                                          [](const render::Shape& s) { return s.glows; }));
  }

  const RobotModel model_;
  RobotLook look_;
};

TEST_F(RobotSceneTest, ALightThatIsOnGlows) {
  EXPECT_EQ(Glowing(), 0);
  look_.leds.assign(model_.leds.size(), 1);
  EXPECT_EQ(Glowing(), static_cast<int>(model_.leds.size()));
}

class SceneOfModelTest : public RobotSceneTest, public testing::WithParamInterface<const char*> {
 protected:
  SceneOfModelTest() : RobotSceneTest(GetParam()) {}
};

TEST_P(SceneOfModelTest, EveryLightIsShown) {
  look_.leds.assign(model_.leds.size(), 1);
  EXPECT_EQ(Glowing(), static_cast<int>(model_.leds.size()));
}

TEST_P(SceneOfModelTest, EarsAreAtTheHead) {
  const BodyPart& head = model_.bodies[static_cast<size_t>(model_.FindBody("head"))];
  for (const RobotShape& shape : ShapesOfRobot(model_)) {
    if (shape.ear < 0) continue;
    EXPECT_LT((shape.pivot - head.centre_m).norm(), 0.08);
  }
}

INSTANTIATE_TEST_SUITE_P(Models, SceneOfModelTest, testing::Values("ers210", "ers220", "ers7"));

class Ers7SceneTest : public RobotSceneTest {
 protected:
  Ers7SceneTest() : RobotSceneTest("ers7") {}

  // Returns the colour of the light with this name.
  render::Colour ColourOf(const std::string& name) const {
    const auto named = [&](const RobotShape& shape) {
      return shape.led >= 0 && model_.leds[static_cast<size_t>(shape.led)].name == name;
    };
    const std::vector<RobotShape> shapes = ShapesOfRobot(model_);
    const auto light = std::find_if(shapes.begin(), shapes.end(), named);
    const render::Scene scene = MakeRobotScene(model_, {look_}, World(), View::kIso);
    return scene.shapes[static_cast<size_t>(light - shapes.begin())].colour;
  }
};

TEST_F(Ers7SceneTest, FaceLightsHaveTheColourOfTheirMode) {
  look_.leds.assign(model_.leds.size(), 1);
  EXPECT_GT(ColourOf("Face light 13").r, ColourOf("Face light 13").b);
  look_.is_face_in_mode_b = true;
  EXPECT_LT(ColourOf("Face light 13").r, ColourOf("Face light 13").b);
}

TEST_F(Ers7SceneTest, ALightShinesAsBrightAsItIsTold) {
  look_.leds.assign(model_.leds.size(), 0.25);
  const float dim = ColourOf("Face light 6").r;
  look_.leds.assign(model_.leds.size(), 1);
  EXPECT_GT(ColourOf("Face light 6").r, dim + 0.3f);
}

TEST_F(RobotSceneTest, NothingReachesBelowTheFloor) {
  for (const render::Shape& shape : MakeRobotScene(model_, {look_}, World(), View::kSide).shapes) {
    EXPECT_GT(shape.X_WS.translation().z(), 0);
  }
}

TEST_F(RobotSceneTest, BoxesOfTheWorldAreShown) {
  World world;
  world.things.push_back({.name = "box", .size_m = {0.1, 0.2, 0.3}, .centre_m = {1, 0, 0.15}});
  EXPECT_EQ(MakeRobotScene(model_, {look_}, world, View::kTop).shapes.size(),
            MakeRobotScene(model_, {look_}, World(), View::kTop).shapes.size() + 1);
}

// Returns the height over the floor that a shape reaches.
double TopOf(const render::Shape& shape) {
  return shape.X_WS.translation().z() + shape.size_m.z() / 2;
}

TEST(WorldShapesTest, LaterPaintLiesOnEarlierPaint) {
  World world;
  world.things.push_back({.name = "a", .size_m = {1, 1, 0.001}, .is_solid = false});
  world.things.push_back({.name = "b", .size_m = {1, 1, 0.001}, .is_solid = false});
  const std::vector<render::Shape> shapes = ShapesOfWorld(world);
  ASSERT_EQ(shapes.size(), 2u);
  EXPECT_GT(TopOf(shapes[0]), 0);
  EXPECT_GT(TopOf(shapes[1]), TopOf(shapes[0]));
  world.things.resize(500, world.things[0]);
  EXPECT_LT(TopOf(ShapesOfWorld(world).back()), 0.005);
}

TEST(WorldShapesTest, AHeightfieldIsItsTriangles) {
  const World world = ParseWorld(R"({"schema":"openr-host world 2","name":"w","things":[
      {"shape":"heightfield","name":"h","size_m":[1,1],"centre_m":[0,0,0],
       "heights_m":[[0.1,0.2],[0.1,0.1]]}]})",
                                 "w.json");
  // Two above, and two below each of four edges.
  EXPECT_EQ(ShapesOfWorld(world).at(0).triangles.size(), 3u * (2 + 4 * 2));
}

TEST_F(RobotSceneTest, TheFloorHasTheColourOfTheWorldFile) {
  World world;
  EXPECT_GT(MakeRobotScene(model_, {look_}, world, View::kTop).floor.r, 0.8f);
  world.floor_colour = Eigen::Vector3d(0.25, 0.5, 0);
  const render::Colour floor = MakeRobotScene(model_, {look_}, world, View::kTop).floor;
  EXPECT_EQ(floor.r, 0.25f);
  EXPECT_EQ(floor.g, 0.5f);
}

TEST_F(RobotSceneTest, TheCameraLooksAtTheRobotWhereverItIs) {
  for (const View view : {View::kSide, View::kFront, View::kTop, View::kIso, View::kFollow}) {
    RobotLook moved = look_;
    const Eigen::Isometry3d shift(Eigen::Translation3d(3, -2, 0));
    moved.X_WB = shift * moved.X_WB;
    for (Eigen::Isometry3d& X_WL : moved.X_WL) X_WL = shift * X_WL;
    const render::Camera here = MakeRobotScene(model_, {look_}, World(), view).camera;
    const render::Camera there = MakeRobotScene(model_, {moved}, World(), view).camera;
    EXPECT_LT((there.p_W - here.p_W - shift.translation()).norm(), 1e-9);
    EXPECT_LT((there.target_W - here.target_W - shift.translation()).norm(), 1e-9);
  }
}

TEST(ViewTest, NamesAreExact) {
  View view = View::kTop;
  EXPECT_TRUE(ParseView("side", &view));
  EXPECT_EQ(view, View::kSide);
  EXPECT_FALSE(ParseView("Side", &view));
  EXPECT_FALSE(ParseView("", &view));
}

TEST(MeshTest, ARoundedBoxFillsItsSizeAndHasUnitNormals) {
  const Eigen::Vector3f size(0.1f, 0.2f, 0.04f);
  const render::Mesh mesh = render::RoundedBox(size, 0.01f, 4);
  Eigen::Vector3f high = Eigen::Vector3f::Zero();
  for (const render::Vertex& vertex : mesh.vertices) {
    EXPECT_NEAR(vertex.normal.norm(), 1, 1e-5);
    high = high.cwiseMax(vertex.position.cwiseAbs());
  }
  EXPECT_LT((high - size / 2).norm(), 1e-6);
}

TEST(MeshTest, TrianglesFaceOutwards) {
  const render::Mesh mesh = render::RoundedBox({0.1f, 0.1f, 0.1f}, 0.05f, 3);
  for (size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const Eigen::Vector3f a = mesh.vertices[mesh.triangles[i]].position;
    const Eigen::Vector3f b = mesh.vertices[mesh.triangles[i + 1]].position;
    const Eigen::Vector3f c = mesh.vertices[mesh.triangles[i + 2]].position;
    EXPECT_GE((b - a).cross(c - a).dot(a + b + c), -1e-9);
  }
}

TEST(MeshTest, ARadiusThatDoesNotFitIsCut) {
  const render::Mesh mesh = render::RoundedBox({0.1f, 0.1f, 0.02f}, 1.0f, 2);
  for (const render::Vertex& vertex : mesh.vertices) {
    EXPECT_LE(std::abs(vertex.position.z()), 0.0101f);
  }
}

}  // namespace
}  // namespace openr_host
