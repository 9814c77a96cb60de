# Assembles the SDK tree (kit/sdk_paths.h):
#   cmake -DSDK=folder to fill -DSOURCE=this source tree -DIMAGES=folder of images
#         -DCONTROLLER=controller.o -P MakeSdkTree.cmake
# Links are relative to the tree's place, PREFIX/share/openr-host/sdk, so it can be installed as it is.
cmake_minimum_required(VERSION 3.25)

# link(TARGET NAME): unless it is there already; a new link would look like a new tool to make.
function(link target name)
  if(NOT IS_SYMLINK ${name})
    file(CREATE_LINK ${target} ${name} SYMBOLIC)
  endif()
endfunction()

# copy_folder(FROM TO): copies the headers of FROM, and removes others from TO, because a header that
# is gone from the source would still be found by programs that are built with the tree.
function(copy_folder from to)
  file(GLOB_RECURSE files RELATIVE ${from} ${from}/*.h)
  foreach(file ${files})
    get_filename_component(folder ${to}/${file} DIRECTORY)
    file(MAKE_DIRECTORY ${folder})
    file(COPY_FILE ${from}/${file} ${to}/${file} ONLY_IF_DIFFERENT)
  endforeach()
  file(GLOB_RECURSE there RELATIVE ${to} ${to}/*.h)  # does not follow links such as include/R4000
  foreach(file ${there})
    if(NOT file IN_LIST files)
      file(REMOVE ${to}/${file})
    endif()
  endforeach()
endfunction()

file(MAKE_DIRECTORY ${SDK}/bin ${SDK}/OPEN_R/bin ${SDK}/OPEN_R/lib ${SDK}/compat ${SDK}/images)
foreach(tool gcc g++ c++ cc cpp ar as ld nm objcopy objdump ranlib readelf size strings strip c++filt
        addr2line)
  link(../../../../bin/openr-sdk ${SDK}/bin/mipsel-linux-${tool})
endforeach()
foreach(tool mkbin gensnap gzcp)
  link(../../../../../bin/openr-sdk ${SDK}/OPEN_R/bin/${tool})
endforeach()
link(../../../../../bin/stubgen2 ${SDK}/OPEN_R/bin/stubgen2)

copy_folder(${SOURCE}/runtime/include ${SDK}/OPEN_R/include)
copy_folder(${SOURCE}/runtime/compat ${SDK}/compat)
foreach(name R4000 MCOOP)  # the SDK spreads its headers over these
  link(. ${SDK}/OPEN_R/include/${name})
endforeach()

# The libraries of the core reference, section 5.5, and of the network samples.  The runtime is
# what is in them.
foreach(library ObjectComm OPENR Internet antMCOOP apsys OFSpub mcoopstub nosys c-)
  set(archive ${SDK}/OPEN_R/lib/lib${library}.a)
  if(NOT EXISTS ${archive})
    file(WRITE ${archive} "!<arch>\n")
  endif()
endforeach()

# The base of a Memory Stick, which some Makefiles copy.  Nothing of it is needed on the host.
foreach(model MS_ERS200 MS_ERS7)
  foreach(flavour BASIC WLAN WCONSOLE)
    foreach(protection memprot nomemprot)
      file(MAKE_DIRECTORY ${SDK}/OPEN_R/${model}/${flavour}/${protection}/OPEN-R/MW/CONF
        ${SDK}/OPEN_R/${model}/${flavour}/${protection}/OPEN-R/MW/OBJS
        ${SDK}/OPEN_R/${model}/${flavour}/${protection}/OPEN-R/MW/DATA/P
        ${SDK}/OPEN_R/${model}/${flavour}/${protection}/OPEN-R/SYSTEM/CONF)
    endforeach()
  endforeach()
endforeach()

file(COPY_FILE ${SOURCE}/cmake/compile-flags.txt ${SDK}/compile-flags.txt ONLY_IF_DIFFERENT)
# Handles the pause button and the battery; programs often rely on one that lies elsewhere.
file(COPY_FILE ${IMAGES}/POWERMON.BIN ${SDK}/images/POWERMON.BIN ONLY_IF_DIFFERENT)

# The object that a controller is compiled into, and the headers that a controller includes.
copy_folder(${SOURCE}/objects/Controller/include ${SDK}/controller/include)
foreach(file ${CONTROLLER} ${SOURCE}/objects/Controller/Controller.ocf
        ${SOURCE}/kit/controller/Makefile.openr)
  get_filename_component(name ${file} NAME)
  file(COPY_FILE ${file} ${SDK}/controller/${name} ONLY_IF_DIFFERENT)
endforeach()
