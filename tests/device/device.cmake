# The device check from the packed bundle, in an empty environment and for a few seconds: it must
# start, write what it has, and say which steps were cut. On a device it takes minutes.
add_test(NAME device.check
  COMMAND ${CMAKE_CURRENT_LIST_DIR}/check_bundle.sh ${CMAKE_BINARY_DIR} ${CMAKE_COMMAND}
    shadowbench-${PROJECT_VERSION}-x86_64)
set_tests_properties(device.check PROPERTIES RUN_SERIAL TRUE)
