// Days and dates of the Gregorian calendar.  Days are counted from 2000-01-01, where the clock of
// the robot (OTime) begins.
#pragma once

#include <cstdint>

namespace openr_host {

struct CivilDate {
  int64_t year = 2000;  // the year with all its digits, such as 2000
  int month = 1;        // 1..12
  int day = 1;          // 1..31
};

// Returns the number of days from 2000-01-01 to the first day of a month.  `month` may be any
// number: 13 is January of the next year.
int64_t DaysToMonth(int64_t year, int64_t month);

// Returns the number of days of a month.  REQUIRES: 1 <= month <= 12.
int DaysInMonth(int64_t year, int month);

// Returns the date `days` days after 2000-01-01.  A negative `days` gives a date before 2000-01-01.
CivilDate DateOfDay(int64_t days);

// Returns the day of the week, 0 for Sunday, of the date `days` days after 2000-01-01, a Saturday.
int WeekdayOfDay(int64_t days);

}  // namespace openr_host
