#include "runtime/api/calendar.h"

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

constexpr int64_t kDaysIn400Years = 146097;
constexpr int kSaturday = 6;

// Divides and rounds down, also if `dividend` is negative.  The operator / would round a negative
// quotient up.
int64_t FloorDiv(int64_t dividend, int64_t divisor) {
  const int64_t quotient = dividend / divisor;
  return dividend % divisor < 0 ? quotient - 1 : quotient;
}

bool IsLeap(int64_t year) { return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0); }

// Returns the number of days from 2000-01-01 to January 1 of `year`: 365 for each year in between,
// and one more for each leap year.  The number is negative before 2000.
int64_t DaysToYear(int64_t year) {
  const int64_t year_before = year - 1;  // the last full year before January 1 of `year`
  const int64_t leap_years =
      FloorDiv(year_before, 4) - FloorDiv(year_before, 100) + FloorDiv(year_before, 400);
  constexpr int64_t kLeapYearsBefore2000 = 1999 / 4 - 1999 / 100 + 1999 / 400;
  return (year - 2000) * 365 + leap_years - kLeapYearsBefore2000;
}

}  // namespace

int DaysInMonth(int64_t year, int month) {
  ASSERT(month >= 1 && month <= 12, "month {}", month);
  constexpr int kDays[] = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  return month == 2 && IsLeap(year) ? 29 : kDays[month - 1];
}

int64_t DaysToMonth(int64_t year, int64_t month) {
  const int64_t whole_year = year + FloorDiv(month - 1, 12);
  const int last = static_cast<int>(month - 1 - FloorDiv(month - 1, 12) * 12);
  int64_t days = DaysToYear(whole_year);
  for (int m = 1; m <= last; ++m) days += DaysInMonth(whole_year, m);
  return days;
}

CivilDate DateOfDay(int64_t days) {
  CivilDate date;
  // Begins with a guess that is never too late: the first year of the period of 400 years, plus one
  // year for every 366 days since then.  Most years have 365 days, so the guess may be too early.
  // The loop then adds years until `days` lies in the year.
  date.year = 2000 + FloorDiv(days, kDaysIn400Years) * 400;
  date.year += (days - DaysToYear(date.year)) / 366;
  while (days >= DaysToYear(date.year + 1)) ++date.year;
  int64_t rest = days - DaysToYear(date.year);
  while (rest >= DaysInMonth(date.year, date.month)) {
    rest -= DaysInMonth(date.year, date.month);
    ++date.month;
  }
  date.day = static_cast<int>(rest) + 1;
  return date;
}

int WeekdayOfDay(int64_t days) {
  return static_cast<int>(days + kSaturday - FloorDiv(days + kSaturday, 7) * 7);
}

}  // namespace openr_host
