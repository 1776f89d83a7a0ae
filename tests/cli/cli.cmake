# The real program from outside: arguments, exit codes, files, signals, missing drivers, the README.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME cli
  COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/cli_test.py $<TARGET_FILE:bench>
    ${CMAKE_SOURCE_DIR})
