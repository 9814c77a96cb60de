// Files, console and the C library, as an object meets them.
#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <assert.h>
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/select.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <fstream>
#include <iostream>

#include "../Writes.h"
#include "Teller.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // gets()

#define FOLDER "/MS/OPEN-R/MW/DATA/P/"

static const char*
OpenTwice(const char* first, const char* second)
{
    FILE* one = fopen(FOLDER "HELLO.TXT", first);
    if (one == 0) return "first refused";
    FILE* two = fopen(FOLDER "HELLO.TXT", second);
    if (two != 0) fclose(two);
    fclose(one);
    return two == 0 ? "second refused" : "both open";
}

static void
List(const char* path)
{
    DIR* folder = opendir(path);
    if (folder == 0) {
        OSYSPRINT(("T no folder\n"));
        return;
    }
    int count = 0;
    char last[20] = "";
    while (struct dirent* entry = readdir(folder)) {
        if (entry->d_name[0] == '.') continue;
        count++;
        strcpy(last, entry->d_name);
    }
    rewinddir(folder);
    const bool again = readdir(folder) != 0;
    closedir(folder);
    OSYSPRINT(("T %d entries, last %s, again %d\n", count, last, again));
}

static void
Modes()
{
    struct stat file, folder, open_file;
    stat(FOLDER "hello.txt", &file);
    stat("/MS/OPEN-R/MW/DATA/P", &folder);
    const int descriptor = open(FOLDER "HELLO.TXT", O_RDONLY);
    fstat(descriptor, &open_file);
    close(descriptor);
    OSYSPRINT(("T file %o %d folder %o fstat %o time %d\n", (int)file.st_mode, (int)file.st_size, (int)folder.st_mode,
               (int)open_file.st_mode, (int)file.st_mtime));
}

// Does what an FTP server does with each entry of a folder.
static void
Dots()
{
    struct stat self, parent, file;
    stat("/MS/OPEN-R/MW/DATA/P/.", &self);
    stat("/MS/OPEN-R/MW/DATA/P/..", &parent);
    stat("/MS/OPEN-R/MW/CONF/../DATA/./P/HELLO.TXT", &file);
    OSYSPRINT(("T . %o .. %o file %d around the stick %d\n", (int)self.st_mode, (int)parent.st_mode, (int)file.st_size,
               stat("/MS/..", &file)));
}

static void
Signals()
{
    const bool is_refused = signal(SIGTERM, SIG_IGN) == SIG_ERR;
    OSYSPRINT(("T raise %d kill %d getpid %d signal %d fcntl %d\n", raise(SIGTERM), kill(0, SIGTERM), (int)getpid(),
               is_refused, fcntl(0, F_GETFD)));
}

static void
ManageFiles()
{
    const int made = mkdir(FOLDER "NEW", 0);
    const int renamed = rename(FOLDER "HELLO.TXT", FOLDER "new/hi.txt");
    const int folder_renamed = rename(FOLDER "NEW", FOLDER "OLD");
    std::ifstream file(FOLDER "old/HI.TXT");
    std::string text;
    std::getline(file, text);
    file.close();
    const int not_empty = rmdir(FOLDER "OLD");
    const int removed = remove(FOLDER "OLD/HI.TXT");
    const int gone = rmdir(FOLDER "OLD");
    OSYSPRINT(("T %d %d %d '%s' %d %d %d\n", made, renamed, folder_renamed, text.c_str(), not_empty, removed, gone));
}

static void
Flags()
{
    const int created = open(FOLDER "FLAGS.TXT", O_WRONLY | O_CREAT | O_EXCL, 0);
    const int written = (int)write(created, "one", 3);
    close(created);
    const int exclusive = open(FOLDER "FLAGS.TXT", O_WRONLY | O_CREAT | O_EXCL, 0);
    const int appended = open(FOLDER "flags.txt", O_WRONLY | O_APPEND);
    write(appended, "two", 3);
    close(appended);
    char text[8] = "";
    const int read_back = open(FOLDER "FLAGS.TXT", O_RDONLY);
    lseek(read_back, 1, SEEK_SET);
    read(read_back, text, 7);
    close(read_back);
    OSYSPRINT(("T created %d wrote %d exclusive %d text %s\n", created >= 0, written, exclusive, text));
}

static void
Truncates()
{
    const int emptied = open(FOLDER "HELLO.TXT", O_RDONLY | O_TRUNC);
    if (emptied >= 0) close(emptied);
    OSYSPRINT(("T truncates %d\n", emptied >= 0));
}

// Uses descriptors that no object has opened.  Some of them are files of the test.
static void
UseForeignDescriptors()
{
    int used = 0;
    struct stat status;
    char byte;
    for (int i = 3; i < 100; i++) {
        if (write(i, "harm", 4) >= 0) used++;
        if (lseek(i, 0, SEEK_SET) >= 0) used++;
        if (read(i, &byte, 1) >= 0) used++;
        if (fstat(i, &status) >= 0) used++;
        if (close(i) >= 0) used++;
    }
    const int wrong = write(50, "harm", 4) < 0 ? errno : 0;
    OSYSPRINT(("T used %d errno %d cut %d\n", used, wrong == EBADF, ftruncate(3, 0)));
}

static void
SeekFar()
{
    const int file = open(FOLDER "FAR.TXT", O_RDWR | O_CREAT, 0);
    const long near_end = (long)lseek(file, 1 << 20, SEEK_SET);
    const long far = (long)lseek(file, 1L << 40, SEEK_SET);
    const int is_too_large = errno == EFBIG;
    const long place = (long)lseek(file, 0, SEEK_CUR);
    close(file);
    FILE* const stream = fopen(FOLDER "FAR.TXT", "w");
    const int stream_far = fseek(stream, 0x7fffffff, SEEK_SET);
    OSYSPRINT(("T near %ld far %ld %d place %ld stream %d %ld\n", near_end, far, is_too_large, place, stream_far,
               ftell(stream)));
    fclose(stream);
}

static int OnlyFiles(const struct dirent* entry) { return entry->d_name[0] != '.'; }

static void
Scan()
{
    struct dirent** list = 0;
    const int outside = scandir("/", &list, 0, alphasort);
    const int count = scandir(FOLDER "MANY", &list, OnlyFiles, alphasort);
    OSYSPRINT(("T outside %d entries %d first %s\n", outside, count, count > 0 ? list[0]->d_name : "-"));
    for (int i = 0; i < count; i++) free(list[i]);
    free(list);
}

static void
UseFilesOfTheHost()
{
    const int opened = openat(AT_FDCWD, "/etc/passwd", O_RDONLY);
    const int linked = linkat(AT_FDCWD, "/etc/passwd", AT_FDCWD, FOLDER "LINK.TXT", 0);
    OSYSPRINT(("T openat %d linkat %d mkfifo %d realpath %d\n", opened, linked, mkfifo(FOLDER "FIFO", 0600),
               realpath("/etc", 0) != 0));
}

static void
UseOtherNames()
{
    int            status = 0;
    DIR* const     folder = opendir(FOLDER);
    struct dirent  entry;
    struct dirent* next   = 0;
    const int      moved  = fchdir(0);
    const int      waited = waitpid(-1, &status, 0);
    const int      paused = pause();
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
    const int read = readdir_r(folder, &entry, &next);
#pragma GCC diagnostic pop
    OSYSPRINT(("T fchdir %d waitpid %d pause %d readdir_r %d\n", moved, waited, paused, read == ENOSYS));
    closedir(folder);
}

static void
PollDescriptors()
{
    struct pollfd file = { open(FOLDER "IN.TXT", O_RDONLY), POLLIN, 0 };
    struct pollfd console = { 0, POLLIN, 0 };
    struct pollfd foreign = { 600, POLLIN, 0 };
    const int     a = poll(&file, 1, 0), b = poll(&console, 1, 0), c = poll(&foreign, 1, 0);
    OSYSPRINT(("T file %d %d console %d %d foreign %d %d\n", a, file.revents == POLLIN, b, console.revents, c,
               foreign.revents == POLLNVAL));
    close(file.fd);
}

static void
UseLongNames()
{
    const std::string name = FOLDER + std::string(5000, 'A'), part = FOLDER + std::string(300, 'A');
    FILE* const file = fopen(name.c_str(), "w");
    const int why = errno;
    const int made = mkdir(name.c_str(), 0);
    FILE* const short_path = fopen(part.c_str(), "w");
    OSYSPRINT(("T file %d %d folder %d part %d %d\n", file != 0, why == ENAMETOOLONG, made, short_path != 0,
               errno == ENAMETOOLONG));
}

static void Never() { OSYSPRINT(("T atexit ran\n")); }

static void
Refused()
{
    const int ran = system("echo harm");
    FILE* const temporary = tmpfile();
    const int moved = chdir("/");
    OSYSPRINT(("T system %d tmpfile %d chdir %d fork %d\n", ran, temporary != 0, moved, (int)fork()));
}

// Calls functions that start programs, end or stop the process, or send it signals.
static void
RefusedKin()
{
    char* arguments[] = {const_cast<char*>("/bin/true"), 0};
    pid_t process = 0;
    int ends[2];
    timer_t timer;
    sigset_t signals;
    struct itimerval soon = {{0, 0}, {0, 1000}};
    sigfillset(&signals);
    OSYSPRINT(("T execl %d execlp %d execle %d execvpe %d vfork %d\n", execl("/bin/true", "true", (char*)0),
               execlp("true", "true", (char*)0), execle("/bin/true", "true", (char*)0, arguments + 1),
               execvpe("true", arguments, arguments + 1), (int)vfork()));
    OSYSPRINT(("T spawn %d %d\n", posix_spawn(&process, "/bin/true", 0, 0, arguments, arguments + 1) != 0,
               posix_spawnp(&process, "true", 0, 0, arguments, arguments + 1) != 0));
    OSYSPRINT(("T timers %d %d masks %d %d\n", setitimer(ITIMER_REAL, &soon, 0), timer_create(CLOCK_REALTIME, 0, &timer),
               sigprocmask(SIG_BLOCK, &signals, 0), pthread_sigmask(SIG_BLOCK, &signals, 0) != 0));
    OSYSPRINT(("T dup3 %d pipe2 %d socketpair %d cancel %d\n", dup3(1, 9, 0), pipe2(ends, 0),
               socketpair(AF_UNIX, SOCK_STREAM, 0, ends), pthread_cancel(pthread_self()) != 0));
}

static void
Clocks()
{
    struct timeval now;
    gettimeofday(&now, 0);
    OSYSPRINT(("T time %d us %d same %d\n", (int)now.tv_sec, (int)now.tv_usec, (int)time(0) == (int)now.tv_sec));
}

static void
Sleeps()
{
    struct timespec second = {1, 0};
    const int slept = (int)sleep(1);
    const int slept_us = usleep(1000);
    OSYSPRINT(("T sleep %d usleep %d nanosleep %d\n", slept, slept_us, nanosleep(&second, 0)));
    struct timeval time = {1, 0};
    const int polled = poll(0, 0, 1000);
    const int selected = select(0, 0, 0, 0, &time);
    OSYSPRINT(("T poll %d select %d clock_nanosleep %d\n", polled, selected,
               clock_nanosleep(CLOCK_REALTIME, 0, &second, 0)));
}

static void* Work(void*) { return 0; }

static void
Threads()
{
    pthread_t thread;
    const int failed = pthread_create(&thread, 0, Work, 0) != 0;
    OSYSPRINT(("T pthread_create failed %d\n", failed));
}

static void
Reopens()
{
    FILE* const file = fopen("/MS/OPEN-R/MW/DATA/P/A.TXT", "w");
    FILE* const other = fopen("/MS/OPEN-R/MW/DATA/P/B.TXT", "w");
    FILE* const terminal = freopen("/MS/OPEN-R/MW/DATA/P/C.TXT", "w", stdout);
    FILE* const refused = freopen("/MS/OPEN-R/MW/DATA/P/B.TXT", "w", file);
    FILE* const again = freopen("/MS/OPEN-R/MW/DATA/P/A.TXT", "w", other);
    OSYSPRINT(("T freopen terminal %d open %d free %d\n", terminal != 0, refused != 0, again == other));
    fclose(other);
}

static void
CloseTerminal()
{
    const int in = fclose(stdin);
    const int out = fclose(stdout);
    OSYSPRINT(("T close terminal %d %d\n", in, out));
}

static bool
ConsoleCommand(const std::string& command)
{
    char line[80] = "";
    int a = 0, b = 0;
    std::string word, rest;
    if (command == "gets") {
        OSYSPRINT(("T gets '%s'\n", gets(line)));
    } else if (command == "fgets") {
        fgets(line, sizeof line, stdin);
        OSYSPRINT(("T fgets '%s'\n", line));
    } else if (command == "getchar") {
        a = getchar();
        b = getc(stdin);
        OSYSPRINT(("T getchar %c%c\n", a, b));
    } else if (command == "scanf") {
        const int count = scanf("%d %d", &a, &b);
        OSYSPRINT(("T scanf %d: %d %d\n", count, a, b));
    } else if (command == "cin") {
        std::cin >> word >> a;
        std::getline(std::cin, rest);
        OSYSPRINT(("T cin '%s' %d '%s'\n", word.c_str(), a, rest.c_str()));
    } else if (command == "read") {
        a = (int)read(0, line, sizeof line);
        OSYSPRINT(("T read %d\n", a));
    } else if (command == "isatty") {
        OSYSPRINT(("T isatty %d %d %d %d\n", isatty(0), isatty(1), isatty(2), isatty(7)));
    } else {
        return false;
    }
    return true;
}

bool
FileCommand(const std::string& command)
{
    if (ConsoleCommand(command)) return true;
    if (command == "read read") {
        OSYSPRINT(("T %s\n", OpenTwice("r", "r")));
    } else if (command == "read write") {
        OSYSPRINT(("T %s\n", OpenTwice("r", "a")));
    } else if (command == "write read") {
        OSYSPRINT(("T %s\n", OpenTwice("a", "r")));
    } else if (command == "leave open") {
        OSYSPRINT(("T %d\n", fopen(FOLDER "HELLO.TXT", "a") != 0));
    } else if (command == "long name") {
        errno = 0;
        FILE* file = fopen(FOLDER "LONGERTHAN8.TXT", "w");
        OSYSPRINT(("T long name %s\n", file == 0 ? "refused" : "taken"));
        if (file != 0) fclose(file);
    } else if (command == "modes") {
        Modes();
    } else if (command == "manage") {
        ManageFiles();
    } else if (command == "flags") {
        Flags();
    } else if (command == "foreign") {
        UseForeignDescriptors();
    } else if (command == "seeks") {
        SeekFar();
    } else if (command == "scan") {
        Scan();
    } else if (command == "host") {
        UseFilesOfTheHost();
    } else if (command == "other names") {
        UseOtherNames();
    } else if (command == "poll") {
        PollDescriptors();
    } else if (command == "long names") {
        UseLongNames();
    } else if (command == "truncates") {
        Truncates();
    } else if (command == "writes") {
        WriteInAllWays();
    } else if (command == "leaves") {
        LeaveStreams();
    } else if (command == "list") {
        List(FOLDER "MANY");
    } else if (command == "refused") {
        Refused();
    } else if (command == "refused kin") {
        RefusedKin();
    } else if (command == "signals") {
        Signals();
    } else if (command == "dots") {
        Dots();
    } else if (command == "clocks") {
        Clocks();
    } else if (command == "sleep") {
        Sleeps();
    } else if (command == "thread") {
        Threads();
    } else if (command == "freopen") {
        Reopens();
    } else if (command == "close terminal") {
        CloseTerminal();
    } else if (command == "atexit") {
        OSYSPRINT(("T atexit %d\n", atexit(Never)));
    } else if (command == "exit") {
        exit(1);
    } else if (command == "_exit") {
        _exit(0);
    } else if (command == "_Exit") {
        _Exit(0);
    } else if (command == "quick_exit") {
        quick_exit(0);
    } else if (command == "pthread_exit") {
        pthread_exit(0);
    } else if (command == "abort") {
        abort();
    } else if (command == "assert 0") {
        assert(command.empty());
    } else {
        return false;
    }
    return true;
}
