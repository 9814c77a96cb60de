// The status of a run as plain data; openr_status.idl describes the fields.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace openr_host {

struct RunStatus {
  struct Times {
    uint64_t count = 0;
    double mean_us = 0;
    double p99_us = 0;
    double max_us = 0;
  };
  struct Process {
    std::string name;
    std::string host;
    int64_t pid = 0;
    std::string lost;
  };
  struct Object {
    int robot = 0;
    std::string name;
    std::string process;
    std::string state;
    int priority = 0;
    uint64_t messages = 0;
    double messages_per_s = 0;
    uint64_t dropped = 0;
    int waiting = 0;
    int waiting_max = 0;
    Times handlers;
  };

  std::string run;
  std::string host;
  int64_t pid = 0;
  bool has_ended = false;
  std::string end;  // reason of the end of the run, from DescribeEnd()
  int64_t virtual_us = 0;
  double wall_s = 0;
  double x_real_time = 0;
  double messages_per_s = 0;
  uint64_t messages = 0;
  int64_t waiting = 0;
  std::vector<Process> processes;
  std::vector<Object> objects;
  uint32_t objects_left_out = 0;
};

}  // namespace openr_host
