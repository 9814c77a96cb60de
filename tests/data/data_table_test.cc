// Tables for charts: read from CSV and MCAP, refused when they are wrong, made into charts.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

#include "openr/data/mcap_writer.h"
#include "openr/data/quantity_unit.h"
#include "openr/data/table.h"
#include "openr/data/table_chart.h"
#include "tests/openr/program_run.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using chart::Chart;
using testing::ElementsAre;
using testing::HasSubstr;

std::string ErrorOfCsv(const std::string& text) {
  try {
    ReadCsvTable("run.csv", text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

// A file with two messages of one topic in two chunks.
std::string SmallMcap() {
  std::string bytes;
  McapWriter writer("test", [&bytes](std::string_view more) { bytes += more; });
  const uint16_t schema = writer.AddSchema("openr.joint", "{\"type\":\"object\"}");
  const uint16_t joint = writer.AddChannel("/aibo/joint", schema);
  const uint16_t base = writer.AddChannel("/aibo1/base", schema);
  writer.Add(joint, 8000, "{\"timestamp\":{\"sec\":0,\"nsec\":8000000},\"LF_j1\":1.5}");
  writer.Add(base, 8000, "{\"x_m\":0.25}");
  writer.EndChunk();
  writer.Add(joint, 16000, "{\"LF_j1\":2.5}");
  writer.Finish();
  return bytes;
}

TEST(CsvTableTest, InfinityIsNoValueAndNoTime) {
  const Table table = ReadCsvTable("run.csv", "time_s,a\n0,inf\n1,2\n2,-inf\n");
  ASSERT_EQ(table.series.size(), 1U);
  EXPECT_THAT(table.series[0].values, ElementsAre(2));
  EXPECT_THAT(ErrorOfCsv("time_s,a\ninf,1\n"), HasSubstr("'inf' in column time_s is no time"));
}

TEST(CsvTableTest, EmptyFieldsAreNoValuesAndTextIsNoQuantity) {
  const Table table = ReadCsvTable("run.csv", "time_ms,a,\"b,c\",who\n0,,1,dog\n8,2,-1.5e2,dog\n");
  ASSERT_EQ(table.series.size(), 2U);
  EXPECT_EQ(table.series[0].name, "a");
  EXPECT_THAT(table.series[0].time_s, ElementsAre(0.008));
  EXPECT_EQ(table.series[1].name, "b,c");
  EXPECT_THAT(table.series[1].values, ElementsAre(1, -150));
  EXPECT_EQ(table.note, "");
}

TEST(CsvTableTest, MistakesAreNamedWithTheirLine) {
  EXPECT_EQ(ErrorOfCsv(""), "run.csv: is empty");
  EXPECT_THAT(ErrorOfCsv("a,b\n1,2\n"), HasSubstr("run.csv:1: no column time_s"));
  EXPECT_EQ(ErrorOfCsv("time_s,a\n0,1\n1\n"), "run.csv:3: 1 fields, but the first line names 2");
  EXPECT_EQ(ErrorOfCsv("time_s,a"), "run.csv: has one line only, which has no end");
  EXPECT_EQ(ErrorOfCsv("time_s,a\nsoon,1\n"), "run.csv:2: 'soon' in column time_s is no time");
}

TEST(CsvTableTest, ColumnThatBecomesTextIsToldAndLeftOut) {
  const Table table = ReadCsvTable("run.csv", "time_s,a,b\n0,1,2\n1,x,3\n");
  ASSERT_EQ(table.series.size(), 1U);
  EXPECT_EQ(table.series[0].name, "b");
  EXPECT_THAT(table.series[0].values, ElementsAre(2, 3));
  EXPECT_EQ(table.note, "run.csv:3: 'x' in column a is no number; the column is left out");
}

TEST(CsvTableTest, LineThatAKilledRunLeftIsToldAndLeftOut) {
  const Table table = ReadCsvTable("run.csv", "time_s,a\n0,1\n1,2");
  EXPECT_EQ(table.series[0].values.size(), 1U);
  EXPECT_EQ(table.note, "run.csv: the last line has no end and is left out");
}

TEST(McapTableTest, TopicsBecomeTheNamesOfTheirQuantities) {
  const Table table = ReadMcapTable("run.mcap", SmallMcap());
  ASSERT_EQ(table.series.size(), 2U);
  EXPECT_EQ(table.series[0].name, "joint.LF_j1");
  EXPECT_THAT(table.series[0].time_s, ElementsAre(0.008, 0.016));
  EXPECT_THAT(table.series[0].values, ElementsAre(1.5, 2.5));
  EXPECT_EQ(table.series[1].name, "robots[1].x_m");
  EXPECT_EQ(table.note, "");
}

// Wherever the file ends, it is read up to its last whole record.
TEST(TableTest, ReadersTellHowManyBytesTheyHaveRead) {
  std::vector<size_t> counts;
  const OnBytesRead on_read = [&counts](size_t count) { counts.push_back(count); };
  ReadCsvTable("run.csv", "time_s,a\n0,1\n1,2\n", on_read);
  EXPECT_THAT(counts, ElementsAre(13, 17));
  counts.clear();
  const std::string bytes = SmallMcap();
  ReadMcapTable("run.mcap", bytes, on_read);
  ASSERT_GT(counts.size(), 2u);  // the header and two chunks
  EXPECT_TRUE(std::is_sorted(counts.begin(), counts.end()));
  EXPECT_LE(counts.back(), bytes.size());
}

TEST(McapTableTest, FileThatEndsAnywhereIsReadUpToThere) {
  const std::string bytes = SmallMcap();
  size_t most = 0;
  for (size_t size = kMcapMagic.size(); size < bytes.size(); ++size) {
    const Table table = ReadMcapTable("run.mcap", bytes.substr(0, size));
    size_t values = 0;
    for (const Series& series : table.series) values += series.values.size();
    EXPECT_GE(values, most) << size;
    most = values;
  }
  EXPECT_EQ(most, 3U);
  EXPECT_THAT(ReadMcapTable("run.mcap", bytes.substr(0, 60)).note,
              HasSubstr("ends without a summary"));
}

// A record of MCAP: its kind, the size of its content, its content.
std::string McapRecord(McapOp op, const std::string& content) {
  std::string bytes(1, static_cast<char>(op));
  for (int i = 0; i < 8; ++i) bytes += static_cast<char>(content.size() >> (8 * i));
  return bytes + content;
}

std::string McapChunk(const std::string& records) {
  // Times, size, checksum and compression are 0 or empty; then the size of the records.
  std::string content(8 + 8 + 8 + 4 + 4, '\0');
  for (int i = 0; i < 8; ++i) content += static_cast<char>(records.size() >> (8 * i));
  return McapRecord(McapOp::kChunk, content + records);
}

std::string ErrorOfMcap(const std::string& bytes) {
  try {
    ReadMcapTable("run.mcap", bytes);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(McapTableTest, NestedChunkIsRefused) {
  const std::string bytes = std::string(kMcapMagic) + McapChunk(McapChunk(""));
  EXPECT_EQ(ErrorOfMcap(bytes),
            "run.mcap: the record at byte 8 has a chunk within a chunk, which the format forbids");
}

TEST(McapTableTest, DeepObjectsAreRefused) {
  for (const int depth : {33, 1000, 100'000}) {
    std::string bytes, deep;
    for (int i = 0; i < depth; ++i) deep += "{\"a\":";
    deep += "1" + std::string(static_cast<size_t>(depth), '}');
    McapWriter writer("test", [&bytes](std::string_view more) { bytes += more; });
    const uint16_t schema = writer.AddSchema("openr.joint", "{\"type\":\"object\"}");
    writer.Add(writer.AddChannel("/aibo/joint", schema), 8000, deep);
    writer.Finish();
    EXPECT_THAT(ErrorOfMcap(bytes), HasSubstr("has objects within objects, more than 32 deep"));
  }
}

TEST(McapTableTest, DeepListsAndBytesThatAreNoJsonAreLeftOut) {
  const std::string list = std::string(1000, '[') + "7" + std::string(1000, ']');
  std::string bytes;
  McapWriter writer("test", [&bytes](std::string_view more) { bytes += more; });
  const uint16_t schema = writer.AddSchema("other", "{\"type\":\"object\"}");
  const uint16_t channel = writer.AddChannel("/other", schema);
  writer.Add(channel, 8000,
             "{\"a\":1,\"list\":" + list + ",\"b\":{\"list\":" + list + ",\"c\":2}}");
  writer.Add(channel, 16000, "{" + list);
  writer.Add(channel, 24000, list);
  writer.Add(channel, 32000, "{\"a\":3}");
  writer.Finish();
  const Table table = ReadMcapTable("run.mcap", bytes);
  ASSERT_EQ(table.series.size(), 2U);
  EXPECT_EQ(table.series[0].name, "/other.a");
  EXPECT_THAT(table.series[0].values, ElementsAre(1, 3));
  EXPECT_EQ(table.series[1].name, "/other.b.c");
  EXPECT_THAT(table.series[1].values, ElementsAre(2));
}

TEST(McapTableTest, DamagedChunkIsRefused) {
  std::string bytes = SmallMcap();
  bytes[bytes.find("1.5")] = '7';
  try {
    ReadMcapTable("run.mcap", bytes);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("its checksum is wrong"));
  }
}

Table SmallTable() {
  return {{{"command.LF_j1", {0, 1}, {5, 6}},
           {"joint.LF_j1", {0, 1}, {4, 5}},
           {"pitch_deg", {0, 1}, {0, 1}},
           {"sensor.chin", {0, 1}, {0, 1}},
           {"sensor.back", {0, 1}, {0, 1}}},
          ""};
}

std::vector<std::string> PanelsOf(const std::vector<std::string>& wanted) {
  PlotRequest request;
  request.wanted = wanted;
  std::vector<std::string> titles;
  for (const chart::Panel& panel : ChartOf(SmallTable(), request).panels)
    titles.push_back(fmt::format("{} {}", panel.title, panel.curves.size()));
  return titles;
}

// Returns the error of a chart of all quantities of `table` from the time `from_s` on.
std::string ErrorOfChart(const Table& table, double from_s) {
  PlotRequest request;
  request.wanted = {"*"};
  request.from_s = from_s;
  try {
    ChartOf(table, request);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(TableChartTest, AChartWithoutValuesSaysWhetherTheFileHasNone) {
  EXPECT_EQ(ErrorOfChart(ReadCsvTable("run.csv", "time_s,LF_j1,x_m\n"), 0),
            "has names of quantities, but no values");
  EXPECT_EQ(ErrorOfChart(SmallTable(), 2),
            "there are no values in this time, or only numbers above 1e100");
}

TEST(TableChartTest, AnglesOfAJointShareAPanel) {
  EXPECT_THAT(PanelsOf({}), ElementsAre("LF_j1 2"));
  EXPECT_THAT(PanelsOf({"LF_j1", "pitch_deg"}), ElementsAre("LF_j1 2", "pitch_deg 1"));
  EXPECT_THAT(PanelsOf({"joint.LF_j1"}), ElementsAre("joint.LF_j1 1"));
  EXPECT_THAT(PanelsOf({"sensor.*"}), ElementsAre("sensor.chin 1", "sensor.back 1"));
  EXPECT_THAT(PanelsOf({"LF_j*", "b*"}), ElementsAre("LF_j1 2", "sensor.back 1"));
}

TEST(TableChartTest, AnotherRobotsQuantitiesAreNamedWithItsNumber) {
  PlotRequest request;
  request.wanted = {"robots[1].sensor.*"};
  const Chart chart = ChartOf(
      {{{"robots[0].sensor.chin", {0}, {0}}, {"robots[1].sensor.chin", {0}, {1}}}, ""}, request);
  ASSERT_EQ(chart.panels.size(), 1u);
  EXPECT_EQ(chart.panels[0].title, "robots[1].sensor.chin");
}

TEST(TableChartTest, UnknownNamesAndEmptyTimesAreRefused) {
  PlotRequest request;
  request.wanted = {"LF_j9"};
  try {
    ChartOf(SmallTable(), request);
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "there is no 'LF_j9' in it; did you mean 'LF_j1'?; --list shows what there is");
  }
  request.wanted = {"pitch_deg"};
  request.from_s = 5;
  EXPECT_THROW(ChartOf(SmallTable(), request), std::runtime_error);
}

TEST(TableChartTest, ManyPointsAreThinnedAndKeepTheirPeaks) {
  Table table{{{"pitch_deg", {}, {}}}, ""};
  for (int i = 0; i < 100'000; ++i) {
    table.series[0].time_s.push_back(i * 0.008);
    table.series[0].values.push_back(i == 54'321 ? 99 : 0);
  }
  PlotRequest request;
  request.wanted = {"pitch_deg"};
  const Chart chart = ChartOf(table, request);
  const chart::Curve& curve = chart.panels[0].curves[0];
  EXPECT_LT(curve.x.size(), 4000U);
  EXPECT_EQ(*std::max_element(curve.y.begin(), curve.y.end()), 99);
  EXPECT_TRUE(std::is_sorted(curve.x.begin(), curve.x.end()));
}

// Draws one panel for a quantity with the values 0 and `value`.
chart::Panel PanelWith(const std::string& name, double value) {
  PlotRequest request;
  request.wanted = {name};
  return ChartOf({{{name, {0, 1}, {0, value}}}, ""}, request).panels.at(0);
}

struct QuantityInAChart {
  const char* name;
  double in_log;
  const char* unit;
  double in_chart;
};

TEST(TableChartTest, PanelsNameTheUnitOfTheirQuantityWhateverTheSizeOfItsValues) {
  const QuantityInAChart quantities[] = {{"sensor.acceleration_x", -9'806'650, "m/s^2", -9.80665},
                                         {"sensor.acceleration_y", 100, "m/s^2", 1e-4},
                                         {"sensor.head_front", 490'000, "N", 0.49},
                                         {"sensor.head_back", 0, "N", 0},
                                         {"robots[1].sensor.distance", 9'000, "m", 0.009},
                                         {"sensor.temperature", 30'000'000, "deg C", 30},
                                         {"sensor.chin", 1, "", 1},
                                         {"sensor.back_front", 20'000, "", 20'000},
                                         {"joint.LF_j1", 20'000, "deg", 20'000},
                                         {"robots[1].turn_deg_s", 20'000, "deg/s", 20'000},
                                         {"thing.ball.x_m", 20'000, "m", 20'000}};
  for (const QuantityInAChart& quantity : quantities) {
    const chart::Panel panel = PanelWith(quantity.name, quantity.in_log);
    EXPECT_EQ(panel.note, quantity.unit) << quantity.name;
    EXPECT_NEAR(panel.curves.at(0).y.at(1), quantity.in_chart, 1e-9) << quantity.name;
  }
}

TEST(TableChartTest, QuantitiesOfOtherProgramsAreNotConverted) {
  for (const char* const name : {"sensor.nose", "/arm/sensor.distance", "acceleration_x"}) {
    const chart::Panel panel = PanelWith(name, 20'000);
    EXPECT_EQ(panel.note, "") << name;
    EXPECT_EQ(panel.curves.at(0).y.at(1), 20'000) << name;
  }
}

// A quantity that is named twice has two curves in one panel.
TEST(TableChartTest, AllCurvesOfAPanelAreConverted) {
  PlotRequest request;
  request.wanted = {"sensor.distance", "sensor.distance"};
  const Chart chart = ChartOf({{{"sensor.distance", {0}, {500'000}}}, ""}, request);
  ASSERT_EQ(chart.panels.size(), 1U);
  for (const chart::Curve& curve : chart.panels[0].curves) EXPECT_NEAR(curve.y.at(0), 0.5, 1e-9);
}

// Charts find the kind of a sensor by its short name, so no two models may differ about a name.
TEST(QuantityUnitTest, EverySensorOfEveryModelHasTheUnitOfItsKind) {
  for (const char* const robot : {"ers210", "ers220", "ers7"}) {
    const RobotModel model = LoadRobotModel(fmt::format("{}/{}.json", OPENR_MODEL_DIR, robot));
    for (const Sensor& sensor : model.sensors) {
      if (sensor.kind == SensorKind::kJoint) continue;
      const QuantityUnit unit = UnitOfQuantity("sensor." + sensor.short_name);
      EXPECT_STREQ(unit.text, SiUnitOf(sensor.kind)) << robot << " " << sensor.short_name;
      EXPECT_EQ(unit.factor, *unit.text == '\0' ? 1 : 1e-6) << robot << " " << sensor.short_name;
    }
  }
}

class PlotCommandTest : public testing::Test {
 protected:
  PlotCommandTest() {
    std::string name = (fs::temp_directory_path() / "openr-plot-test-XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr);
    folder_ = name;
  }
  ~PlotCommandTest() override { fs::remove_all(folder_); }

  std::string At(const std::string& name) const { return folder_ / name; }
  static ProgramResult Openr(const std::vector<std::string>& arguments) {
    return ProgramRun(arguments).Finish();
  }
  ProgramResult Run(const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"run",     "--rate",     "max",       "--for",
                                          "2s",      "--no-panel", "--body",    "ideal",
                                          "--stick", OPENR_STICK,  "--console", "/dev/null"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Openr(arguments);
  }
  static std::string Content(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fs::path folder_;
};

TEST_F(PlotCommandTest, LogsAndTheRecordingOfARunGiveOneChart) {
  ASSERT_EQ(Run({"--log-data", At("run.csv"), "--record", At("run.rec")}).status, 0);
  ASSERT_EQ(Run({"--log-data", At("run.mcap")}).status, 0);
  for (const char* const name : {"run.csv", "run.mcap", "run.rec"}) {
    const ProgramResult result =
        Openr({"plot", At(name), "LF_j1,pitch_deg", "-o", At(std::string(name) + ".svg")});
    ASSERT_EQ(result.status, 0) << result.err;
  }
  const auto body = [this](const std::string& name) {  // without the title, which has the name
    std::string svg = Content(At(name));
    return svg.size();
  };
  EXPECT_GT(body("run.csv.svg"), 10'000U);
  const Table csv = ReadCsvTable("run.csv", Content(At("run.csv")));
  const Table mcap = ReadMcapTable("run.mcap", Content(At("run.mcap")));
  const auto find = [](const Table& table, const std::string& name) {
    return *std::find_if(table.series.begin(), table.series.end(),
                         [&](const Series& series) { return series.name == name; });
  };
  for (const char* const name : {"joint.LF_j1", "command.LF_j1", "sensor.chin", "x_m"}) {
    EXPECT_EQ(find(csv, name).values, find(mcap, name).values) << name;
    EXPECT_EQ(find(csv, name).time_s.size(), find(mcap, name).time_s.size()) << name;
  }
  EXPECT_EQ(csv.series.size(), mcap.series.size());
}

TEST_F(PlotCommandTest, ARecordingThatIsCutOffIsReadUpToThereAndNamed) {
  ASSERT_EQ(Run({"--record", At("run.rec")}).status, 0);
  const std::string whole = Content(At("run.rec"));
  std::ofstream(At("cut.rec"), std::ios::binary) << whole.substr(0, whole.size() - 100);
  const ProgramResult result = Openr({"plot", At("cut.rec"), "--list"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, HasSubstr("joint.LF_j1\n"));
  EXPECT_THAT(result.err, HasSubstr("is cut off"));
}

TEST_F(PlotCommandTest, ChartIsAPngWhenItsNameSaysSo) {
  ASSERT_EQ(Run({"--log-data", At("run.csv")}).status, 0);
  ASSERT_EQ(Openr({"plot", At("run.csv"), "sensor.*", "-o", At("a.png")}).status, 0);
  EXPECT_TRUE(Content(At("a.png")).starts_with("\x89PNG"));
}

TEST_F(PlotCommandTest, AFileNamedMcapThatIsNoneIsRefusedAsMcap) {
  std::ofstream(At("bad.mcap")) << "garbage";
  const ProgramResult refused = Openr({"plot", At("bad.mcap"), "-o", At("a.svg")});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("bad.mcap: is no MCAP file\n"));
}

// The names and numbers are those of another program, so they may be of any size.
TEST_F(PlotCommandTest, LongNamesAndNumbersThatHardlyDifferAreDrawn) {
  const std::string long_name(200'000, 'n');
  std::ofstream(At("name.csv")) << "time_s," << long_name << "\n0,1\n1,2\n";
  std::ofstream(At("values.csv")) << "time_s,a\n0,100000000000000000\n1,100000000000000016\n";
  std::ofstream(At("times.csv")) << "time_s,a\n9000000000000,1\n9000000000000.002,2\n";
  std::ofstream(At("large.csv")) << "time_s,a\n0,1e308\n1,-1e308\n2,5\n";
  for (const char* const name : {"name.csv", "values.csv", "times.csv", "large.csv"}) {
    const std::string svg = At(std::string(name) + ".svg");
    const ProgramResult result = Openr({"plot", At(name), "*", "-o", svg});
    EXPECT_EQ(result.status, 0) << name << ": " << result.err;
    EXPECT_EQ(Content(svg).find("nan"), std::string::npos) << name;
  }
}

TEST_F(PlotCommandTest, WrongFilesAndNamesAreRefused) {
  EXPECT_EQ(Openr({"plot", At("none.csv"), "-o", At("a.svg")}).status, 1);
  EXPECT_EQ(Openr({"plot", At("none.csv")}).status, 2);
  EXPECT_EQ(Openr({"plot", At("none.csv"), "-o", At("a.jpg")}).status, 2);
  const ProgramResult run = Run({"--log-data", At("run.txt")});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.err, HasSubstr("ends in .csv or .mcap"));
  EXPECT_FALSE(fs::exists(At("run.txt")));
  EXPECT_EQ(Run({"--log-data", At("none/run.csv")}).status, 2);
}

TEST_F(PlotCommandTest, FullDiskIsToldAndTheRunGoesOnToItsEnd) {
  for (const char* const name : {"full.csv", "full.mcap", "full.json"}) {
    fs::create_symlink("/dev/full", At(name));
    const bool is_timeline = std::string(name).ends_with(".json");
    const ProgramResult run = Run({is_timeline ? "--timeline" : "--log-data", At(name)});
    EXPECT_EQ(run.status, 1) << name;
    EXPECT_THAT(run.err, HasSubstr("cannot be written: No space left on device"));
    EXPECT_THAT(run.err, HasSubstr("ended by time: --for 2s is over"));
  }
}

}  // namespace
}  // namespace openr_host
