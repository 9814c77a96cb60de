// Things that move, and several robots in one world.
#include "virtualrobot/ode/physics_world.h"

#include <gtest/gtest.h>

#include "tests/virtualrobot/body_harness.h"
#include "virtualrobot/ode/ode_body.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

WorldThing Ball(const Vector3d& centre_m) {
  WorldThing ball;
  ball.name = "ball";
  ball.shape = ThingShape::kSphere;
  ball.size_m.setConstant(0.08);
  ball.centre_m = centre_m;
  ball.mass_kg = 0.07;
  return ball;
}

WorldThing Brick(const Vector3d& centre_m) {
  WorldThing brick;
  brick.name = "brick";
  brick.size_m = Vector3d(0.1, 0.06, 0.04);
  brick.centre_m = centre_m;
  brick.mass_kg = 0.2;
  return brick;
}

WorldThing Can(const Vector3d& centre_m) {
  WorldThing can;
  can.name = "can";
  can.shape = ThingShape::kCylinder;
  can.size_m = Vector3d(0.06, 0.06, 0.1);
  can.centre_m = centre_m;
  can.mass_kg = 0.1;
  return can;
}

// A world without robots.
class ThingsTest : public testing::Test {
 protected:
  PhysicsWorld& WorldOf(std::vector<WorldThing> things) {
    World world;
    world.things = std::move(things);
    return *(world_ = std::make_unique<PhysicsWorld>(world));
  }
  void Run(double seconds) {
    for (int i = 0; i < seconds / kFrame_s; ++i) {
      world_->AwaitFrame();
      world_->Advance();
    }
  }
  const Vector3d& Centre(size_t thing) const { return world_->things()[thing].centre_m; }

  std::unique_ptr<PhysicsWorld> world_;
};

TEST_F(ThingsTest, FallAndComeToRestOnTheFloor) {
  WorldOf({Ball({0, 0, 0.2}), Brick({1, 0, 0.2}), Can({2, 0, 0.2})});
  Run(2);
  EXPECT_NEAR(Centre(0).z(), 0.04, 1e-3);
  EXPECT_NEAR(Centre(1).z(), 0.02, 1e-3);
  EXPECT_NEAR(Centre(2).z(), 0.05, 1e-3);
  const Vector3d before[] = {Centre(0), Centre(1), Centre(2)};
  Run(5);
  for (size_t i = 0; i < 3; ++i) EXPECT_LT((Centre(i) - before[i]).norm(), 1e-4) << i;
}

TEST_F(ThingsTest, FixedThingsAndPaintDoNotMove) {
  WorldThing paint = Brick({0, 0, 0.3});
  paint.mass_kg = 0;
  paint.is_solid = false;
  WorldOf({paint, Ball({0, 0, 0.5})});
  Run(2);
  EXPECT_EQ(Centre(0), Vector3d(0, 0, 0.3));
  EXPECT_NEAR(Centre(1).z(), 0.04, 1e-3);  // fell through the paint
}

TEST_F(ThingsTest, StandOnOneAnother) {
  WorldOf({Brick({0, 0, 0.02}), Brick({0, 0, 0.06}), Can({0, 0, 0.13})});
  Run(3);
  EXPECT_NEAR(Centre(1).z(), 0.06, 2e-3);
  EXPECT_NEAR(Centre(2).z(), 0.13, 3e-3);
  EXPECT_NEAR(Centre(2).x(), 0, 2e-3);
}

// The wall has about 135 contacts, and only the 64 deepest of a group without robots count.  A
// contact that was left out gets deeper until it counts, so nothing sinks far.  The wall creeps
// apart, though.
TEST_F(ThingsTest, AWallOfMoreContactsThanCountDoesNotSink) {
  std::vector<WorldThing> bricks;
  for (int layer = 0; layer < 3; ++layer) {
    for (int i = 0; i < 6; ++i)
      bricks.push_back(Brick({0.101 * i + 0.05 * (layer % 2), 0, 0.02 + 0.04 * layer}));
  }
  WorldOf(bricks);
  Run(2);
  for (size_t i = 0; i < bricks.size(); ++i) {
    EXPECT_GT(Centre(i).z(), 0.015) << i;
    EXPECT_LT(Centre(i).z(), 0.12) << i;
  }
}

// A ball on a slope of 10 degrees rolls down with 5/7 g sin(10 degrees) less what the rolling
// resistance takes.
TEST_F(ThingsTest, BallRollsDownASlope) {
  WorldThing slope;
  slope.name = "slope";
  slope.size_m = Vector3d(4, 1, 0.1);
  slope.R_WT = RotationFromRpy({0, Radians(10), 0});
  slope.centre_m = slope.R_WT * Vector3d(0, 0, -0.05) + Vector3d(0, 0, 1);
  const Vector3d up = slope.R_WT.col(2);
  WorldOf({slope, Ball(Vector3d(0, 0, 1) + 0.04 * up)});
  Run(0.8);
  const double way = (Centre(1) - Vector3d(0, 0, 1) - 0.04 * up).norm();
  const double resistance = 0.05 * kGravity_m_s2 / 1.4;
  const double acceleration = 5.0 / 7 * kGravity_m_s2 * 0.17365 - resistance;
  EXPECT_NEAR(way, acceleration * 0.8 * 0.8 / 2, 0.02);
}

TEST_F(ThingsTest, BallThatHitsABallPassesItsMomentumOn) {
  WorldThing slope;
  slope.name = "slope";
  slope.size_m = Vector3d(0.6, 0.4, 0.02);
  slope.R_WT = RotationFromRpy({0, Radians(25), 0});
  slope.centre_m = Vector3d(-0.2, 0, 0.1);
  WorldOf({slope, Ball({-0.35, 0, 0.27}), Ball({0.4, 0, 0.04})});
  Run(4);
  EXPECT_GT(Centre(2).x(), 0.5);
  EXPECT_NEAR(Centre(2).y(), 0, 1e-3);
  EXPECT_LT(Centre(1).x(), Centre(2).x() - 0.079);
}

TEST_F(ThingsTest, RollingEndsByItselfAndNeverTurnsBack) {
  WorldThing slope;
  slope.name = "slope";
  slope.size_m = Vector3d(0.6, 0.4, 0.02);
  slope.R_WT = RotationFromRpy({0, Radians(20), 0});
  slope.centre_m = Vector3d(-0.3, 0, 0.1);
  WorldOf({slope, Ball({-0.45, 0, 0.25})});
  double x = -1;
  for (int i = 0; i < 100; ++i) {
    Run(0.1);
    EXPECT_GE(Centre(1).x(), x - 1e-6);
    x = Centre(1).x();
  }
  EXPECT_GT(x, 0.2);
  const double end = x;
  Run(1);
  EXPECT_NEAR(Centre(1).x(), end, 1e-4);
}

// A rod that rolls slowly must not be shaken by what brakes it.
TEST_F(ThingsTest, ARodComesToRest) {
  WorldThing rod = Can({0, 0, 0.1});
  rod.size_m = Vector3d(0.04, 0.04, 1);
  rod.R_WT = RotationFromRpy({Radians(90), 0, Radians(20)});
  WorldOf({rod});
  Run(8);
  const Vector3d before = Centre(0);
  Run(2);
  EXPECT_LT((Centre(0) - before).norm(), 1e-6);
}

// A ball that falls beside the middle of another one is turned about all axes, also the vertical.
TEST_F(ThingsTest, ABallThatWasSpunComesToRestForGood) {
  WorldOf({Ball({0, 0, 0.04}), Ball({0.02, 0.03, 0.3}), Brick({0.1, 0.06, 0.02})});
  Run(20);
  const Vector3d before[] = {Centre(0), Centre(1)};
  Run(4);
  for (size_t i = 0; i < 2; ++i) EXPECT_LT((Centre(i) - before[i]).norm(), 1e-5) << i;
}

TEST_F(ThingsTest, CylindersPushEachOther) {
  WorldOf({Can({0, 0, 0.05}), Can({0.055, 0.01, 0.05})});  // they overlap by 4 mm
  Run(1);
  EXPECT_GT((Centre(0) - Centre(1)).norm(), 0.0595);
}

// The can has a radius of 30 mm, the brick edges of 100 mm and 60 mm.
TEST_F(ThingsTest, ACanFeelsTheCornersOfABrickAndNoCircleAroundThem) {
  for (const size_t can : {0, 1}) {  // the pair is tested from the side of the first thing
    const auto run = [&](const Vector3d& centre_m) {
      std::vector<WorldThing> things = {Brick({0, 0, 0.02})};
      things.insert(things.begin() + static_cast<ptrdiff_t>(can), Can(centre_m));
      WorldOf(things);
      Run(1);
    };
    run({0, 0.065, 0.05});  // 5 mm beside the long side of the brick
    EXPECT_NEAR(Centre(can).y(), 0.065, 1e-4) << can;
    run({0.07, 0.05, 0.05});  // 2 mm too near to its corner
    const Vector3d way = Centre(can) - Centre(1 - can) - Vector3d(0.05, 0.03, 0);
    EXPECT_GT(way.head<2>().norm(), 0.0295) << can;
  }
}

TEST_F(ThingsTest, PutThingLaysAThingSomewhereElse) {
  PhysicsWorld& world = WorldOf({Ball({0, 0, 0.04})});
  world.PutThing(0, {1, 2, 0.3});
  EXPECT_EQ(Centre(0), Vector3d(1, 2, 0.3));
  Run(2);
  EXPECT_NEAR(Centre(0).x(), 1, 1e-3);
  EXPECT_NEAR(Centre(0).z(), 0.04, 1e-3);
}

// ---- Robots among things

// A world with `robots` robots in a row along y, 0.5 m apart, all standing up.
class CompanyTest : public testing::Test {
 protected:
  void Make(const std::vector<StartPlace>& places, std::vector<WorldThing> things = {}) {
    World world;
    world.things = std::move(things);
    world_ = std::make_shared<PhysicsWorld>(world);
    for (const StartPlace& place : places) {
      bodies_.push_back(std::make_unique<OdeBody>(Ers210(), world_, place));
      movers_.push_back(std::make_unique<BodyHarness>(Ers210(), bodies_.back().get()));
    }
  }
  // Lets all robots move to a posture, by at most 1 degree a frame.
  void SetPosture(const std::string& posture) {
    targets_rad_ = Ers210().PostureAngles(posture);
    for (auto& mover : movers_) mover->EnableAll();
  }
  void Run(double seconds) {
    for (int i = 0; i < seconds / kFrame_s; ++i) {
      for (size_t r = 0; r < bodies_.size(); ++r) {
        for (size_t j = 0; j < targets_rad_.size(); ++j) {
          double& target_rad = movers_[r]->commands[j].target_rad;
          target_rad += std::clamp(targets_rad_[j] - target_rad, -0.0175, 0.0175);
        }
        bodies_[r]->SetCommands(movers_[r]->commands);
      }
      for (auto& body : bodies_) body->Advance();
    }
  }
  Vector3d Place(size_t robot) const { return bodies_[robot]->state().X_WB.translation(); }

  std::shared_ptr<PhysicsWorld> world_;
  std::vector<std::unique_ptr<OdeBody>> bodies_;
  std::vector<std::unique_ptr<BodyHarness>> movers_;
  std::vector<double> targets_rad_;
};

// Robots that do not touch move as if each were alone, to the last bit.
TEST_F(CompanyTest, RobotsThatAreApartDoNotChangeEachOther) {
  Make({{}, {.x_m = 0, .y_m = 0.5, .yaw_rad = 0}});
  SetPosture("stand");
  Run(2);
  const Eigen::Isometry3d together = bodies_[0]->state().X_WB;
  bodies_.clear();
  movers_.clear();
  Make({{}});
  SetPosture("stand");
  Run(2);
  EXPECT_EQ(bodies_[0]->state().X_WB.matrix(), together.matrix());
}

TEST_F(CompanyTest, ARobotThatIsPushedIntoAnotherPushesIt) {
  Make({{}, {.x_m = 0.33, .y_m = 0, .yaw_rad = 0}});
  SetPosture("stand");
  Run(2);
  const double before_m = Place(1).x();
  for (int i = 0; i < 100; ++i) {
    bodies_[0]->Push(0, {9, 0, 0}, Place(0));
    Run(kFrame_s);
  }
  EXPECT_GT(Place(1).x(), before_m + 0.02);
  EXPECT_GT(Place(1).x() - Place(0).x(), 0.15);  // and none has gone through the other
}

TEST_F(CompanyTest, ARobotSeesThePartsOfAnother) {
  Make({{}, {.x_m = 0, .y_m = 0.5, .yaw_rad = Radians(90)}});
  EXPECT_NEAR(RpyOf(bodies_[1]->state().X_WB.linear()).z(), Radians(90), 1e-9);
  EXPECT_EQ(bodies_[0]->Surroundings().size(), Ers210().bodies.size());
  const RayHit hit = bodies_[0]->CastRay({0, 0.2, 0.06}, {0, 1, 0}, 2);
  EXPECT_GT(hit.distance_m, 0.1);
  EXPECT_LT(hit.distance_m, 0.3);
}

TEST_F(CompanyTest, ARobotThatStandsUpPushesTheBallAtItsPaw) {
  Make({{}}, {Ball({0.13, 0.07, 0.04})});
  SetPosture("stand");
  Run(3);
  EXPECT_GT((world_->things()[0].centre_m - Vector3d(0.13, 0.07, 0.04)).norm(), 0.01);
  EXPECT_NEAR(world_->things()[0].centre_m.z(), 0.04, 2e-3);
}

TEST_F(CompanyTest, ThingsAreInTheStateHash) {
  Make({{}}, {Ball({1, 0, 0.04})});
  const uint64_t before = StateHash(*bodies_[0]);
  EXPECT_TRUE(bodies_[0]->PutThing(0, {1, 0, 0.05}));
  EXPECT_NE(StateHash(*bodies_[0]), before);
  EXPECT_FALSE(bodies_[0]->PutThing(1, {1, 0, 0.05}));
}

TEST_F(CompanyTest, TwoRunsOfACrowdAreEqual) {
  uint64_t hashes[2];
  for (uint64_t& hash : hashes) {
    bodies_.clear();
    movers_.clear();
    Make({{}, {.x_m = 0.2, .y_m = 0.1, .yaw_rad = 1}, {.x_m = -0.2, .y_m = 0.1, .yaw_rad = 2}},
         {Ball({0.1, 0.3, 0.04}), Brick({0.3, 0, 0.02}), Can({-0.1, 0.3, 0.05})});
    SetPosture("stand");
    Run(3);
    Hasher hasher;
    for (const auto& body : bodies_) body->HashState(&hasher);
    hash = hasher.Digest();
  }
  EXPECT_EQ(hashes[0], hashes[1]);
}

}  // namespace
}  // namespace openr_host
