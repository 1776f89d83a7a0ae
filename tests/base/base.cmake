target_sources(unit_tests PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/atomic_file_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/number_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/pattern_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/text_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/worst_test.cpp)
target_link_libraries(unit_tests PRIVATE base)
