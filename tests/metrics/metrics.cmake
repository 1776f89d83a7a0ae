# Error metrics, by hand and against independent computations.
target_sources(unit_tests PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/blame_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/error_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/exposure_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/flip_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/noise_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/regions_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/weighted_test.cpp)
