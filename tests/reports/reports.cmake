# Tests of reports: statistics, the exact text of every output, results read back, the page's text.
target_sources(unit_tests PRIVATE
  ${CMAKE_CURRENT_LIST_DIR}/cell_id_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/exr_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/figure_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/html_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/html_text_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/json_read_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/output_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/regression_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/sample_run.cpp
  ${CMAKE_CURRENT_LIST_DIR}/stability_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/stats_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/tradeoff_cells.cpp
  ${CMAKE_CURRENT_LIST_DIR}/tradeoff_console_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/tradeoff_fit_test.cpp
  ${CMAKE_CURRENT_LIST_DIR}/tradeoff_test.cpp)
find_package(nlohmann_json REQUIRED)
find_package(tinyexr REQUIRED)
target_link_libraries(unit_tests PRIVATE nlohmann_json::nlohmann_json tinyexr::tinyexr)
