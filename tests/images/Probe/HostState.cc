#include "HostState.h"

#include <locale.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <sstream>

static const time_t someTime = 1000000000;  // 2001-09-09 01:46:40 UTC

static std::string LocalTime() {
  char text[100];
  struct tm parts = *localtime(&someTime);
  strftime(text, sizeof(text), "%Y-%m-%d %H:%M:%S %Z ", &parts);
  std::ostringstream out;
  out << text << (mktime(&parts) == someTime) << " " << ctime(&someTime);
  return out.str();
}

static std::string Locale() {
  std::ostringstream out;
  out << setlocale(LC_ALL, "") << " " << setlocale(LC_ALL, 0) << " "
      << (setlocale(LC_ALL, "C.UTF-8") == 0);
  return out.str();
}

static char words[] = "one two three";

std::string AnswerHostState(const std::string& command) {
  std::ostringstream out;
  if (command == "environment") out << (getenv("PATH") == 0);
  if (command == "local time") out << LocalTime();
  if (command == "locale") out << Locale();
  if (command == "wall clock") {
    struct timespec now;
    out << timespec_get(&now, TIME_UTC) << " " << (now.tv_sec - time(0));
  }
  if (command == "numbers 48") out << lrand48() << " " << mrand48() << " " << drand48();
  if (command == "words") out << strtok(words, " ");
  if (command == "next word") out << strtok(0, " ");
  return out.str();
}
