# Runs npm ci in the working folder and then makes the file STAMP.
execute_process(COMMAND ${NPM} ci --no-audit --no-fund RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "npm cannot install the packages of the panel's page; is there a network?  "
    "Configure with -DOPENR_PANEL=OFF to build without the panel.")
endif()
file(TOUCH ${STAMP})
