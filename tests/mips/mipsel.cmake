# The robot's word size and byte order with Debian's cross compiler.  The R4000 of the robot knows
# the instructions of MIPS II in 32-bit mode, so nothing newer may come out of our sources.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR mipsel)
set(CMAKE_C_COMPILER mipsel-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER mipsel-linux-gnu-g++)
set(CMAKE_C_FLAGS_INIT "-march=mips2")
set(CMAKE_CXX_FLAGS_INIT "-march=mips2")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-mipsel-static)
