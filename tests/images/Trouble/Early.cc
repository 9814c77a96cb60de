// Faults in the constructor of a global object, which runs while the image is loaded, and in its
// destructor and in functions for the end of a program, which never run.
#include <assert.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <fstream>
#include <string>

static volatile int sink;
static int* volatile nowhere = 0;

static void Crash() { *nowhere = 1; }
static void CrashWith(int, void*) { *nowhere = 1; }

// Uses files with streams of C++ and with descriptors.
static void UseFiles()
{
    const char name[] = "/MS/OPEN-R/MW/DATA/P/EARLY.TXT";
    std::ofstream out(name);
    out << "from a constructor\n";
    out.close();
    std::string   line;
    std::ifstream in(name);
    std::getline(in, line);
    in.close();
    char      bytes[5] = "";
    const int file     = open(name, O_RDONLY);
    const int got      = static_cast<int>(read(file, bytes, 4));
    printf("early files: %s, %d %s, closed %d\n", line.c_str(), got, bytes, close(file));
}

struct Early {
    char word[32];
    FILE* left;  // is open when the image is unloaded

    Early() : left(0)
    {
        word[0] = 0;
        FILE* file = fopen("/MS/OPEN-R/MW/DATA/P/TROUBLE.TXT", "r");
        if (file == 0) return;
        if (fscanf(file, "%31s", word) != 1) word[0] = 0;
        fclose(file);
        if (strcmp(word, "earlycrash") == 0) *nowhere = 1;
        if (strcmp(word, "earlyabort") == 0) abort();
        if (strcmp(word, "earlyexit") == 0) exit(4);
        if (strcmp(word, "earlyassert") == 0) assert(nowhere != 0);
        while (strcmp(word, "earlyhang") == 0) sink = 1 - sink;
        if (strcmp(word, "earlyfiles") == 0) UseFiles();
        if (strcmp(word, "lateclose") == 0) left = fopen("/MS/OPEN-R/MW/DATA/P/LEFT.TXT", "w");
        if (strcmp(word, "latecrash") == 0) {
            atexit(Crash);
            on_exit(CrashWith, 0);
        }
    }
    ~Early()
    {
        if (left != 0) fclose(left);
        if (strcmp(word, "latecrash") == 0) *nowhere = 1;
        if (strcmp(word, "lateexit") == 0) exit(3);
        while (strcmp(word, "latehang") == 0) sink = 1 - sink;
    }
};

static Early early;
