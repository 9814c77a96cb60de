// McapLog: writes a run as MCAP, with topics for values, poses, pictures, findings and inputs.
//
// docs/data.md has the topics.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/growing_file.h"
#include "openr/data/columns.h"
#include "openr/data/data_log.h"
#include "openr/data/mcap_writer.h"
#include "virtualrobot/camera/image_source.h"

namespace openr_host {

class McapLog : public DataLog {
 public:
  McapLog(const DataLogOptions& options, Simulation* simulation);
  void Sample() override;
  std::string Finish() override;

 private:
  // A topic of the MCAP file: the values of one robot in one group of quantities, such as "joint".
  struct Values {
    uint16_t channel = 0;
    std::vector<std::string> keys;  // names of the members of the topic's messages, in JSON
    std::vector<size_t> columns;    // index in columns_ of the quantity for each of `keys`
  };
  struct CameraTopic {
    uint16_t channel = 0;
    int64_t last_us = -1;  // virtual time of this camera's last picture; -1: no picture yet
    bool is_broken = false;
  };

  void AddValueTopics();
  void AddScene();
  void AddValues(int64_t now_us);
  void AddPoses(int64_t now_us);
  void AddImages(int64_t now_us);
  void AddFindings();
  void AddText(uint16_t channel, int64_t time_us, int level, const std::string& name,
               const std::string& text);
  std::string Space(size_t robot) const;

  const DataLogOptions options_;
  Simulation* const simulation_;
  SimulationView view_;
  const std::vector<Column> columns_;
  GrowingFile file_;
  McapWriter writer_;
  std::vector<Values> values_;
  // The camera topic of each robot; the index is the number of the robot.
  std::vector<CameraTopic> cameras_;
  uint16_t poses_ = 0, findings_ = 0, inputs_ = 0;
  size_t finding_count_ = 0;  // number of findings that the MCAP file already has
  int64_t last_us_ = -1;      // virtual time of the last values that were written
  int64_t chunk_us_ = 0;      // virtual time at which the last chunk of messages ended
  Picture picture_;
  bool is_finished_ = false;
};

}  // namespace openr_host
