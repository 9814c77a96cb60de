// Finds the files that belong to the program.  They lie at the same places relative to the program
// in the build tree and after installing.
#pragma once

#include <string>

namespace openr_host {

// Returns the folder of the running program.
std::string ProgramFolder();

// Returns the file of the running program.
std::string ProgramFile();

// Returns what a person types to call the program: its name if PATH leads to it, else its file.
std::string ProgramCall();

// Returns the default stick, a folder that holds OPEN-R/.  If there is none, throws
// std::runtime_error that names the places looked at.
std::string DefaultStick();

// Returns the folder with the sources of our objects and, in stub.cfg/, their configuration.
// Throws std::runtime_error if the program was copied to a place without them.
std::string ObjectSources();

// Returns the file of the robot model `name` ("ers210").  If there is no such model, throws
// std::runtime_error that lists the models.
std::string ModelFile(const std::string& name);

// Returns `name` if there is such a file.  Otherwise returns the file of that name that came with
// the program ("ers210.cost"), or `name` if there is none.
std::string DataFile(const std::string& name);

// Returns the path of libopenr_render.so, or only its name, so that the dynamic linker looks for
// it.
std::string RenderLibrary();

}  // namespace openr_host
