// core.md section 8.1 and field-notes.md section 13: files and the C library, as an object built
// from a stub.cfg meets them.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include "runtime/core/write_errors.h"
#include "tests/conformance/conform_fixture.h"

namespace openr_host {
namespace {

class FilesConformance : public ConformTest {};

// While it exists, files of this process have at most `bytes` bytes.
class SmallFiles {
 public:
  explicit SmallFiles(rlim_t bytes) : handler_(signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFiles() {
    setrlimit(RLIMIT_FSIZE, &before_);
    signal(SIGXFSZ, handler_);
  }
  SmallFiles(const SmallFiles&) = delete;
  SmallFiles& operator=(const SmallFiles&) = delete;

 private:
  rlimit before_{};
  const sighandler_t handler_;
};

// The finding about a file of DATA/P whose bytes a limit for the size of files has refused.
std::string Lost(const char* name) {
  return fmt::format(
      "/MS/OPEN-R/MW/DATA/P/{}.TXT: not all bytes that were written are in the file: File too "
      "large\n",
      name);
}

TEST_F(FilesConformance, AFileCanBeOpenTwiceOnlyIfAllReadIt) {
  Start();
  EXPECT_EQ(Answer("read read"), "T both open\n");
  EXPECT_EQ(Answer("read write"), "T second refused\n");
  EXPECT_EQ(Answer("write read"), "T second refused\n");
  EXPECT_TRUE(Found("HELLO.TXT is refused: teller has it open already")) << Findings();
  EXPECT_EQ(Answer("leave open"), "T 1\n");
  EXPECT_EQ(Answer("read read"), "T first refused\n");
}

TEST_F(FilesConformance, AFifoCannotBeOpenedAndIsNotListed) {
  const std::filesystem::path data = root / "OPEN-R/MW/DATA/P";
  std::filesystem::remove(data / "HELLO.TXT");
  ASSERT_EQ(mkfifo((data / "HELLO.TXT").c_str(), 0600), 0);
  std::filesystem::create_directory(data / "MANY");
  ASSERT_EQ(mkfifo((data / "MANY/PIPE.TXT").c_str(), 0600), 0);
  Data("MANY/A.TXT", "a");
  Start();
  EXPECT_TRUE(
      Found("/MS/OPEN-R/MW/DATA/P/HELLO.TXT (and 1 more on this stick) is neither a file "
            "nor a folder"))
      << Findings();
  EXPECT_EQ(Answer("read read"), "T first refused\n");
  EXPECT_EQ(Answer("write read"), "T first refused\n");
  EXPECT_EQ(Answer("list"), "T 1 entries, last A.TXT, again 1\n");
}

TEST_F(FilesConformance, ANameBeyond8And3IsReportedAndRefusedWhenStrict) {
  Start();
  EXPECT_EQ(Answer("long name"), "T long name taken\n");
  EXPECT_TRUE(Found("'LONGERTHAN8.TXT' is not an 8.3 name")) << Findings();
  Start({.strict = true});
  EXPECT_FALSE(system->findings().HasError());
  EXPECT_EQ(Answer("long name"), "T long name refused\n");
  EXPECT_TRUE(system->findings().HasError());
}

TEST_F(FilesConformance, StatTellsSizeAndMode0777Only) {
  Start();
  EXPECT_EQ(Answer("modes"), "T file 100777 11 folder 40777 fstat 100777 time 0\n");
}

TEST_F(FilesConformance, FilesAndFoldersAreMadeRenamedAndRemovedInAnyCase) {
  Start();
  EXPECT_EQ(Answer("manage"), "T 0 0 0 'hello stick' -1 0 0\n");
  EXPECT_FALSE(std::filesystem::exists(root / "OPEN-R/MW/DATA/P/OLD"));
}

TEST_F(FilesConformance, OpenKnowsCreateExclusiveAndAppend) {
  Start();
  EXPECT_EQ(Answer("flags"), "T created 1 wrote 3 exclusive -1 text netwo\n");
}

TEST_F(FilesConformance, ReaddirShows682EntriesWithUpperCaseNames) {
  std::filesystem::create_directories(root / "OPEN-R/MW/DATA/P/MANY");
  for (int i = 0; i < 700; ++i) Data(fmt::format("MANY/f{:03}.txt", i), "x");
  Data("MANY/a name that is too long.txt", "x");
  Start();
  EXPECT_EQ(Answer("list"), "T 680 entries, last F679.TXT, again 1\n");  // and . and ..
  EXPECT_TRUE(Found("files whose names are not 8.3 are left out")) << Findings();
  EXPECT_TRUE(Found("readdir() shows the first 682")) << Findings();
}

TEST_F(FilesConformance, TheFolderItselfAndTheOneAroundItCanBeAskedFor) {
  Start();
  EXPECT_EQ(Answer("dots"), "T . 40777 .. 40777 file 11 around the stick -1\n");
  EXPECT_EQ(Findings(), "");
}

TEST_F(FilesConformance, AWriteProtectedStickRefusesWritersAndSaysSo) {
  Start();
  EXPECT_EQ(Answer("status"), "T stick 2 design ERS-210\n");
  stick->set_writable(false);
  EXPECT_EQ(Answer("status"), "T stick 1 design ERS-210\n");
  EXPECT_EQ(Answer("flags"), "T created 0 wrote -1 exclusive -1 text \n");
}

TEST_F(FilesConformance, AWriteProtectedStickKeepsAFileThatIsOpenedWithTruncOnly) {
  Start();
  stick->set_writable(false);
  EXPECT_EQ(Answer("truncates"), "T truncates 0\n");
  EXPECT_EQ(std::filesystem::file_size(root / "OPEN-R/MW/DATA/P/HELLO.TXT"), 11u);
  EXPECT_TRUE(Found("HELLO.TXT cannot be written: the stick is write-protected")) << Findings();
}

// binary.md 4.2: errno is 30.
TEST_F(FilesConformance, AWriteProtectedStickIsNamedForEachFileThatIsNotWritten) {
  Data("STAY.TXT", "stay");
  Start();
  stick->set_writable(false);
  EXPECT_EQ(Answer("writes"),
            "W stick 1\n"
            "W stdio fopen 0/30\n"
            "W descriptor open 0/30\n"
            "W ofstream open 0 good 0\n"
            "W folders mkdir -1/30 remove -1/2 rename -1/30\n");
  for (const char* const name : {"STDIO", "CLOSE", "OPEN", "STREAM", "STAY"}) {
    EXPECT_TRUE(
        Found(fmt::format("/MS/OPEN-R/MW/DATA/P/{}.TXT cannot be written: the stick is "
                          "write-protected",
                          name)))
        << name << ": " << Findings();
  }
}

// A limit for the size of files of this process stands for a full disk, which has another errno.
TEST_F(FilesConformance, BytesThatTheStickDoesNotTakeAreReportedOnceForEachFile) {
  Data("STAY.TXT", "stay");
  Start();
  EXPECT_EQ(Answer("writes"),
            "W stick 2\n"
            "W stdio fopen 1 fwrite all fflush 0 fclose 0\n"
            "W close fputs 1 fclose 0\n"
            "W descriptor open 1 write 6000 close 0\n"
            "W ofstream open 1 good 1\n"
            "W folders mkdir 0 remove 0 rename 0\n");
  EXPECT_EQ(Findings(), "");
  Data("STAY.TXT", "stay");
  std::string said;
  {
    const SmallFiles small(0);
    said = Answer("writes");
  }
  EXPECT_EQ(said,
            "W stick 2\n"
            "W stdio fopen 1 fwrite -1/27 fflush 0 fclose 0\n"
            "W close fputs 1 fclose -1/27\n"
            "W descriptor open 1 write -1/27 close 0\n"
            "W ofstream open 1 good 0\n"
            "W folders mkdir 0 remove 0 rename 0\n");
  EXPECT_EQ(Findings(), Lost("STDIO") + Lost("CLOSE") + Lost("OPEN") + Lost("STREAM"));
}

// The streams have forgotten their error, or are never closed.  clearerr() reports only on a disk
// that is full, so only tests/fault/bad_sticks.py tests it.
TEST_F(FilesConformance, BytesOfAStreamThatForgetsItsErrorsAreReportedToo) {
  Start();
  Object* const teller = system->FindObject(0, "teller");
  ASSERT_NE(teller, nullptr);
  {
    const SmallFiles small(0);
    Answer("leaves");
    EXPECT_EQ(Findings(), Lost("REWIND") + Lost("REOPEN"));
    FlushStreams(teller);  // as at the end of a run
    FlushStreams(teller);
  }
  EXPECT_EQ(Findings(), Lost("REWIND") + Lost("REOPEN") + Lost("LEFT"));
}

TEST_F(FilesConformance, StreamsThatAreLeftOpenOnAGoodDiskAreNoFindings) {
  Start();
  Answer("leaves");
  for (const auto& object : system->objects()) FlushStreams(object.get());
  EXPECT_EQ(Findings(), "");
}

TEST_F(FilesConformance, CallsThatTheRobotLacksFailAndAreReported) {
  Start();
  EXPECT_EQ(Answer("refused"), "T system -1 tmpfile 0 chdir -1 fork -1\n");
  EXPECT_EQ(Answer("signals"), "T raise -1 kill -1 getpid -1 signal 1 fcntl -1\n");
  EXPECT_TRUE(Found("raise() fails: there is no such thing on the robot")) << Findings();
  EXPECT_TRUE(Found("system() fails: there is no such thing on the robot")) << Findings();
}

TEST_F(FilesConformance, ADescriptorThatNoObjectHasOpenedIsRefusedAndReported) {
  Start();
  const std::string file = root / "RECORDING";
  const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  ASSERT_GE(descriptor, 3);
  EXPECT_EQ(Answer("foreign"), "T used 0 errno 1 cut -1\n");
  EXPECT_EQ(std::filesystem::file_size(file), 0u);
  EXPECT_EQ(close(descriptor), 0);
  for (const char* const name : {"write", "lseek", "read", "fstat", "close"}) {
    const std::string line = fmt::format("\n{}() fails: no object of this robot has a file", name);
    EXPECT_NE(("\n" + Findings()).find(line), std::string::npos) << name << ": " << Findings();
  }
  EXPECT_TRUE(Found("ftruncate() fails: there is no such thing on the robot")) << Findings();
}

TEST_F(FilesConformance, AFileIsNotLargerThanAMemoryStick) {
  Start();
  EXPECT_EQ(Answer("seeks"), "T near 1048576 far -1 1 place 1048576 stream -1 0\n");
  EXPECT_TRUE(
      Found("FAR.TXT: lseek() to byte 1099511627776 fails: the largest Memory Stick has "
            "134217728 bytes"))
      << Findings();
  EXPECT_TRUE(Found("FAR.TXT: fseek() to byte 2147483647 fails")) << Findings();
}

TEST_F(FilesConformance, ScandirShowsFoldersOfTheStickOnly) {
  std::filesystem::create_directories(root / "OPEN-R/MW/DATA/P/MANY");
  Data("MANY/b.txt", "x");
  Data("MANY/a.txt", "x");
  Start();
  EXPECT_EQ(Answer("scan"), "T outside -1 entries 2 first A.TXT\n");
}

TEST_F(FilesConformance, OtherFileFunctionsDoNotReachFilesOfTheHost) {
  Start();
  EXPECT_EQ(Answer("host"), "T openat -1 linkat -1 mkfifo -1 realpath 0\n");
  for (const char* const name : {"openat", "linkat", "mkfifo", "realpath"}) {
    EXPECT_TRUE(Found(fmt::format("{}() fails: there is no such thing on the robot", name)))
        << name << ": " << Findings();
  }
}

TEST_F(FilesConformance, TheirOtherNamesDoNotEither) {
  Start();
  EXPECT_EQ(Answer("other names"), "T fchdir -1 waitpid -1 pause -1 readdir_r 1\n");
  for (const char* const name : {"fchdir", "waitpid", "pause", "readdir_r"}) {
    EXPECT_TRUE(Found(fmt::format("{}() fails: there is no such thing on the robot", name)))
        << name << ": " << Findings();
  }
}

TEST_F(FilesConformance, APollThatDoesNotWaitSeesFilesOfTheStickOnly) {
  Data("IN.TXT", "x");
  Start();
  EXPECT_EQ(Answer("poll"), "T file 1 1 console 0 0 foreign 1 1\n");
  EXPECT_TRUE(Found("poll() fails: no object of this robot has a file")) << Findings();
}

TEST_F(FilesConformance, APathThatIsTooLongIsRefused) {
  Start();
  EXPECT_EQ(Answer("long names"), "T file 0 1 folder -1 part 0 1\n");
  EXPECT_TRUE(Found("a path of 5021 characters names no file of the stick")) << Findings();
}

TEST_F(FilesConformance, TheirKinFailsToo) {
  Start();
  const std::string answer = Answer("refused kin");
  EXPECT_NE(answer.find("T execl -1 execlp -1 execle -1 execvpe -1 vfork -1\n"), std::string::npos);
  EXPECT_NE(answer.find("T spawn 1 1\n"), std::string::npos);
  EXPECT_NE(answer.find("T timers -1 -1 masks -1 1\n"), std::string::npos);
  std::vector<std::string> names = {
      "execl",      "execlp",       "execle",       "execvpe",         "vfork",
      "setitimer",  "timer_create", "sigprocmask",  "pthread_sigmask", "dup3",
      "socketpair", "posix_spawn",  "posix_spawnp", "pthread_cancel"};
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // they may call pipe2()
  EXPECT_NE(answer.find("T dup3 -1 pipe2 -1 socketpair -1 cancel 1\n"), std::string::npos);
  names.push_back("pipe2");
#endif
  for (const std::string& name : names)
    EXPECT_TRUE(Found(fmt::format("{}() fails: there is no such thing", name))) << Findings();
}

TEST_F(FilesConformance, ClocksShowVirtualTime) {
  Start();
  system->RunUntil(2'500'000);
  EXPECT_EQ(Answer("clocks"), "T time 946684802 us 500000 same 1\n");  // 2000-01-01 + 2.5 s
}

// field-notes.md, 12.1
TEST_F(FilesConformance, SleepingDoesNothingAndIsReported) {
  Start();
  EXPECT_EQ(Answer("sleep"),
            "T sleep 0 usleep 0 nanosleep 0\nT poll 0 select 0 clock_nanosleep 0\n");
  for (const char* const name :
       {"sleep", "usleep", "nanosleep", "poll", "select", "clock_nanosleep"}) {
    // The line break keeps usleep() from being taken for sleep().
    const std::string line = fmt::format("\n{}() does nothing: the robot has no sleep", name);
    EXPECT_NE(("\n" + Findings()).find(line), std::string::npos) << name << ": " << Findings();
  }
}

#if !defined(__SANITIZE_THREAD__)
// field-notes.md, 1.11
TEST_F(FilesConformance, AThreadIsRefusedAndReported) {
  Start();
  EXPECT_EQ(Answer("thread"), "T pthread_create failed 1\n");
  EXPECT_TRUE(
      Found("pthread_create() fails: the robot has no threads: an object does one thing at "
            "a time; do a piece of the work for each message"))
      << Findings();
}
#endif

TEST_F(FilesConformance, FreopenOpensWhatFopenWouldOpen) {
  Start();
  EXPECT_EQ(Answer("freopen"), "T freopen terminal 0 open 0 free 1\n");
  EXPECT_NE(Findings().find("of a stream of the terminal fails"), std::string::npos) << Findings();
}

TEST_F(FilesConformance, FcloseLeavesTheTerminalOpenBecauseAllObjectsShareIt) {
  Start();
  const bool has_input = fcntl(STDIN_FILENO, F_GETFD) != -1;
  EXPECT_EQ(Answer("close terminal"), "T close terminal 0 0\n");
  EXPECT_EQ(fcntl(STDIN_FILENO, F_GETFD) != -1, has_input);
  EXPECT_NE(fcntl(STDOUT_FILENO, F_GETFD), -1);
}

TEST_F(FilesConformance, DesignDataAreCopiesThatCanBeDeletedOnce) {
  Config("DESIGNDB.CFG",
         "HELLO /MS/OPEN-R/MW/DATA/P/HELLO.TXT\nEMPTY /MS/OPEN-R/MW/DATA/P/E.TXT\n");
  Data("E.TXT", "");
  Start();
  EXPECT_EQ(Answer("design HELLO"), "T design 0 size 11 'hello' copies 1 1 delete 0 0 4\n");
  EXPECT_EQ(Answer("design EMPTY"), "T design 4110 size 0\n");  // oDESIGNDATA_SIZE_ZERO
  EXPECT_EQ(Answer("design NOTHING"), "T design 6 size 0\n");   // oNOT_FOUND
  EXPECT_EQ(Answer("design SYS_CPUINFO").substr(0, 19), "T design 0 size 256");
}

// core.md 6.1; 10.1 18
TEST_F(FilesConformance, DesignDataAreDeliveredDecompressed) {
  Config("DESIGNDB.CFG", "HELLO /MS/OPEN-R/MW/DATA/P/HELLO.GZ\n");
  const gzFile file = gzopen((root / "OPEN-R/MW/DATA/P/HELLO.GZ").c_str(), "wb");
  gzputs(file, "hello once more");
  gzclose(file);
  Start();
  EXPECT_EQ(Answer("design HELLO"), "T design 0 size 15 'hello' copies 1 1 delete 0 0 4\n");
}

// core.md 3.2
TEST_F(FilesConformance, ConsoleTextsAreCutAt243BytesAndLogLinesCarryIdAndPriority) {
  Start();
  const std::string text(242, 'a');
  EXPECT_EQ(Answer("log"), text + "|\n[oid:80000043,prio:1] " + text +
                               "\n[oid:80000043,prio:2] This is a warning!\n");
}

}  // namespace
}  // namespace openr_host
