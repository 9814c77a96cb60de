#include "Writes.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <string>

#define WRITES_FOLDER "/MS/OPEN-R/MW/DATA/P/"

// Returns the result of a call and, if it is a failure, errno: "-1/28".
static std::string
Outcome(long result, bool hasFailed)
{
    char text[40];
    sprintf(text, hasFailed ? "%ld/%d" : "%ld", result, errno);
    return text;
}

static void
WriteStream()
{
    std::string said = "W stdio";
    FILE* const file = fopen(WRITES_FOLDER "STDIO.TXT", "w");
    said += " fopen " + Outcome(file != 0, file == 0);
    if (file != 0) {
        const std::string text(6000, 's');
        const bool isWhole = fwrite(text.data(), 1, text.size(), file) == text.size();
        said += isWhole ? " fwrite all" : " fwrite " + Outcome(-1, true);
        int result = fflush(file);
        said += " fflush " + Outcome(result, result != 0);
        result = fclose(file);
        said += " fclose " + Outcome(result, result != 0);
    }
    OSYSPRINT(("%s\n", said.c_str()));
}

// Writes so little that only fclose() passes it on to the stick.
static void
WriteAtClose()
{
    FILE* const file = fopen(WRITES_FOLDER "CLOSE.TXT", "w");
    if (file == 0) return;
    const int put = fputs("late", file);
    const int closed = fclose(file);
    OSYSPRINT(("W close fputs %d fclose %s\n", put >= 0, Outcome(closed, closed != 0).c_str()));
}

static void
WriteDescriptor()
{
    const int file = open(WRITES_FOLDER "OPEN.TXT", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    std::string said = "W descriptor open " + Outcome(file >= 0, file < 0);
    if (file >= 0) {
        const std::string text(6000, 'd');
        const long count = (long)write(file, text.data(), text.size());
        said += " write " + Outcome(count, count < 0);
        const int closed = close(file);
        said += " close " + Outcome(closed, closed != 0);
    }
    OSYSPRINT(("%s\n", said.c_str()));
}

static void
WriteOfstream()
{
    std::ofstream file(WRITES_FOLDER "STREAM.TXT");
    const bool isOpen = file.is_open();
    file << std::string(6000, 'o');
    file.close();
    OSYSPRINT(("W ofstream open %d good %d\n", isOpen, file.good()));
}

static void
ChangeFolders()
{
    const int made = mkdir(WRITES_FOLDER "MADE", 0);
    std::string said = "W folders mkdir " + Outcome(made, made != 0);
    const int removed = remove(WRITES_FOLDER "MADE");
    said += " remove " + Outcome(removed, removed != 0);
    const int renamed = rename(WRITES_FOLDER "STAY.TXT", WRITES_FOLDER "MOVED.TXT");
    said += " rename " + Outcome(renamed, renamed != 0);
    OSYSPRINT(("%s\n", said.c_str()));
}

void
LeaveStreams()
{
    // Never closed.
    FILE* file = fopen(WRITES_FOLDER "LEFT.TXT", "w");
    if (file != 0) fputs("left", file);
    // Each of these streams forgets that a write has failed, because of another call.
    file = fopen(WRITES_FOLDER "REWIND.TXT", "w");
    if (file != 0) {
        fputs("rewind", file);
        rewind(file);
        fclose(file);
    }
    file = fopen(WRITES_FOLDER "REOPEN.TXT", "w");
    if (file != 0) {
        fputs("reopen", file);
        file = freopen(WRITES_FOLDER "OTHER.TXT", "w", file);
        if (file != 0) fclose(file);
    }
    file = fopen(WRITES_FOLDER "CLEAR.TXT", "w");
    if (file != 0) {
        setvbuf(file, 0, _IONBF, 0);
        fprintf(file, "%d", 6000);  // not by fputs(), which the compiler makes an fwrite()
        clearerr(file);
        fclose(file);
    }
}

void
WriteInAllWays()
{
    OMemoryStickStatus status = omemorystickUNDEF;
    OPENR::GetMemoryStickStatus(&status);
    OSYSPRINT(("W stick %d\n", (int)status));
    WriteStream();
    WriteAtClose();
    WriteDescriptor();
    WriteOfstream();
    ChangeFolders();
}
