#include <OPENR/OCalendarTime.h>
#include <gtest/gtest.h>

#include <string>

namespace {

std::string Sprint(const OCalendarTime& time) {
  char text[32];
  time.Sprint(text);
  return text;
}

std::string Rfc2822(const OCalendarTime& time) {
  char text[32];
  time.RFC2822(text);
  return text;
}

// The time 2004-02-29 04:05:07 UTC, 1520 days and 4 h 5 min 7 s after the start of 2000.
constexpr time_t kLeapDay = 1520 * 86400 + 4 * 3600 + 5 * 60 + 7;

TEST(OCalendarTimeTest, TheDefaultIsTheStartOfTheYear2000WhichWasASaturday) {
  const OCalendarTime time;
  EXPECT_EQ(time.year_, 0);
  EXPECT_EQ(time.month_, 1);
  EXPECT_EQ(time.day_, 1);
  EXPECT_EQ(time.hour_ + time.min_ + time.sec_, 0);
  EXPECT_EQ(time.dow_, ocldtSTART_DAY_OF_THE_WEEK);
  EXPECT_EQ(time.timeDif_, otimeTIME_DIF_UNDEF);
}

TEST(OCalendarTimeTest, FieldsAreLocalTime) {
  const OCalendarTime time(kLeapDay, 9);
  EXPECT_EQ(time.year_, 4);
  EXPECT_EQ(time.month_, 2);
  EXPECT_EQ(time.day_, 29);
  EXPECT_EQ(time.hour_, 13);
  EXPECT_EQ(time.min_, 5);
  EXPECT_EQ(time.sec_, 7);
  EXPECT_EQ(time.dow_, ocldtdowSUNDAY);
}

TEST(OCalendarTimeTest, TheZoneCanMoveTheDay) {
  const OCalendarTime time(kLeapDay, -5);  // local time is 23:05:07 of the day before
  EXPECT_EQ(time.day_, 28);
  EXPECT_EQ(time.hour_, 23);
  EXPECT_EQ(time.dow_, ocldtdowSATURDAY);
}

TEST(OCalendarTimeTest, ClockAndZoneComeBackAsTheyWentIn) {
  time_t clock = 0;
  sbyte dif = 0;
  OCalendarTime(OTime(kLeapDay, 9)).GetTime(&clock, &dif);
  EXPECT_EQ(clock, kLeapDay);
  EXPECT_EQ(dif, 9);
  OTime time;
  OCalendarTime(kLeapDay, -3).GetTime(&time);
  EXPECT_EQ(time.GetClock(), kLeapDay);
  EXPECT_EQ(time.GetTimeDif(), -3);
}

TEST(OCalendarTimeTest, MomentsBefore2000HaveNegativeYears) {
  const OCalendarTime time(-1, 0);
  EXPECT_EQ(time.year_, -1);
  EXPECT_EQ(time.month_, 12);
  EXPECT_EQ(time.day_, 31);
  EXPECT_EQ(time.sec_, 59);
  EXPECT_FALSE(time.ProperDate());
}

TEST(OCalendarTimeTest, FieldsBeyondTheirRangeCarryOver) {
  OCalendarTime april;
  april.month_ = 4;
  april.day_ = 31;
  OCalendarTime may;
  may.month_ = 5;
  EXPECT_TRUE(april == may);
}

TEST(OCalendarTimeTest, OrderIsThatOfTheMomentsWhateverTheZone) {
  EXPECT_TRUE(OCalendarTime(10, 9) == OCalendarTime(10, -9));
  EXPECT_TRUE(OCalendarTime(10, 9) != OCalendarTime(11, 9));
  EXPECT_TRUE(OCalendarTime(10, -9) < OCalendarTime(11, 9));
  EXPECT_TRUE(OCalendarTime(11, 0) >= OCalendarTime(10, 0));
}

TEST(OCalendarTimeTest, February29IsProperInLeapYearsOnly) {
  OCalendarTime time(kLeapDay, 0);
  EXPECT_TRUE(time.ProperDate());
  time.year_ = 3;
  EXPECT_FALSE(time.ProperDate());
  time.year_ = 100;  // the year 2100
  EXPECT_FALSE(time.ProperDate());
}

TEST(OCalendarTimeTest, EveryFieldBeyondItsRangeMakesTheDateImproper) {
  const OCalendarTime good(kLeapDay, 0);
  int improper = 0;
  for (int OCalendarTime::*field :
       {&OCalendarTime::year_, &OCalendarTime::month_, &OCalendarTime::day_, &OCalendarTime::hour_,
        &OCalendarTime::min_, &OCalendarTime::sec_}) {
    OCalendarTime time = good;
    time.*field = 10000;
    improper += !time.ProperDate();
    time.*field = -1;
    improper += !time.ProperDate();
  }
  EXPECT_EQ(improper, 12);
}

TEST(OCalendarTimeTest, CorrectDayOfTheWeekGoesByTheDate) {
  OCalendarTime time;
  time.year_ = 4;
  time.month_ = 2;
  time.day_ = 29;
  time.dow_ = 99;
  EXPECT_EQ(time.CorrectDayOfTheWeek(), oSUCCESS);
  EXPECT_EQ(time.dow_, ocldtdowSUNDAY);
}

TEST(OCalendarTimeTest, CorrectDayOfTheWeekRefusesAnImproperDateAndChangesNothing) {
  OCalendarTime time;
  time.month_ = 13;
  EXPECT_EQ(time.CorrectDayOfTheWeek(), oINVALID_ARG);
  EXPECT_EQ(time.dow_, ocldtSTART_DAY_OF_THE_WEEK);
}

TEST(OCalendarTimeTest, SettingSaysWhetherTheZoneIsOneAndFillsTheFieldsAnyway) {
  OCalendarTime time;
  EXPECT_EQ(time.SetTime(kLeapDay, 9), oSUCCESS);
  EXPECT_EQ(time.SetTime(kLeapDay, otimeTIME_DIF_UNDEF), oSUCCESS);
  EXPECT_EQ(time.SetTime(OTime(0, 9)), oSUCCESS);
  EXPECT_EQ(time.SetTime(kLeapDay, 13), oINVALID_ARG);
  EXPECT_EQ(time.timeDif_, otimeTIME_DIF_UNDEF);
  EXPECT_EQ(time.day_, 29);
}

TEST(OCalendarTimeTest, GettingSaysWhetherTheDateIsProperAndAnswersAnyway) {
  OCalendarTime time(kLeapDay, 9);
  OTime moment;
  EXPECT_EQ(time.GetTime(&moment), oSUCCESS);
  time.day_ = 30;  // the 30th of February 2004 means the 1st of March
  time_t clock = 0;
  sbyte dif = 0;
  EXPECT_EQ(time.GetTime(&clock, &dif), oINVALID_ARG);
  EXPECT_EQ(clock, kLeapDay + 86400);
  EXPECT_EQ(dif, 9);
  EXPECT_EQ(time.GetTime(&moment), oINVALID_ARG);
  EXPECT_EQ(moment.GetClock(), kLeapDay + 86400);
}

TEST(OCalendarTimeTest, Rfc2822HasTheZoneAsFourDigits) {
  EXPECT_EQ(Rfc2822(OCalendarTime(kLeapDay, 9)), "Sun, 29 Feb 2004 13:05:07 +0900");
  EXPECT_EQ(Rfc2822(OCalendarTime(kLeapDay, -5)), "Sat, 28 Feb 2004 23:05:07 -0500");
  EXPECT_EQ(Rfc2822(OCalendarTime(kLeapDay, 0)), "Sun, 29 Feb 2004 04:05:07 +0000");
}

TEST(OCalendarTimeTest, Rfc2822WritesAnUnknownZoneAsMinusZero) {
  EXPECT_EQ(Rfc2822(OCalendarTime(0, otimeTIME_DIF_UNDEF)), "Sat, 01 Jan 2000 00:00:00 -0000");
}

TEST(OCalendarTimeTest, SprintShowsDateDayTimeAndZone) {
  EXPECT_EQ(Sprint(OCalendarTime(kLeapDay, 9)), "2004/02/29 Sun 13:05:07 UTC+9");
  EXPECT_EQ(Sprint(OCalendarTime(0, otimeTIME_DIF_UNDEF)), "2000/01/01 Sat 00:00:00");
}

TEST(OCalendarTimeTest, AnImproperDateIsCalledThat) {
  OCalendarTime time;
  time.hour_ = 24;
  EXPECT_EQ(Sprint(time), "improper date");
  EXPECT_EQ(Rfc2822(time), "improper date");
}

TEST(OCalendarTimeTest, TheLongestTextFits32Characters) {
  OCalendarTime time(kLeapDay, -12);
  time.year_ = 7999;
  EXPECT_LT(Sprint(time).size(), 32u);
  EXPECT_EQ(Rfc2822(time).size(), 31u);
}

TEST(OCalendarTimeTest, LeapYearTakesFullYearsAndYearsSince2000) {
  EXPECT_TRUE(LeapYear(2004));
  EXPECT_TRUE(LeapYear(4));
  EXPECT_TRUE(LeapYear(0));
  EXPECT_FALSE(LeapYear(100));
  EXPECT_FALSE(LeapYear(2003));
}

}  // namespace
