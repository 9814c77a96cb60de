// The decisions of examples/BallChaser: what it does with what it sees.
#include <gtest/gtest.h>

#include "Player.h"

namespace openr_host {
namespace {

constexpr GoalSight kNoGoal = {0, 0, 0, 0};

Sight SightOf(double x, double y, const GoalSight& sky_blue = kNoGoal) {
  Sight sight{};
  sight.ball = {1, 0, x, y};
  sight.goal[SKY_BLUE_GOAL] = sky_blue;
  return sight;
}

class BallChaserPlayerTest : public testing::Test {
 protected:
  void See(const Sight& sight, int pictures = 1) {
    for (int i = 0; i < pictures; ++i) player_.See(sight);
  }
  void SeeNothing(int pictures) { See(Sight{}, pictures); }

  Player player_;
};

TEST_F(BallChaserPlayerTest, TurnsUntilItSeesTheBall) {
  SeeNothing(50);
  EXPECT_EQ(player_.GetState(), Player::SEARCH);
  EXPECT_GT(player_.Command().turn, 0.5);
  EXPECT_EQ(player_.Command().forward, 0);
  See(SightOf(1000, 0));
  EXPECT_EQ(player_.GetState(), Player::APPROACH);
}

TEST_F(BallChaserPlayerTest, WalksToTheBallAndLooksAtIt) {
  See(SightOf(1000, 300));
  EXPECT_GT(player_.Command().forward, 150);
  EXPECT_GT(player_.Command().turn, 0.3);
  EXPECT_GT(player_.Command().headPan, 0.1);
  EXPECT_LT(player_.Command().headTilt, -0.1);
  See(SightOf(1000, -300));
  EXPECT_LT(player_.Command().turn, -0.3);
  EXPECT_LT(player_.Command().headPan, -0.1);
}

TEST_F(BallChaserPlayerTest, SearchesOnTheSideWhereItHasLostTheBall) {
  See(SightOf(800, -400));
  SeeNothing(60);
  EXPECT_EQ(player_.GetState(), Player::SEARCH);
  EXPECT_LT(player_.Command().turn, -0.5);
}

TEST_F(BallChaserPlayerTest, CirclesToTheSideThatBringsTheGoalBehindTheBall) {
  const GoalSight left = {1, 0, 0.45, 0.25}, right = {1, 0, -0.25, -0.45};
  See(SightOf(400, 0, left), 3);
  EXPECT_EQ(player_.GetState(), Player::CIRCLE);
  EXPECT_LT(player_.Command().left, -40);
  See(SightOf(400, 0, right));
  EXPECT_GT(player_.Command().left, 40);
}

TEST_F(BallChaserPlayerTest, CirclesTheShortWayWhenItSeesItsOwnGoal) {
  Sight sight = SightOf(400, 0);
  sight.goal[YELLOW_GOAL] = {1, 0, 0.4, 0.2};
  See(sight, 80);
  EXPECT_EQ(player_.GetState(), Player::CIRCLE);
  EXPECT_GT(player_.Command().left, 40);  // the other goal is at -2.8 rad
}

TEST_F(BallChaserPlayerTest, PushesTheBallWhenTheGoalIsBehindIt) {
  const GoalSight ahead = {1, 0, 0.2, -0.2};
  See(SightOf(400, 0, ahead), 3);
  EXPECT_EQ(player_.GetState(), Player::PUSH);
  EXPECT_GT(player_.Command().forward, 150);
}

TEST_F(BallChaserPlayerTest, PlaysAtTheGoalThatItWasTold) {
  player_.SetGoal(YELLOW_GOAL);
  See(SightOf(400, 0, {1, 0, 0.2, -0.2}), 3);
  EXPECT_EQ(player_.GetState(), Player::CIRCLE);
  Sight sight = SightOf(400, 0);
  sight.goal[YELLOW_GOAL] = {1, 0, 0.2, -0.2};
  See(sight, 3);
  EXPECT_EQ(player_.GetState(), Player::PUSH);
}

TEST_F(BallChaserPlayerTest, LooksDownWhileItPushesABallThatItDoesNotSee) {
  See(SightOf(400, 0, {1, 0, 0.2, -0.2}), 3);
  Sight goal_only{};
  goal_only.goal[SKY_BLUE_GOAL] = {1, 0, 0.2, -0.2};
  See(goal_only, 30);
  EXPECT_EQ(player_.GetState(), Player::PUSH);
  EXPECT_LT(player_.Command().headTilt, -0.9);
  See(goal_only, 30);
  EXPECT_EQ(player_.GetState(), Player::SEARCH);
}

TEST_F(BallChaserPlayerTest, DoesNotPushForLongWithoutALookAtTheGoal) {
  See(SightOf(400, 0, {1, 0, 0.2, -0.2}), 3);
  See(SightOf(200, 0), 100);
  EXPECT_EQ(player_.GetState(), Player::PUSH);
  See(SightOf(200, 0), 40);
  EXPECT_NE(player_.GetState(), Player::PUSH);
}

TEST_F(BallChaserPlayerTest, PushesAnywhereWhenItHasCircledTheBallInVain) {
  See(SightOf(400, 0), 10);
  EXPECT_EQ(player_.GetState(), Player::CIRCLE);
  See(SightOf(400, 0), 26 * 25);
  EXPECT_EQ(player_.GetState(), Player::PUSH);
}

}  // namespace
}  // namespace openr_host
