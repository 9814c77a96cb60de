// Many workers: a ring of objects, each in a worker of its own, and several such runs on one host
// and in one DDS domain.
#include <fmt/format.h>

#include "tests/distribution/same_run.h"

namespace openr_host {
namespace {

void Replace(const std::string& from, const std::string& to, std::string* bytes) {
  for (size_t at = 0; (at = bytes->find(from, at)) != std::string::npos; at += to.size())
    bytes->replace(at, from.size(), to);
}

// Discovery is slow on a machine that compiles at the same time.
const Words kPatiently = {"--join-wait", "110s"};

class ManyTest : public testing::Test {
 protected:
  static std::string Name(int i, int count) { return fmt::format("Passer{:02}", i % count); }

  // Makes a stick with `count` objects of one image, whose names have the same length.
  void MakeRing(int count) {
    const ScratchFolder source;
    std::filesystem::copy_file(std::string(OPENR_IMAGES) + "/PASSER00.BIN", source.File("image"));
    const std::string image = source.Read("image");
    std::string list, wiring;
    for (int i = 0; i < count; ++i) {
      const std::string name = Name(i, count);
      const std::string file = fmt::format("PASSER{:02}.BIN", i);
      std::string bytes = image;
      Replace("Passer00", name, &bytes);
      stick.Write("OPEN-R/MW/OBJS/" + file, bytes);
      list += "/MS/OPEN-R/MW/OBJS/" + file + "\n";
      wiring += fmt::format("{}.Out.Number.S {}.In.Number.O\n", name, Name(i + 1, count));
      wiring += fmt::format(
          "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S {}.Sensor.OSensorFrameVectorData.O\n",
          name);
      objects.push_back(name);
    }
    stick.Write("OPEN-R/MW/CONF/OBJECT.CFG", list);
    stick.Write("OPEN-R/MW/CONF/CONNECT.CFG", wiring);
  }
  Words Flags(const std::string& duration) const {
    return {"--stick", stick.path(), "--body", "ideal", "--for", duration};
  }

  const ScratchFolder stick;
  Words objects;
};

TEST_F(ManyTest, ThirtyTwoParticipantsAreOneRun) {
  MakeRing(31);
  const RecordedRun one = Record(Flags("300ms"));
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_GT(one.report.value("messages", 0), 8000);
  const RecordedRun many = Record(Flags("300ms") + kPatiently + Isolated(objects));
  ExpectSame(one, many);
  ASSERT_EQ(many.report["processes"].size(), 31u);
  for (const json& process : many.report["processes"])
    EXPECT_GT(process["handlers"], 200) << process;
}

TEST_F(ManyTest, ThreeRunsAtTheSameTimeDoNotHearEachOther) {
  MakeRing(4);
  const Words flags = kQuickly + Flags("1s");
  const RecordedRun one = Record(Flags("1s"));
  const ScratchFolder folder;
  std::vector<std::unique_ptr<ProgramRun>> runs;
  for (const char* name : {"a", "b", "c"}) {
    runs.push_back(std::make_unique<ProgramRun>(flags + kPatiently + Isolated(objects) +
                                                Words{"--record", folder.File(name)}));
  }
  for (size_t i = 0; i < runs.size(); ++i) {
    const ProgramResult& result = runs[i]->Finish();
    ExpectSame(one, {result.status, result.err, folder.Read(std::string(1, "abc"[i])),
                     json::parse(result.out, nullptr, false)});
  }
}

}  // namespace
}  // namespace openr_host
