// Draws a graph of objects in the language of Graphviz: a rectangle for each object, with its
// observers on the left and its subjects on the right.
#include <fmt/format.h>

#include <map>
#include <optional>

#include "openr/graph/graph_view.h"
#include "runtime/config/service_name.h"

namespace openr_host {
namespace {

constexpr char kHeader[] = R"(digraph openr {
  rankdir=LR; ranksep=1.1; nodesep=0.35; bgcolor="white"; pad=0.2;
  node [shape=plain, fontname="Helvetica,Arial,sans-serif", fontsize=12];
  edge [fontname="Helvetica,Arial,sans-serif", fontsize=9, color="#4a6078", fontcolor="#4a6078",
        arrowsize=0.7];
)";

std::string Escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

// Returns the part of a service's full name that stands in the rectangle of the object: "Move" of
// "RCServer.Move.MoveCommand.S".  The other parts are drawn elsewhere: the name of the object above
// its services, and the type of the data (MoveCommand) beside the connection.
std::string ShortName(const std::string& service) {
  const std::optional<ServiceName> name = ParseServiceName(service, nullptr);
  return name ? name->short_name : service;
}

std::string TypeOf(const std::string& service) {
  const std::optional<ServiceName> name = ParseServiceName(service, nullptr);
  return name ? name->data : "";
}

class DotWriter {
 public:
  explicit DotWriter(const GraphView& graph) : graph_(graph) {
    for (const GraphConnection& wire : graph.connections) {
      ++wires_[{wire.robot, wire.subject}];
      ++wires_[{wire.robot, wire.observer}];
    }
  }

  std::string Write() {
    text_ = kHeader;
    for (size_t i = 0; i < graph_.objects.size(); ++i) AddObject(i);
    for (const GraphConnection& wire : graph_.connections) AddConnection(wire);
    return text_ + "}\n";
  }

 private:
  // Draws an object as a rectangle.  A part of the robot (a system object) gets two rectangles: one
  // on the left with its subjects, one on the right with its observers.  So all connections can run
  // from left to right, although sensor values come from the robot and commands go to it.
  void AddObject(size_t index) {
    const GraphObject& object = graph_.objects[index];
    const std::string node = fmt::format("o{}", index);
    if (!object.is_system) {
      AddNode(node, object, true, true);
      return;
    }
    AddNode(node + "s", object, true, false);
    AddNode(node + "o", object, false, true);
  }

  void AddNode(const std::string& node, const GraphObject& object, bool with_subjects,
               bool with_observers) {
    std::string left, right;
    for (size_t i = 0; i < object.services.size(); ++i) {
      const GraphService& service = object.services[i];
      if (!(service.is_subject ? with_subjects : with_observers)) continue;
      ports_[{object.robot, service.name}] = fmt::format("{}:s{}", node, i);
      // Services without a connection in CONNECT.CFG are not drawn, because they would only make
      // the rectangle of the object larger.
      if (wires_.count({object.robot, service.name}) == 0) continue;
      (service.is_subject ? right : left) +=
          fmt::format("<tr><td port=\"s{}\" align=\"{}\">{}</td></tr>", i,
                      service.is_subject ? "right" : "left", Escaped(ShortName(service.name)));
    }
    if (object.is_system && left.empty() && right.empty()) return;
    const char* const colour = object.is_system ? "#dfe7ee" : "#fff3d6";
    const std::string robot =
        graph_.objects.back().robot > 0 ? fmt::format(" ({})", object.robot) : "";
    text_ += fmt::format(
        "  {} [label=<<table border=\"1\" cellborder=\"0\" cellspacing=\"0\" "
        "cellpadding=\"4\" color=\"#8a8a8a\" bgcolor=\"{}\" style=\"rounded\">"
        "<tr><td colspan=\"2\"><b>{}</b>{}{}</td></tr><hr/>",
        node, colour, Escaped(object.name), robot, StateLine(object));
    text_ += fmt::format(
        "<tr><td valign=\"top\">{}</td><td valign=\"top\">{}</td></tr>"
        "</table>>];\n",
        Column(left), Column(right));
  }

  static std::string StateLine(const GraphObject& object) {
    if (object.state.empty()) return "";
    return fmt::format("<br/><font point-size=\"9\" color=\"#666666\">{}</font>",
                       Escaped(object.state));
  }

  static std::string Column(const std::string& rows) {
    if (rows.empty()) return "";
    return "<table border=\"0\" cellborder=\"0\" cellspacing=\"2\" cellpadding=\"1\">" + rows +
           "</table>";
  }

  void AddConnection(const GraphConnection& wire) {
    const auto subject = ports_.find({wire.robot, wire.subject});
    const auto observer = ports_.find({wire.robot, wire.observer});
    if (subject == ports_.end() || observer == ports_.end()) return;
    std::string label = Escaped(TypeOf(wire.subject));
    if (wire.events > 0) label += fmt::format("\\n{}", wire.events);
    text_ += fmt::format("  {}:e -> {}:w [label=\"{}\"{}];\n", subject->second, observer->second,
                         label, wire.connected ? "" : ", style=dashed, color=\"#c03030\"");
  }

  const GraphView& graph_;
  std::map<std::pair<int, std::string>, int> wires_;
  // The place of each service in the drawing: the rectangle of its object and its row in this
  // rectangle, such as "o1:s2".  The key is the number of the robot and the name of the service.
  std::map<std::pair<int, std::string>, std::string> ports_;
  std::string text_;
};

}  // namespace

std::string GraphToDot(const GraphView& graph) { return DotWriter(graph).Write(); }

}  // namespace openr_host
