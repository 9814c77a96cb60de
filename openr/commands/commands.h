// The commands of the program.  Each AddXxxCommand() adds the command xxx to the command line.  A
// command that the user calls stores its exit code (exit_code.h) in `*exit_code`.
#pragma once

#include <string_view>

namespace CLI {
class App;
}

namespace openr_host {

// Runs the program openr: reads the command line and runs the command in it.  Returns the exit
// code.
int RunProgram(int argc, char** argv);

// Adds the command `wanted`, the first word of the command line, to `app`.  Adds all commands if
// `wanted` is "", is not the name of a command, or is a command that describes the other commands,
// such as "help".  Also prepares the help of `app` and of the added commands.
void DescribeProgram(CLI::App* app, int* exit_code, std::string_view wanted);

void AddRunCommand(CLI::App* app, int* exit_code);
void AddJoinCommand(CLI::App* app, int* exit_code);
void AddTopCommand(CLI::App* app, int* exit_code);
void AddPokeCommand(CLI::App* app, int* exit_code);
void AddAttachCommand(CLI::App* app, int* exit_code);
void AddPanelCommand(CLI::App* app, int* exit_code);
void AddRcCommand(CLI::App* app, int* exit_code);
void AddGraphCommand(CLI::App* app, int* exit_code);
void AddMtnCommand(CLI::App* app, int* exit_code);
void AddPlotCommand(CLI::App* app, int* exit_code);
void AddLogCommand(CLI::App* app, int* exit_code);
void AddTraceCommand(CLI::App* app, int* exit_code);
void AddReplayCommand(CLI::App* app, int* exit_code);
void AddExploreCommand(CLI::App* app, int* exit_code);
void AddBuildCommand(CLI::App* app, int* exit_code);
void AddCoverageCommand(CLI::App* app, int* exit_code);
void AddNewCommand(CLI::App* app, int* exit_code);
void AddEditorCommand(CLI::App* app, int* exit_code);
void AddControllerCommand(CLI::App* app, int* exit_code);
void AddCheckCommand(CLI::App* app, int* exit_code);
void AddEmonCommand(CLI::App* app, int* exit_code);
void AddModelCommand(CLI::App* app, int* exit_code);
void AddStickCommand(CLI::App* app, int* exit_code);
void AddStubgenCommand(CLI::App* app, int* exit_code);
void AddCompletionCommand(CLI::App* app, int* exit_code);
void AddManCommand(CLI::App* app, int* exit_code);
void AddHelpCommand(CLI::App* app, int* exit_code);
void AddVersionCommand(CLI::App* app, int* exit_code);
void AddServeCommand(CLI::App* app, int* exit_code);

}  // namespace openr_host
