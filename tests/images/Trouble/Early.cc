// Faults in the constructor of a global object, which runs while the image is loaded, and in its
// destructor, which runs while the image is unloaded.
#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static volatile int sink;
static int* volatile nowhere = 0;

struct Early {
    char word[32];

    Early()
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
    }
    ~Early()
    {
        if (strcmp(word, "latecrash") == 0) *nowhere = 1;
    }
};

static Early early;
