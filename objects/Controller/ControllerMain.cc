#include "ControllerMain.h"

// The build compiles a controller with -Dmain=controller_main.  From C that is one symbol; from C++
// its name depends on its arguments, so all of them are asked for and the one that is there is
// called.  They are weak: a controller without a main function links, too.
extern "C" int controller_main(int argc, char** argv) __attribute__((weak));
int ControllerMainOfCxx() __asm__("_Z15controller_mainv") __attribute__((weak));
int ControllerMainOfCxx(int argc, char** argv) __asm__("_Z15controller_mainiPPc")
    __attribute__((weak));
int ControllerMainOfCxx(int argc, const char** argv) __asm__("_Z15controller_mainiPPKc")
    __attribute__((weak));

int
CallControllerMain()
{
    static char name[] = "controller";
    static char* arguments[] = { name, 0 };
    int (*const withArguments)(int, char**) = ControllerMainOfCxx;
    int (*const withConstant)(int, const char**) = ControllerMainOfCxx;
    int (*const withoutArguments)() = ControllerMainOfCxx;
    if (controller_main != 0) return controller_main(1, arguments);
    if (withArguments != 0) return withArguments(1, arguments);
    if (withConstant != 0) return withConstant(1, const_cast<const char**>(arguments));
    if (withoutArguments != 0) return withoutArguments();
    return 0;
}
