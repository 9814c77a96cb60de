#include "runtime/api/calendar.h"

#include <gtest/gtest.h>

namespace openr_host {
namespace {

// The years 1600 to 2800 contain every kind of century boundary.
TEST(CalendarTest, EveryDayOfTwelveHundredYearsFollowsTheDayBefore) {
  CivilDate expected;
  expected.year = 1600;
  for (int64_t day = DaysToMonth(1600, 1); day < DaysToMonth(2800, 1); ++day) {
    const CivilDate date = DateOfDay(day);
    ASSERT_EQ(date.year, expected.year) << "day " << day;
    ASSERT_EQ(date.month, expected.month) << "day " << day;
    ASSERT_EQ(date.day, expected.day) << "day " << day;
    ASSERT_EQ(DaysToMonth(date.year, date.month) + date.day - 1, day);
    if (++expected.day > DaysInMonth(expected.year, expected.month)) {
      expected.day = 1;
      if (++expected.month > 12) {
        expected.month = 1;
        ++expected.year;
      }
    }
  }
}

TEST(CalendarTest, CountingStartsWithTheYear2000) { EXPECT_EQ(DaysToMonth(2000, 1), 0); }

TEST(CalendarTest, CenturiesAreLeapYearsOnlyWhenDivisibleBy400) {
  EXPECT_EQ(DaysInMonth(2000, 2), 29);
  EXPECT_EQ(DaysInMonth(2100, 2), 28);
  EXPECT_EQ(DaysInMonth(2004, 2), 29);
}

TEST(CalendarTest, MonthsCarryOverIntoTheYear) {
  EXPECT_EQ(DaysToMonth(2003, 13), DaysToMonth(2004, 1));
  EXPECT_EQ(DaysToMonth(2004, 0), DaysToMonth(2003, 12));
  EXPECT_EQ(DaysToMonth(2004, -11), DaysToMonth(2003, 1));
}

// 2000-01-01 was a Saturday, 1970-01-01 a Thursday, 1969-07-20 a Sunday.
TEST(CalendarTest, WeekdaysAreRightBeforeAndAfterTheStart) {
  EXPECT_EQ(WeekdayOfDay(0), 6);
  EXPECT_EQ(WeekdayOfDay(1), 0);
  EXPECT_EQ(WeekdayOfDay(DaysToMonth(1970, 1)), 4);
  EXPECT_EQ(WeekdayOfDay(DaysToMonth(1969, 7) + 19), 0);
}

}  // namespace
}  // namespace openr_host
