// The graph of a System for people: objects, services, connections.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace openr_host {

class System;

struct GraphService {
  std::string name;  // four-part
  bool is_subject = true;
};

struct GraphObject {
  int robot = 0;
  std::string name;
  std::string path;   // of its image; empty for parts of the system
  std::string state;  // see Object::state
  bool is_system = false;
  std::vector<GraphService> services;  // in order of their names
};

struct GraphConnection {
  int robot = 0;
  std::string subject, observer;  // services
  std::string where;              // "CONNECT.CFG:4"
  bool connected = false;         // false: the line was refused
  uint64_t events = 0;            // sent so far
};

struct GraphView {
  double virtual_time_s = 0;
  std::vector<GraphObject> objects;          // those that have services
  std::vector<GraphConnection> connections;  // in the order of CONNECT.CFG
};

// Call when the system has booted.
GraphView CollectGraph(System* system);

nlohmann::ordered_json GraphToJson(const GraphView& graph);

// In the language of Graphviz.
std::string GraphToDot(const GraphView& graph);

}  // namespace openr_host
