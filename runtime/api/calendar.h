// Days and dates of the Gregorian calendar, counted from 2000-01-01.
#pragma once

#include <cstdint>

namespace openr_host {

struct CivilDate {
  int64_t year = 2000;  // full
  int month = 1;        // 1..12
  int day = 1;          // 1..31
};

// Days from 2000-01-01 to the first of a month; `month` may be any number and carries
// over into the year.
int64_t DaysToMonth(int64_t year, int64_t month);

// REQUIRES: 1 <= month <= 12.
int DaysInMonth(int64_t year, int month);

// The date that lies `days` after (or before) 2000-01-01.
CivilDate DateOfDay(int64_t days);

// 0 is Sunday; 2000-01-01 was a Saturday.
int WeekdayOfDay(int64_t days);

}  // namespace openr_host
