// A moment as year, month, day, hours, minutes and seconds of local time.
#ifndef OPENR_OCALENDARTIME_H_INCLUDED
#define OPENR_OCALENDARTIME_H_INCLUDED

#include <OPENR/OTime.h>

// Values of OCalendarTime::dow_, the day of the week.
const int ocldtdowSUNDAY = 0;
const int ocldtdowMONDAY = 1;
const int ocldtdowTUESDAY = 2;
const int ocldtdowWEDNESDAY = 3;
const int ocldtdowTHURSDAY = 4;
const int ocldtdowFRIDAY = 5;
const int ocldtdowSATURDAY = 6;

const int ocldtSTART_DAY_OF_THE_WEEK = ocldtdowSATURDAY;  // weekday of 2000-01-01

// Returns whether a year is a leap year.  `year` may be a full year (2004) or counted from 2000
// (4), because the calendar repeats every 400 years.
inline bool LeapYear(int year) { return year % 4 == 0 && (year % 100 != 0 || year % 400 == 0); }

// A moment in local time.  The fields are plain data: writing one field does not change the other
// fields, not even dow_, the day of the week.
class OCalendarTime {
 public:
  int year_;       // years since 2000
  int month_;      // 1..12
  int day_;        // 1..31
  int hour_;       // 0..23
  int min_;        // 0..59
  int sec_;        // 0..59
  int dow_;        // 0..6, Sunday is 0
  sbyte timeDif_;  // hours ahead of UTC, -12..12 or otimeTIME_DIF_UNDEF

  OCalendarTime();  // sets Saturday 2000-01-01 00:00:00, time difference undefined
  OCalendarTime(time_t clock, sbyte timeDif);
  OCalendarTime(const OTime& time);

  // Set every field.  If `timeDif` (hours by which local time is ahead of UTC) is neither -12..12
  // nor otimeTIME_DIF_UNDEF, it becomes otimeTIME_DIF_UNDEF, and the status is oINVALID_ARG.
  OStatus SetTime(time_t clock, sbyte timeDif);
  OStatus SetTime(const OTime& time);

  // Return the moment that the fields describe; dow_ is ignored.  Fields beyond their range carry
  // over: the 31st of April is the 1st of May.  If ProperDate() is false, the status is
  // oINVALID_ARG, but the moment is returned nevertheless.
  OStatus GetTime(time_t* clock, sbyte* timeDif) const;
  OStatus GetTime(OTime* time) const;

  // Compare the moments that the fields of the two times describe.
  bool operator<(const OCalendarTime& other) const { return Clock() < other.Clock(); }
  bool operator<=(const OCalendarTime& other) const { return Clock() <= other.Clock(); }
  bool operator>(const OCalendarTime& other) const { return Clock() > other.Clock(); }
  bool operator>=(const OCalendarTime& other) const { return Clock() >= other.Clock(); }
  bool operator==(const OCalendarTime& other) const { return Clock() == other.Clock(); }
  bool operator!=(const OCalendarTime& other) const { return Clock() != other.Clock(); }

  // Returns whether the fields are an existing day and time of the years 2000 to 9999 and the
  // difference to UTC is in its range.  dow_, the day of the week, is ignored.
  bool ProperDate() const;

  // Sets dow_, the day of the week, from year, month and day.  Unless ProperDate() holds, returns
  // oINVALID_ARG without a change.
  OStatus CorrectDayOfTheWeek();

  // Write the moment into `text`, which needs room for 32 characters.  If ProperDate() is false,
  // write "improper date" instead.
  void Sprint(char* text) const;   // writes a text such as "2004/02/29 Sun 13:05:07 UTC+9"
  void RFC2822(char* text) const;  // writes a text such as "Sun, 29 Feb 2004 13:05:07 +0900"

  // Prints the text of Sprint() as a line on the console.
  void Print() const;

 private:
  time_t Clock() const;  // returns the seconds since 2000-01-01 00:00:00 UTC
};

#endif  // OPENR_OCALENDARTIME_H_INCLUDED
