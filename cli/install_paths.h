// Finds the files that belong to the program.  Their places relative to the program are the same in
// the build tree and after installing.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// Returns the folder that contains the file of the running program.
std::string ProgramFolder();

// Returns the path of the file of the running program.
std::string ProgramFile();

// Returns the word that calls the program in a shell: its name if PATH leads to it, else its path.
// The path is relative, and so short, if the program is below the working folder.
std::string ProgramCall();

// Returns the default stick, which runs use if the user names none: a folder that holds OPEN-R/.
// If it is missing, throws std::runtime_error that names the places where it was looked for.
std::string DefaultStick();

// Returns the folder with the sources of our objects and, in stub.cfg/, their configuration.
// Throws std::runtime_error if the program was copied to a place without them.
std::string ObjectSources();

// Returns the path of the file that describes the robot model `name` ("ers210").  If there is no
// such model, throws std::runtime_error that lists the models.
std::string ModelFile(const std::string& name);

// Returns the names of the robot models that came with openr, sorted.
std::vector<std::string> ModelNames();

// Returns the file names of the worlds that came with openr ("ramp-and-stairs.json"), sorted.
std::vector<std::string> WorldNames();

// Returns `name` if a file of this name exists.  Otherwise returns the path of the file of this
// name that came with openr ("ers210.cost"), or `name` if openr has no such file.
std::string DataFile(const std::string& name);

// Returns the path of the Python file with which gdb prints data of OPEN-R in a readable form; ""
// if the file does not exist.
std::string GdbPrinters();

// Returns the folder with the built page of the panel (index.html); "" if it is not built.
std::string PanelFolder();

// Returns the path of libopenr_panel.so beside the program.  If this file does not exist, returns
// only its name, so that the dynamic linker looks for it.
std::string PanelLibrary();

// Returns the path of libopenr_controller.so beside the program.  If this file does not exist,
// returns only its name, so that the dynamic linker looks for it.
std::string ControllerLibrary();

// Returns the path of libopenr_render.so beside the program.  If this file does not exist, returns
// only its name, so that the dynamic linker looks for it.
std::string RenderLibrary();

// Returns the path of libopenr_chart.so beside the program.  If this file does not exist, returns
// only its name, so that the dynamic linker looks for it.
std::string ChartLibrary();

}  // namespace openr_host
