# Techniques: their rules and invariants on the drivers, their passes and numbers without.
target_sources(gpu_tests PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/cell.cpp
  ${CMAKE_CURRENT_LIST_DIR}/shapes.cpp
  ${CMAKE_CURRENT_LIST_DIR}/tracer.cpp
  ${CMAKE_CURRENT_LIST_DIR}/filter_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/shadow_map_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/cssm2_expectation_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/cssm2_rule_test.cpp)
target_link_libraries(gpu_tests PRIVATE reports)
