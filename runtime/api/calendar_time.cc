// OCalendarTime: the time of an OTime as local date, time of day and time zone.
#include <OPENR/OCalendarTime.h>
#include <OPENR/OSyslog.h>
#include <fmt/format.h>

#include <cstring>
#include <string>

#include "runtime/api/calendar.h"

using openr_host::CivilDate;

namespace {

constexpr const char* kDayNames[] = {"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
constexpr const char* kMonthNames[] = {"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                       "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
// The largest year_ that ProperDate() accepts.  The text of a date has four digits for the year, so
// the largest year is 9999; year_ is counted from otimeSTART_YEAR.
constexpr int kYearMax = 9999 - otimeSTART_YEAR;

// Returns the number of days from 2000-01-01 to the date of `t`.
int64_t DayOf(const OCalendarTime& t) {
  return openr_host::DaysToMonth(int64_t{otimeSTART_YEAR} + t.year_, t.month_) + t.day_ - 1;
}

bool InRange(int value, int least, int most) { return value >= least && value <= most; }

// Returns the name of the weekday, computed from the date.  The stored weekday, dow_, is not used,
// because a program may set it to any value.
const char* DayName(const OCalendarTime& t) {
  return kDayNames[openr_host::WeekdayOfDay(DayOf(t))];
}

void Write(char* text, const std::string& content) {
  std::memcpy(text, content.c_str(), content.size() + 1);
}

}  // namespace

OCalendarTime::OCalendarTime() { SetTime(OTime()); }
OCalendarTime::OCalendarTime(time_t clock, sbyte timeDif) { SetTime(OTime(clock, timeDif)); }
OCalendarTime::OCalendarTime(const OTime& time) { SetTime(time); }

OStatus OCalendarTime::SetTime(time_t clock, sbyte timeDif) {
  SetTime(OTime(clock, timeDif));
  return timeDif_ == timeDif ? oSUCCESS : oINVALID_ARG;
}

OStatus OCalendarTime::SetTime(const OTime& time) {
  constexpr int64_t kSecondsPerDay = 86400;
  const int64_t local = time.GetLocalTime();
  int64_t second = local % kSecondsPerDay;
  if (second < 0) second += kSecondsPerDay;
  const int64_t day = (local - second) / kSecondsPerDay;

  const CivilDate date = openr_host::DateOfDay(day);
  year_ = static_cast<int>(date.year - otimeSTART_YEAR);
  month_ = date.month;
  day_ = date.day;
  hour_ = static_cast<int>(second / 3600);
  min_ = static_cast<int>(second / 60 % 60);
  sec_ = static_cast<int>(second % 60);
  dow_ = openr_host::WeekdayOfDay(day);
  timeDif_ = time.GetTimeDif();
  return oSUCCESS;
}

time_t OCalendarTime::Clock() const {
  OTime time(0, timeDif_);
  time.SetLocalTime(((DayOf(*this) * 24 + hour_) * 60 + min_) * 60 + sec_);
  return time.GetClock();
}

OStatus OCalendarTime::GetTime(time_t* clock, sbyte* timeDif) const {
  *clock = Clock();
  *timeDif = timeDif_;
  return ProperDate() ? oSUCCESS : oINVALID_ARG;
}

OStatus OCalendarTime::GetTime(OTime* time) const {
  *time = OTime(Clock(), timeDif_);
  return ProperDate() ? oSUCCESS : oINVALID_ARG;
}

bool OCalendarTime::ProperDate() const {
  return InRange(year_, 0, kYearMax) && InRange(month_, 1, 12) &&
         InRange(day_, 1, openr_host::DaysInMonth(otimeSTART_YEAR + year_, month_)) &&
         InRange(hour_, 0, 23) && InRange(min_, 0, 59) && InRange(sec_, 0, 59) &&
         (timeDif_ == otimeTIME_DIF_UNDEF || InRange(timeDif_, -12, 12));
}

OStatus OCalendarTime::CorrectDayOfTheWeek() {
  if (!ProperDate()) return oINVALID_ARG;
  dow_ = openr_host::WeekdayOfDay(DayOf(*this));
  return oSUCCESS;
}

void OCalendarTime::Sprint(char* text) const {
  if (!ProperDate()) return Write(text, "improper date");
  const std::string zone =
      timeDif_ == otimeTIME_DIF_UNDEF ? "" : fmt::format(" UTC{:+}", int{timeDif_});
  Write(text, fmt::format("{:04}/{:02}/{:02} {} {:02}:{:02}:{:02}{}", otimeSTART_YEAR + year_,
                          month_, day_, DayName(*this), hour_, min_, sec_, zone));
}

void OCalendarTime::RFC2822(char* text) const {
  if (!ProperDate()) return Write(text, "improper date");
  // Writes "-0000" for an unknown time zone (RFC 2822, 3.3).
  const std::string zone =
      timeDif_ == otimeTIME_DIF_UNDEF
          ? "-0000"
          : fmt::format("{}{:02}00", timeDif_ < 0 ? '-' : '+', timeDif_ < 0 ? -timeDif_ : timeDif_);
  Write(text,
        fmt::format("{}, {:02} {} {:04} {:02}:{:02}:{:02} {}", DayName(*this), day_,
                    kMonthNames[month_ - 1], otimeSTART_YEAR + year_, hour_, min_, sec_, zone));
}

void OCalendarTime::Print() const {
  char text[32];
  Sprint(text);
  osysprint("%s\n", text);
}
