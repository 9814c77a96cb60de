#include <OPENR/OTime.h>
#include <SystemTime.h>
#include <TimeEvent.h>
#include <gtest/gtest.h>

namespace {

TEST(OTimeTest, LocalTimeIsTheClockPlusTheTimeDifference) {
  EXPECT_EQ(OTime(100000, 9).GetLocalTime(), 100000 + 9 * 3600);
  EXPECT_EQ(OTime(100000, -12).GetLocalTime(), 100000 - 12 * 3600);
}

TEST(OTimeTest, LocalTimeIsTheClockWhenTheZoneIsUnknown) {
  EXPECT_EQ(OTime().GetTimeDif(), otimeTIME_DIF_UNDEF);
  EXPECT_EQ(OTime(5, otimeTIME_DIF_UNDEF).GetLocalTime(), 5);
}

TEST(OTimeTest, SetLocalTimeMovesTheClockAndKeepsTheZone) {
  OTime time(0, 9);
  EXPECT_EQ(time.SetLocalTime(9 * 3600 + 7), oSUCCESS);
  EXPECT_EQ(time.GetClock(), 7);
  EXPECT_EQ(time.GetTimeDif(), 9);
}

TEST(OTimeTest, SetTimeDifKeepsTheClock) {
  OTime time(1000, 9);
  EXPECT_EQ(time.SetTimeDif(-5), oSUCCESS);
  EXPECT_EQ(time.GetClock(), 1000);
  EXPECT_EQ(time.GetTimeDif(), -5);
}

TEST(OTimeTest, ATimeDifferenceBeyondTwelveHoursIsRefusedAndChangesNothing) {
  OTime time(1000, 9);
  EXPECT_EQ(time.SetTimeDif(13), oINVALID_ARG);
  EXPECT_EQ(time.Set(2000, -13), oINVALID_ARG);
  EXPECT_EQ(time.GetClock(), 1000);
  EXPECT_EQ(time.GetTimeDif(), 9);
}

TEST(OTimeTest, TheConstructorTakesABadTimeDifferenceAsUndefined) {
  EXPECT_EQ(OTime(0, 13).GetTimeDif(), otimeTIME_DIF_UNDEF);
}

TEST(OTimeTest, OrderIsThatOfTheMomentsWhateverTheZone) {
  EXPECT_TRUE(OTime(10, 9) == OTime(10, -9));
  EXPECT_TRUE(OTime(10, 9) < OTime(11, -9));
  EXPECT_TRUE(OTime(11, 0) >= OTime(10, 0));
  EXPECT_FALSE(OTime(10, 0) > OTime(10, 0));
}

TEST(SystemTimeTest, SumCarriesMicrosecondsIntoSeconds) {
  const SystemTime sum = SystemTime(1, 700000) + SystemTime(2, 600000);
  EXPECT_EQ(sum.seconds, 4u);
  EXPECT_EQ(sum.useconds, 300000u);
}

TEST(SystemTimeTest, DifferenceBorrowsASecond) {
  const SystemTime span = SystemTime(5, 100000) - SystemTime(2, 600000);
  EXPECT_EQ(span.seconds, 2u);
  EXPECT_EQ(span.useconds, 500000u);
}

TEST(SystemTimeTest, SecondsDecideTheOrderBeforeMicroseconds) {
  EXPECT_TRUE(SystemTime(1, 999999) < SystemTime(2, 0));
  EXPECT_TRUE(SystemTime(1, 1) < SystemTime(1, 2));
  EXPECT_FALSE(SystemTime(1, 2) < SystemTime(1, 2));
}

TEST(SystemTimeTest, MadeInvalidItIsNotValid) {
  SystemTime time;
  EXPECT_TRUE(time.IsValid());
  time.MakeInvalid();
  EXPECT_FALSE(time.IsValid());
}

TEST(TimeEventTest, PeriodZeroMeansOneMessage) {
  const TimeEventInfoWithRelativeTime once(RelativeTime(1, 500));
  EXPECT_EQ(once.eventType, TimeEventInfo::NonPeriodic);
  const TimeEventInfoWithRelativeTime often(RelativeTime(1), RelativeTime(0, 32));
  EXPECT_EQ(often.eventType, TimeEventInfo::Periodic);
  EXPECT_TRUE(often.periodicTime == RelativeTime(0, 32));
}

TEST(TimeEventTest, APeriodicTypeRepeatsAfterItsTime) {
  const TimeEventInfoWithRelativeTime often(TimeEventInfo::Periodic, RelativeTime(2));
  EXPECT_TRUE(often.relativeTime == RelativeTime(2));
  EXPECT_TRUE(often.periodicTime == RelativeTime(2));
  EXPECT_EQ(often.eventAttr, static_cast<longword>(TimeEventInfo::ExceedStartImmediate));
}

}  // namespace
