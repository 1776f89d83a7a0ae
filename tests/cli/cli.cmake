# The real program from outside: arguments, exit codes, files, signals, missing drivers, the README.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
foreach(part input measuring samples truth world)
  add_test(NAME cli.${part}
    COMMAND Python3::Interpreter ${CMAKE_CURRENT_LIST_DIR}/${part}_test.py $<TARGET_FILE:bench>
      ${CMAKE_SOURCE_DIR})
  # No compiled Python beside the sources, no truths of tests among the user's. Alone: they measure.
  set_tests_properties(cli.${part} PROPERTIES RUN_SERIAL TRUE ENVIRONMENT
    "PYTHONDONTWRITEBYTECODE=1;XDG_CACHE_HOME=${CMAKE_BINARY_DIR}/test-cache")
endforeach()
