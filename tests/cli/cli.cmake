# The real program from outside: arguments, exit codes, files, signals, missing drivers, the README.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
# Poses as a GPU with timestamps that wrap, jump or are not there.
add_library(fake_gpu MODULE ${CMAKE_CURRENT_LIST_DIR}/fake_gpu/fake_gpu.cpp)
set_target_properties(fake_gpu PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/fake_gpu)
configure_file(${CMAKE_CURRENT_LIST_DIR}/fake_gpu/fake_gpu.json
  ${CMAKE_BINARY_DIR}/fake_gpu/fake_gpu.json COPYONLY)
foreach(part input limits measuring outputs samples stability survive technique timer truth
    visibility words world)
  add_test(NAME cli.${part}
    COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/${part}_test.py $<TARGET_FILE:bench>
      ${CMAKE_SOURCE_DIR})
  # No compiled Python beside the sources, no truths of tests among the user's.
  set_tests_properties(cli.${part} PROPERTIES ENVIRONMENT
    "PYTHONDONTWRITEBYTECODE=1;SHADOWBENCH_FAKE_GPU=${CMAKE_BINARY_DIR}/fake_gpu;XDG_CACHE_HOME=${CMAKE_BINARY_DIR}/test-cache")
endforeach()
# What judges times, or asks for fronts of undisturbed ones, does so alone.
set_tests_properties(cli.measuring cli.timer cli.truth PROPERTIES RUN_SERIAL TRUE)
