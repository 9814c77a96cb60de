#include "openr/commands/command_examples.h"

#include <CLI/CLI.hpp>

namespace openr_host {
namespace {

struct Example {
  const char* path;
  const char* line;
};

// The examples of all commands.  A test parses each line as openr would, but does not do the work
// of the command.  So each word, flag and value must be right.
constexpr Example kExamples[] = {
    {"", "openr run                         # the default stick, in real time, with the panel"},
    {"", "openr new Greeter                 # an object of your own; it prints how to go on"},
    {"", "openr help rc mtn play            # every command has a help of its own"},
    {"run", "openr run --for 20s --rate max"},
    {"run", "openr run --stick mystick --for 10s --rate max --json"},
    {"run", "openr run --robot ers7 --world field-2004.json --seed 7"},
    {"run", "openr run --for 5s --rate max --snapshot t=end,view=side -o dog.png"},
    {"run", "openr run --for 1min --record run.trace"},
    {"run", "openr run --for 20s --rate max --log-data run.mcap"},
    {"run", "openr run --stick mystick --rate max --gdb Greeter"},
    {"join", "openr join --process vision --run-name kitchen"},
    {"top", "openr top"},
    {"top", "openr top --once --json"},
    {"poke", "openr poke default press chin for 300ms"},
    {"attach", "openr attach default"},
    {"panel", "openr panel --port 8080"},
    {"rc", "openr rc 127.0.0.1:54000 info"},
    {"rc", "openr rc 127.0.0.1:54000 --json sensors"},
    {"rc info", "openr rc 127.0.0.1:54000 info"},
    {"rc get", "openr rc 127.0.0.1:54000 get neck_pan"},
    {"rc sensors", "openr rc 127.0.0.1:54000 sensors --watch"},
    {"rc stream", "openr rc 127.0.0.1:54000 stream sensors"},
    {"rc move", "openr rc 127.0.0.1:54000 move neck_pan 30"},
    {"rc pose", "openr rc 127.0.0.1:54000 pose neck_pan=30 neck_tilt=-10"},
    {"rc speed", "openr rc 127.0.0.1:54000 speed neck_pan 60"},
    {"rc accel", "openr rc 127.0.0.1:54000 accel neck_pan 500"},
    {"rc motor", "openr rc 127.0.0.1:54000 motor off neck_pan"},
    {"rc gains", "openr rc 127.0.0.1:54000 gains neck_pan 22 4 8"},
    {"rc power", "openr rc 127.0.0.1:54000 power"},
    {"rc led", "openr rc 127.0.0.1:54000 led tail_blue on"},
    {"rc ear", "openr rc 127.0.0.1:54000 ear left on"},
    {"rc follow", "openr rc 127.0.0.1:54000 follow 127.0.0.1:54001"},
    {"rc mtn", "openr rc 127.0.0.1:54000 mtn list"},
    {"rc mtn play", "openr rc 127.0.0.1:54000 mtn play WALK.MTN --loops 5"},
    {"rc mtn stop", "openr rc 127.0.0.1:54000 mtn stop"},
    {"rc mtn list", "openr rc 127.0.0.1:54000 mtn list"},
    {"rc mtn upload", "openr rc 127.0.0.1:54000 mtn upload MINE.MTN"},
    {"rc mtn download", "openr rc 127.0.0.1:54000 mtn download WALK.MTN -o mine.mtn"},
    {"rc mtn delete", "openr rc 127.0.0.1:54000 mtn delete MINE.MTN"},
    {"rc log", "openr rc 127.0.0.1:54000 log walk.log"},
    {"rc camera", "openr rc 127.0.0.1:54000 camera -o eye.ppm --layer h"},
    {"rc controller", "openr rc 127.0.0.1:54000 controller upload CONTROLL.BIN"},
    {"rc controller upload", "openr rc 127.0.0.1:54000 controller upload CONTROLL.BIN"},
    {"rc reboot", "openr rc 127.0.0.1:54000 reboot"},
    {"rc shutdown", "openr rc 127.0.0.1:54000 shutdown"},
    {"graph", "openr graph --stick mystick"},
    {"graph", "openr graph --for 20s --format dot -o graph.dot"},
    {"mtn", "openr mtn info WALK.MTN"},
    {"mtn info", "openr mtn info WALK.MTN"},
    {"mtn check", "openr mtn check --robot ers7 WALK.MTN"},
    {"mtn dump", "openr mtn dump WALK.MTN"},
    {"mtn from-csv", "openr mtn from-csv walk.csv -o MINE.MTN --like WALK.MTN"},
    {"mtn plot", "openr mtn plot WALK.MTN -o walk.svg"},
    {"mtn oda", "openr mtn oda list MOTION.ODA"},
    {"mtn oda list", "openr mtn oda list MOTION.ODA"},
    {"mtn oda unpack", "openr mtn oda unpack MOTION.ODA -o motions"},
    {"log", "openr log info walk.log"},
    {"log info", "openr log info walk.log"},
    {"log csv", "openr log csv walk.log"},
    {"log plot", "openr log plot walk.log -o walk.svg"},
    {"log compare", "openr log compare walk.log --motion WALK.MTN"},
    {"plot", "openr plot run.csv --list"},
    {"plot", "openr plot run.mcap neck_pan,neck_tilt -o neck.svg"},
    {"trace", "openr trace run.trace --object JointMover --until 1s"},
    {"trace", "openr trace run.trace --format perfetto"},
    {"replay", "openr replay run.trace"},
    {"replay", "openr replay run.trace --step"},
    {"replay", "openr replay run.trace --continue-at 12s --record next.trace"},
    {"replay", "openr replay run.trace --only JointMover"},
    {"explore", "openr explore --runs 1000 --property default"},
    {"explore", "openr explore --stick mystick --for 5s -o failure.order"},
    {"build", "openr build Greeter"},
    {"build", "openr build Greeter -o mystick"},
    {"build", "openr build Greeter --sanitize"},
    {"coverage", "openr coverage Greeter"},
    {"coverage", "openr coverage Greeter --lcov greeter.info"},
    {"new", "openr new Greeter"},
    {"editor", "openr editor Greeter"},
    {"editor", "openr editor wag"},
    {"controller", "openr controller new wag"},
    {"controller", "openr controller build wag"},
    {"controller build", "openr controller build wag -o mystick"},
    {"controller run", "openr controller run wag 127.0.0.1:54000"},
    {"controller new", "openr controller new wag"},
    {"check", "openr check Greeter"},
    {"check", "openr check mystick --json"},
    {"emon", "openr emon EMON.LOG"},
    {"emon", "openr emon EMON.LOG --image dancer.nosnap.elf"},
    {"model", "openr model check ers210"},
    {"model check", "openr model check ers210 --json"},
    {"model measure", "openr model measure ers210 --servo steps.svg"},
    {"model show", "openr model show ers7"},
    {"model urdf", "openr model urdf ers210 -o ers210.urdf"},
    {"stick", "openr stick host -o mystick"},
    {"stick host", "openr stick host -o mystick"},
    {"stick robot", "openr stick robot --controller wag --robot ers210 -o robotstick"},
    {"stick check", "openr stick check mystick --robot ers210"},
    {"stick new", "openr stick new -o newstick CONTROLL.BIN --essid kitchen --no-wep --dhcp"},
    {"stick wlan", "openr stick wlan mystick                 # asks"},
    {"stick wlan",
     "openr stick wlan mystick --essid kitchen --wep-key abcde --ip 192.168.1.5 "
     "--gateway 192.168.1.1"},
    {"stubgen", "openr stubgen stub.cfg -o generated"},
    {"serve", "openr serve --describe"},
    {"help", "openr help rc mtn play"},
    {"version", "openr version"},
    {"completion", "openr completion bash >~/.local/share/bash-completion/completions/openr"},
    {"man", "openr man -o man1"},
};

void AddBelow(CLI::App* command, const std::string& path) {
  std::string text = command->get_footer();
  const std::vector<std::string> lines = ExamplesOf(path);
  if (!lines.empty()) text += (text.empty() ? "" : "\n") + std::string("Examples:");
  for (const std::string& line : lines) text += "\n  " + line;
  command->footer(text);
  for (CLI::App* const below : command->get_subcommands({}))
    AddBelow(below, path.empty() ? below->get_name() : path + " " + below->get_name());
}

}  // namespace

std::vector<std::string> ExamplesOf(const std::string& path) {
  std::vector<std::string> lines;
  for (const Example& example : kExamples)
    if (path == example.path) lines.emplace_back(example.line);
  return lines;
}

void AddExamples(CLI::App* app) { AddBelow(app, ""); }

}  // namespace openr_host
