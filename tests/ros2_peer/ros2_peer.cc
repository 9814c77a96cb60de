// A plain participant on DDS: Cyclone DDS and the public IDL (distribution/ros2/idl), nothing of
// ours.  What it hears goes to standard output, a line of JSON each.
//
//   ros2_peer DOMAIN topics                     the topics of ROS 2 that somebody else has
//   ros2_peer DOMAIN read TYPE TOPIC N [best|late]
//                                               N samples; best: a best-effort reader; late: one
//                                               that gets what was written before it came
//   ros2_peer DOMAIN command TOPIC JOINT=RAD[@RAD/S]...
//                                               to a reader of JointState, when one is there
//   ros2_peer DOMAIN commands TOPIC MS JOINT=RAD[@RAD/S]...
//                                               the same, a sample for each, MS apart
//   ros2_peer DOMAIN say TOPIC TEXT...          texts to a reader of String, when one is there
//   ros2_peer DOMAIN offer TOPIC                a best-effort writer of JointState, until killed
#include <dds/dds.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "audio_common_msgs.h"
#include "diagnostic_msgs.h"
#include "geometry_msgs.h"
#include "nav_msgs.h"
#include "rosgraph_msgs.h"
#include "sensor_msgs.h"
#include "std_msgs.h"
#include "tf2_msgs.h"

namespace {

constexpr dds_duration_t kPatience = DDS_SECS(60);

[[noreturn]] void Fail(const std::string& what) {
  std::fprintf(stderr, "ros2_peer: %s\n", what.c_str());
  std::exit(1);
}

dds_entity_t Check(dds_entity_t result, const char* what) {
  if (result < 0) Fail(std::string(what) + ": " + dds_strretcode(-result));
  return result;
}

std::string Numbers(const double* values, size_t count) {
  std::string text = "[";
  for (size_t i = 0; i < count; ++i) {
    char number[40];
    std::snprintf(number, sizeof number, "%s%.9g", i == 0 ? "" : ",", values[i]);
    text += number;
  }
  return text + "]";
}

std::string Numbers(const dds_sequence_double& values) {
  return Numbers(values._buffer, values._length);
}

std::string Text(const std::string& text) { return "\"" + text + "\""; }

std::string Stamp(const builtin_interfaces_msg_dds__Time_& time) {
  return std::to_string(int64_t{time.sec_} * 1000000 + time.nanosec_ / 1000);
}

std::string Header(const std_msgs_msg_dds__Header_& header) {
  return "\"stamp_us\":" + Stamp(header.stamp_) + ",\"frame_id\":" + Text(header.frame_id_);
}

std::string JsonOfJointState(const void* sample) {
  const auto& state = *static_cast<const sensor_msgs_msg_dds__JointState_*>(sample);
  std::string names;
  for (uint32_t i = 0; i < state.name_._length; ++i)
    names += (i == 0 ? "" : ",") + Text(state.name_._buffer[i]);
  return "{" + Header(state.header_) + ",\"name\":[" + names +
         "],\"position\":" + Numbers(state.position_) +
         ",\"velocity\":" + Numbers(state.velocity_) + ",\"effort\":" + Numbers(state.effort_) +
         "}";
}

std::string JsonOfImu(const void* sample) {
  const auto& imu = *static_cast<const sensor_msgs_msg_dds__Imu_*>(sample);
  return "{" + Header(imu.header_) +
         ",\"acceleration\":" + Numbers(&imu.linear_acceleration_.x_, 3) +
         ",\"orientation\":" + Numbers(&imu.orientation_.x_, 4) +
         ",\"orientation_covariance\":" + Numbers(imu.orientation_covariance_, 9) +
         ",\"angular_velocity_covariance\":" + Numbers(imu.angular_velocity_covariance_, 9) + "}";
}

// The pixel in the middle of each quarter: those above from the left, those below.
std::string Quarters(const sensor_msgs_msg_dds__Image_& image) {
  std::string text;
  for (const uint32_t y : {image.height_ / 4, image.height_ * 3 / 4}) {
    for (const uint32_t x : {image.width_ / 4, image.width_ * 3 / 4}) {
      const uint8_t* const p = image.data_._buffer + size_t{y} * image.step_ + size_t{x} * 3;
      const double colour[] = {double(p[0]), double(p[1]), double(p[2])};
      text += (text.empty() ? "" : ",") + Numbers(colour, 3);
    }
  }
  return "[" + text + "]";
}

std::string JsonOfImage(const void* sample) {
  const auto& image = *static_cast<const sensor_msgs_msg_dds__Image_*>(sample);
  std::set<uint32_t> colours;
  for (uint32_t i = 0; i + 2 < image.data_._length; i += 3) {
    const uint8_t* const p = image.data_._buffer + i;
    colours.insert(uint32_t{p[0]} << 16 | uint32_t{p[1]} << 8 | p[2]);
  }
  return "{" + Header(image.header_) + ",\"width\":" + std::to_string(image.width_) +
         ",\"height\":" + std::to_string(image.height_) +
         ",\"step\":" + std::to_string(image.step_) + ",\"encoding\":" + Text(image.encoding_) +
         ",\"bytes\":" + std::to_string(image.data_._length) + ",\"quarters\":" + Quarters(image) +
         ",\"colours\":" + std::to_string(colours.size()) + "}";
}

std::string JsonOfClock(const void* sample) {
  return "{\"stamp_us\":" +
         Stamp(static_cast<const rosgraph_msgs_msg_dds__Clock_*>(sample)->clock_) + "}";
}

std::string JsonOfBool(const void* sample) {
  return static_cast<const std_msgs_msg_dds__Bool_*>(sample)->data_ ? "true" : "false";
}

std::string JsonOfFloat(const void* sample) {
  const double value = static_cast<const std_msgs_msg_dds__Float32_*>(sample)->data_;
  return Numbers(&value, 1);
}

std::string JsonOfString(const void* sample) {
  std::string text;
  for (const char* c = static_cast<const std_msgs_msg_dds__String_*>(sample)->data_; *c != 0; ++c)
    text += *c == '\n' ? std::string("\\n") : *c == '"' ? std::string("\\\"") : std::string(1, *c);
  return Text(text);
}

std::string JsonOfOdometry(const void* sample) {
  const auto& odometry = *static_cast<const nav_msgs_msg_dds__Odometry_*>(sample);
  return "{" + Header(odometry.header_) + ",\"child\":" + Text(odometry.child_frame_id_) +
         ",\"position\":" + Numbers(&odometry.pose_.pose_.position_.x_, 3) +
         ",\"orientation\":" + Numbers(&odometry.pose_.pose_.orientation_.x_, 4) +
         ",\"linear\":" + Numbers(&odometry.twist_.twist_.linear_.x_, 3) +
         ",\"angular\":" + Numbers(&odometry.twist_.twist_.angular_.x_, 3) + "}";
}

std::string JsonOfTransforms(const void* sample) {
  const auto& all = *static_cast<const tf2_msgs_msg_dds__TFMessage_*>(sample);
  std::string text;
  for (uint32_t i = 0; i < all.transforms_._length; ++i) {
    const geometry_msgs_msg_dds__TransformStamped_& one = all.transforms_._buffer[i];
    text += (i == 0 ? "{" : ",{") + Header(one.header_) +
            ",\"child\":" + Text(one.child_frame_id_) +
            ",\"translation\":" + Numbers(&one.transform_.translation_.x_, 3) +
            ",\"rotation\":" + Numbers(&one.transform_.rotation_.x_, 4) + "}";
  }
  return "[" + text + "]";
}

std::string JsonOfBattery(const void* sample) {
  const auto& battery = *static_cast<const sensor_msgs_msg_dds__BatteryState_*>(sample);
  const double values[] = {battery.voltage_, battery.current_, battery.temperature_,
                           battery.capacity_, battery.percentage_};
  return "{" + Header(battery.header_) + ",\"values\":" + Numbers(values, 5) +
         ",\"status\":" + std::to_string(battery.power_supply_status_) +
         ",\"present\":" + (battery.present_ ? "true" : "false") + "}";
}

std::string JsonOfTemperature(const void* sample) {
  const auto& temperature = *static_cast<const sensor_msgs_msg_dds__Temperature_*>(sample);
  const double values[] = {temperature.temperature_, temperature.variance_};
  return "{" + Header(temperature.header_) + ",\"values\":" + Numbers(values, 2) + "}";
}

std::string JsonOfSound(const void* sample) {
  const auto& sound = *static_cast<const audio_common_msgs_msg_dds__AudioData_*>(sample);
  int loudest = 0;
  for (uint32_t i = 0; i + 1 < sound.data_._length; i += 2) {
    const auto value =
        static_cast<int16_t>(sound.data_._buffer[i] | sound.data_._buffer[i + 1] << 8);
    loudest = std::max(loudest, std::abs(int{value}));
  }
  return "{\"bytes\":" + std::to_string(sound.data_._length) +
         ",\"loudest\":" + std::to_string(loudest) + "}";
}

std::string JsonOfSoundInfo(const void* sample) {
  const auto& info = *static_cast<const audio_common_msgs_msg_dds__AudioInfo_*>(sample);
  return "{\"channels\":" + std::to_string(info.channels_) +
         ",\"rate\":" + std::to_string(info.sample_rate_) +
         ",\"format\":" + Text(info.sample_format_) + "}";
}

std::string JsonOfDiagnostics(const void* sample) {
  const auto& all = *static_cast<const diagnostic_msgs_msg_dds__DiagnosticArray_*>(sample);
  std::string text;
  for (uint32_t i = 0; i < all.status_._length; ++i) {
    const diagnostic_msgs_msg_dds__DiagnosticStatus_& one = all.status_._buffer[i];
    text += (i == 0 ? "{" : ",{") + std::string("\"name\":") + Text(one.name_) +
            ",\"level\":" + std::to_string(one.level_) + ",\"message\":" + Text(one.message_) +
            ",\"hardware\":" + Text(one.hardware_id_) +
            ",\"values\":" + std::to_string(one.values_._length) + "}";
  }
  return "[" + text + "]";
}

struct Type {
  const dds_topic_descriptor_t* descriptor;
  std::string (*json)(const void* sample);
};

Type TypeOf(const std::string& name) {
  const std::map<std::string, Type> types = {
      {"sensor_msgs/JointState", {&sensor_msgs_msg_dds__JointState__desc, &JsonOfJointState}},
      {"sensor_msgs/Imu", {&sensor_msgs_msg_dds__Imu__desc, &JsonOfImu}},
      {"sensor_msgs/BatteryState", {&sensor_msgs_msg_dds__BatteryState__desc, &JsonOfBattery}},
      {"sensor_msgs/Temperature", {&sensor_msgs_msg_dds__Temperature__desc, &JsonOfTemperature}},
      {"nav_msgs/Odometry", {&nav_msgs_msg_dds__Odometry__desc, &JsonOfOdometry}},
      {"tf2_msgs/TFMessage", {&tf2_msgs_msg_dds__TFMessage__desc, &JsonOfTransforms}},
      {"audio_common_msgs/AudioData", {&audio_common_msgs_msg_dds__AudioData__desc, &JsonOfSound}},
      {"audio_common_msgs/AudioInfo",
       {&audio_common_msgs_msg_dds__AudioInfo__desc, &JsonOfSoundInfo}},
      {"diagnostic_msgs/DiagnosticArray",
       {&diagnostic_msgs_msg_dds__DiagnosticArray__desc, &JsonOfDiagnostics}},
      {"sensor_msgs/Image", {&sensor_msgs_msg_dds__Image__desc, &JsonOfImage}},
      {"rosgraph_msgs/Clock", {&rosgraph_msgs_msg_dds__Clock__desc, &JsonOfClock}},
      {"std_msgs/String", {&std_msgs_msg_dds__String__desc, &JsonOfString}},
      {"std_msgs/Bool", {&std_msgs_msg_dds__Bool__desc, &JsonOfBool}},
      {"std_msgs/Float32", {&std_msgs_msg_dds__Float32__desc, &JsonOfFloat}}};
  const auto found = types.find(name);
  if (found == types.end()) Fail("no type " + name);
  return found->second;
}

dds_qos_t* MakeQos(dds_reliability_kind_t reliability) {
  dds_qos_t* const qos = dds_create_qos();
  dds_qset_reliability(qos, reliability, DDS_SECS(1));
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 10);
  return qos;
}

dds_entity_t TopicOf(dds_entity_t participant, const Type& type, const char* name) {
  return Check(dds_create_topic(participant, type.descriptor, name, nullptr, nullptr), "topic");
}

int Read(dds_entity_t participant, int argc, char** argv) {
  if (argc < 3) Fail("read TYPE TOPIC N [best|late]");
  const Type type = TypeOf(argv[0]);
  const bool is_best = argc > 3 && std::strcmp(argv[3], "best") == 0;
  dds_qos_t* const qos = MakeQos(is_best ? DDS_RELIABILITY_BEST_EFFORT : DDS_RELIABILITY_RELIABLE);
  if (argc > 3 && std::strcmp(argv[3], "late") == 0)
    dds_qset_durability(qos, DDS_DURABILITY_TRANSIENT_LOCAL);
  const dds_entity_t reader = Check(
      dds_create_reader(participant, TopicOf(participant, type, argv[1]), qos, nullptr), "reader");
  const dds_entity_t waitset = dds_create_waitset(participant);
  dds_waitset_attach(waitset, dds_create_readcondition(reader, DDS_ANY_STATE), 0);
  for (int left = std::atoi(argv[2]); left > 0;) {
    if (dds_waitset_wait(waitset, nullptr, 0, kPatience) <= 0)
      Fail(std::string("nothing comes on ") + argv[1]);
    void* sample = nullptr;
    dds_sample_info_t info;
    if (dds_take(reader, &sample, &info, 1, 1) <= 0) continue;
    if (info.valid_data) {
      std::printf("%s\n", type.json(sample).c_str());
      std::fflush(stdout);
      --left;
    }
    dds_return_loan(reader, &sample, 1);
  }
  return 0;
}

// To a reader that is there.
class Commander {
 public:
  Commander(dds_entity_t participant, const char* topic,
            const char* type_name = "sensor_msgs/JointState") {
    dds_qos_t* const qos = MakeQos(DDS_RELIABILITY_RELIABLE);
    const Type type = TypeOf(type_name);
    writer_ = Check(dds_create_writer(participant, TopicOf(participant, type, topic), qos, nullptr),
                    "writer");
    const dds_time_t end = dds_time() + kPatience;
    dds_publication_matched_status_t readers{};
    while (readers.current_count == 0) {
      if (dds_time() > end) Fail(std::string("nobody reads ") + topic);
      dds_sleepfor(DDS_MSECS(10));
      dds_get_publication_matched_status(writer_, &readers);
    }
  }

  void Send(const std::vector<std::string>& words) const {
    std::vector<std::string> names;
    std::vector<double> positions, velocities;
    for (const std::string& word : words) {
      const size_t equals = word.find('='), at = word.find('@');
      names.push_back(word.substr(0, equals));
      if (equals != std::string::npos) positions.push_back(std::atof(word.c_str() + equals + 1));
      if (at != std::string::npos) velocities.push_back(std::atof(word.c_str() + at + 1));
    }
    std::vector<char*> texts;
    for (std::string& name : names) texts.push_back(name.data());
    sensor_msgs_msg_dds__JointState_ sample{};
    char nothing[] = "";
    const auto count = [](const auto& list) { return static_cast<uint32_t>(list.size()); };
    sample.header_.frame_id_ = nothing;
    sample.name_ = {count(texts), count(texts), texts.data(), false};
    sample.position_ = {count(positions), count(positions), positions.data(), false};
    sample.velocity_ = {count(velocities), count(velocities), velocities.data(), false};
    Check(dds_write(writer_, &sample), "write");
  }

  void Say(char* text) const {
    const std_msgs_msg_dds__String_ sample = {text};
    Check(dds_write(writer_, &sample), "write");
  }

  void WaitUntilTaken() const { Check(dds_wait_for_acks(writer_, kPatience), "acknowledgement"); }

 private:
  dds_entity_t writer_ = 0;
};

int Command(dds_entity_t participant, int argc, char** argv) {
  if (argc < 1) Fail("command TOPIC JOINT=RAD[@RAD/S]...");
  const Commander commander(participant, argv[0]);
  commander.Send({argv + 1, argv + argc});
  commander.WaitUntilTaken();
  return 0;
}

int Say(dds_entity_t participant, int argc, char** argv) {
  if (argc < 2) Fail("say TOPIC TEXT...");
  const Commander commander(participant, argv[0], "std_msgs/String");
  for (int i = 1; i < argc; ++i) commander.Say(argv[i]);
  commander.WaitUntilTaken();
  return 0;
}

int Commands(dds_entity_t participant, int argc, char** argv) {
  if (argc < 2) Fail("commands TOPIC MS JOINT=RAD[@RAD/S]...");
  const Commander commander(participant, argv[0]);
  for (int i = 2; i < argc; ++i) {
    commander.Send({argv[i]});
    dds_sleepfor(DDS_MSECS(std::atoi(argv[1])));
  }
  commander.WaitUntilTaken();
  return 0;
}

// Over and over, until it is ended by a signal.
int Stream(dds_entity_t participant, int argc, char** argv) {
  if (argc < 3) Fail("stream TOPIC MS JOINT=RAD[@RAD/S]...");
  const Commander commander(participant, argv[0]);
  for (int i = 2;; i = i + 1 < argc ? i + 1 : 2) {
    commander.Send({argv[i]});
    dds_sleepfor(DDS_MSECS(std::atoi(argv[1])));
  }
}

int Offer(dds_entity_t participant, int argc, char** argv) {
  if (argc < 1) Fail("offer TOPIC");
  dds_qos_t* const qos = MakeQos(DDS_RELIABILITY_BEST_EFFORT);
  const Type type = TypeOf("sensor_msgs/JointState");
  Check(dds_create_writer(participant, TopicOf(participant, type, argv[0]), qos, nullptr),
        "writer");
  dds_sleepfor(kPatience);
  return 0;
}

std::string Line(const char* kind, const dds_builtintopic_endpoint_t& endpoint) {
  dds_reliability_kind_t reliability = DDS_RELIABILITY_BEST_EFFORT;
  dds_durability_kind_t durability = DDS_DURABILITY_VOLATILE;
  dds_qget_reliability(endpoint.qos, &reliability, nullptr);
  dds_qget_durability(endpoint.qos, &durability);
  uint32_t partitions = 0;
  char** names = nullptr;
  dds_qget_partition(endpoint.qos, &partitions, &names);
  std::string partition;
  for (uint32_t i = 0; i < partitions; ++i) partition += names[i];
  uint32_t count = 0;
  dds_data_representation_id_t* representations = nullptr;
  dds_qget_data_representation(endpoint.qos, &count, &representations);
  std::string plain = count == 1 && representations[0] == 0 ? "true" : "false";
  return std::string("{\"kind\":\"") + kind + "\",\"topic\":" + Text(endpoint.topic_name) +
         ",\"type\":" + Text(endpoint.type_name) +
         ",\"reliable\":" + (reliability == DDS_RELIABILITY_RELIABLE ? "true" : "false") +
         ",\"volatile\":" + (durability == DDS_DURABILITY_VOLATILE ? "true" : "false") +
         ",\"partition\":" + Text(partition) + ",\"plain_cdr\":" + plain + "}";
}

// Until nothing new has come for a second after the first.
int Topics(dds_entity_t participant) {
  const std::pair<const char*, dds_entity_t> kinds[] = {
      {"writer",
       dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSPUBLICATION, nullptr, nullptr)},
      {"reader",
       dds_create_reader(participant, DDS_BUILTIN_TOPIC_DCPSSUBSCRIPTION, nullptr, nullptr)}};
  std::set<std::string> lines;
  dds_time_t end = dds_time() + kPatience;
  while (dds_time() < end) {
    for (const auto& [kind, reader] : kinds) {
      void* sample = nullptr;
      dds_sample_info_t info;
      while (dds_take(reader, &sample, &info, 1, 1) > 0) {
        const auto& endpoint = *static_cast<const dds_builtintopic_endpoint_t*>(sample);
        const bool is_new = info.valid_data && std::strncmp(endpoint.topic_name, "rt/", 3) == 0 &&
                            lines.insert(Line(kind, endpoint)).second;
        if (is_new) end = dds_time() + DDS_SECS(1);
        dds_return_loan(reader, &sample, 1);
      }
    }
    dds_sleepfor(DDS_MSECS(20));
  }
  for (const std::string& line : lines) std::printf("%s\n", line.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) Fail("DOMAIN topics | read ... | command ...");
  const dds_entity_t participant = Check(
      dds_create_participant(static_cast<dds_domainid_t>(std::atoi(argv[1])), nullptr, nullptr),
      "participant");
  const std::string what = argv[2];
  int status = 2;
  if (what == "topics") status = Topics(participant);
  if (what == "read") status = Read(participant, argc - 3, argv + 3);
  if (what == "say") status = Say(participant, argc - 3, argv + 3);
  if (what == "offer") status = Offer(participant, argc - 3, argv + 3);
  if (what == "stream") status = Stream(participant, argc - 3, argv + 3);
  if (what == "commands") status = Commands(participant, argc - 3, argv + 3);
  if (what == "command") status = Command(participant, argc - 3, argv + 3);
  dds_delete(participant);
  return status;
}
