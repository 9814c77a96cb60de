#include "runtime/base/spelling.h"

#include <gtest/gtest.h>

namespace openr_host::spelling_test {
namespace {

TEST(SpellingTest, DistanceCountsInsertionsDeletionsAndReplacements) {
  EXPECT_EQ(EditDistance("kitten", "sitting"), 3);
  EXPECT_EQ(EditDistance("", "abc"), 3);
  EXPECT_EQ(EditDistance("abc", ""), 3);
  EXPECT_EQ(EditDistance("", ""), 0);
}

TEST(SpellingTest, SwapOfNeighboursIsOneEdit) { EXPECT_EQ(EditDistance("Mvoe", "Move"), 1); }

TEST(SpellingTest, CaseDoesNotCount) { EXPECT_EQ(EditDistance("MOVER", "mover"), 0); }

TEST(SpellingTest, MatchPrefersTheExactNameToThatInAnotherCase) {
  EXPECT_EQ(MatchIgnoringCase("Talker", {"talker", "listener"}), "talker");
  EXPECT_EQ(MatchIgnoringCase("talker", {"Talker", "talker"}), "talker");
  EXPECT_EQ(MatchIgnoringCase("TALKER", {"talker", "talker"}), "talker");
}

TEST(SpellingTest, NothingMatchesWhereSeveralNamesDifferInCaseOnly) {
  EXPECT_EQ(MatchIgnoringCase("TALKER", {"Talker", "talker"}), std::nullopt);
  EXPECT_EQ(MatchIgnoringCase("talk", {"talker"}), std::nullopt);
  EXPECT_EQ(MatchIgnoringCase("talker", {}), std::nullopt);
}

TEST(SpellingTest, NearestCandidateIsOffered) {
  EXPECT_EQ(DidYouMean("JOINTMVR.BIN", {"POWERMON.BIN", "JOINTMOV.BIN"}),
            "; did you mean 'JOINTMOV.BIN'?");
}

TEST(SpellingTest, FirstOfEquallyNearCandidatesIsOffered) {
  EXPECT_EQ(DidYouMean("Movex", {"Movea", "Moveb"}), "; did you mean 'Movea'?");
}

TEST(SpellingTest, NothingIsOfferedWhenNothingIsNear) {
  EXPECT_EQ(DidYouMean("Sensor", {"Effector", "Move"}), "");
  EXPECT_EQ(DidYouMean("Sensor", {}), "");
}

TEST(SpellingTest, ShortWordsMustBeVeryNear) {
  EXPECT_EQ(DidYouMean("Led", {"Ear"}), "");
  EXPECT_EQ(DidYouMean("Led", {"Leg"}), "; did you mean 'Leg'?");
}

TEST(SpellingTest, MoreThanThreeEditsAreAnotherWordHoweverLong) {
  EXPECT_EQ(DidYouMean("RemoteControlServer.Moverxxxx", {"RemoteControlServer.Mover"}), "");
}

TEST(SpellingTest, WordThatIsRightGetsNoOffer) {
  EXPECT_EQ(DidYouMean("Move", {"Mover", "Move"}), "");
}

TEST(SpellingTest, WrongCaseIsOffered) {
  EXPECT_EQ(DidYouMean("jointmover", {"JointMover"}), "; did you mean 'JointMover'?");
}

}  // namespace
}  // namespace openr_host::spelling_test
