# Tests of the measuring half that need no driver.
target_sources(gpu_tests PRIVATE ${CMAKE_CURRENT_LIST_DIR}/judge_gpu_test.cpp)
target_sources(unit_tests PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/compare_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/gbench_flags_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/group_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/journal_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/light_loop_cells_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/survive_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/protocol_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/samples_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/selection_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/suite_test.cpp)
